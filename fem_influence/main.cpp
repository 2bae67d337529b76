#include "bem_contact/base/body_file.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/progress.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "fem_influence/parallel.hpp"
#include "fem_influence/run.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <mpi.h>

#include <dlfcn.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>

namespace {

using namespace bem_contact;

/// Processes share the wavenumbers, and threads of OpenBLAS would only get in their way. Looked up at run
/// time: the library's name is not part of the BLAS interface this program is linked with.
void use_one_blas_thread() {
  using Setter = void (*)(int);
  if (const auto set = reinterpret_cast<Setter>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads")))
    set(1);
}

void print(const fem::RunReport& report, const std::string& output) {
  fmt::print(
      stderr,
      "{}: {} stations, {} wavenumbers and {} of the companion ({} from an earlier run), {} cells, {} "
      "unknowns\n"
      "  {:.1f} s on {} process(es), at most {:.2f} GiB each; all processes together: assembly {:.1f} s, "
      "analysis {:.1f} s, factors and kernel {:.1f} s\n"
      "  Maxwell-Betti {:.1e}, reaction {:.1e}, smallest eigenvalue {:.1e} of the largest self number\n",
      output, report.stations, report.wavenumbers, report.companion_wavenumbers, report.resumed, report.cells,
      report.unknowns, report.seconds, fem::process_count(), report.peak_memory, report.timing.assembly,
      report.timing.analysis, report.timing.factorization, report.betti_error, report.reaction_error,
      report.smallest_eigenvalue);
  if (report.companion_wavenumbers > 0)
    fmt::print(stderr, "  estimated error {:.1e} of the number itself (mesh {:.1e}, wavenumbers {:.1e})\n",
               report.error.total, report.error.mesh, report.error.samples);
  else
    fmt::print(stderr, "  the error was not estimated (degree 1 has no companion)\n");
}

void run(const std::string& body_file, const std::string& mesh, const std::string& output) {
  std::optional<BodyFile> body;
  std::optional<ProfileCurve> curve;
  fem::together([&] {
    body = read_body_file(body_file);
    refuse_overwriting(output, std::array<std::filesystem::path, 2>{body_file, mesh});
    curve = body_profile(*body);
  });
  const auto stations = std::lround((body->strip.to - body->strip.from) / body->strip.station_width);
  std::optional<Progress> bar;
  std::size_t shown = 0;
  const auto progress = [&](std::size_t done, std::size_t all) {
    if (!bar)
      bar.emplace(fmt::format("{} stations, wavenumbers", stations), all);
    bar->step(done - shown);
    shown = done;
    if (done == all)
      bar->finish();
  };
  const fem::RunReport report = fem::run_harmonic(*body, *curve, mesh, output, progress);
  if (fem::process_rank() == 0)
    print(report, output);
}

} // namespace

int main(int argc, char** argv) {
  CLI::App app{
      "Computes a body's influence functions on the mesh of its cross-section (deal.II, MUMPS) and "
      "writes them to HDF5. Parallel over wavenumbers: mpirun -n 2 fem_influence ...; a run that was "
      "stopped goes on where it was."};
  std::string body_file, mesh, output;
  app.add_option("body", body_file, "Body file (TOML), the one mesh_body read")->required();
  app.add_option("mesh", mesh, "Mesh of the cross-section (gmsh .msh)")->required();
  app.add_option("-o,--output", output, "Influence file to write (.h5)")->required();
  // Before MPI starts, so that --help and misspelt options need no MPI.
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }

  use_one_blas_thread();
  MPI_Init(&argc, &argv);
  int code = 0;
  try {
    run(body_file, mesh, output);
  } catch (const fem::FellowFailed&) {
    code = 2;
  } catch (const InputError& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    code = 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    code = 1;
  }
  MPI_Finalize();
  return code;
}
