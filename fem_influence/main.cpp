#include "bem_contact/base/error.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/progress.hpp"
#include "bem_contact/influence/expand.hpp"
#include "bem_contact/influence/influence_file.hpp"
#include "bem_contact/influence/requirements.hpp"
#include "bem_contact/profile/body_file.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "fem_influence/harmonic/run.hpp"
#include "fem_influence/shared/parallel.hpp"
#include "fem_influence/shared/strip.hpp"
#include "fem_influence/solid/solid_check.hpp"
#include "fem_influence/solid/solid_file.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <mpi.h>

#include <dlfcn.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <numeric>
#include <optional>
#include <sstream>
#include <string_view>
#include <vector>

namespace {

using namespace bem_contact;

/// Processes share the wavenumbers, and threads of OpenBLAS would only get in their way. Looked up at run
/// time: the library's name is not part of the BLAS interface this program is linked with.
void use_one_blas_thread() {
  using Setter = void (*)(int);
  if (const auto set = reinterpret_cast<Setter>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads")))
    set(1);
}

/// OpenMPI's start looks .2 s for UCX, which only serves networks: not where all processes are on one machine
/// and nobody asked for it.
void start_quickly_on_one_machine() {
  const char *all = std::getenv("OMPI_COMM_WORLD_SIZE"), *here = std::getenv("OMPI_COMM_WORLD_LOCAL_SIZE");
  if ((!all && !here) || (all && here && std::string_view(all) == here))
    ::setenv("OMPI_MCA_pml", "ob1", 0);
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

struct SolidArguments {
  bool solid = false;
  std::string check, loads, vtu;
  int component = component_n;
};

std::vector<int> station_numbers(const std::string& text, std::size_t stations) {
  std::vector<int> numbers;
  if (text.empty())
    return {static_cast<int>(stations / 2)};
  std::istringstream in(text);
  for (std::string word; std::getline(in, word, ',');)
    try {
      std::size_t end = 0;
      numbers.push_back(std::stoi(word, &end));
      if (end != word.size())
        throw std::invalid_argument(word);
    } catch (const std::logic_error&) {
      throw InputError("'" + text + "' is no list of stations", "'" + word + "' is no whole number",
                       "give --load-station as in 12 or 12,40,66");
    }
  return numbers;
}

void print_check(const std::vector<fem::SolidDifference>& bands) {
  constexpr const char* name = "xsn";
  fmt::print("{:<16}{:>9}  largest of self and of local, %; then each component of local, %\n", "distance",
             "elements");
  for (const auto& band : bands) {
    if (band.elements == 0)
      continue;
    double self = 0, local = 0;
    std::string each;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        self = std::max(self, band.of_self[i][j]);
        local = std::max(local, band.of_local[i][j]);
        each += fmt::format(" {}{} {:.3f}", name[i], name[j], 100 * band.of_local[i][j]);
      }
    fmt::print("{:<16}{:>9}  {:.3f} {:.3f} {}\n",
               band.up_to == 0 ? "loaded element" : fmt::format("to {} mm", band.up_to), band.elements,
               100 * self, 100 * local, each);
  }
}

void run_solid(const std::string& body_file, const std::string& mesh, const std::string& output,
               const SolidArguments& arguments) {
  if (fem::process_rank() != 0) // one process does it all
    return;
  const BodyFile body = read_body_file(body_file);
  for (const std::string& file : {output, arguments.vtu})
    refuse_overwriting(file, std::array<std::filesystem::path, 3>{body_file, mesh, arguments.check});
  if (output.empty() && arguments.check.empty() && arguments.vtu.empty())
    throw InputError("There is nothing to do with the 3-D numbers", "they would be computed and forgotten",
                     "give -o OUT.h5, --check INFLUENCE.h5 or --vtu FIELD.vtu");
  for (const std::string& file : {output, arguments.vtu})
    if (!file.empty())
      fem::require_writable(file);
  const ProfileCurve curve = body_profile(body);
  fem::require_mesh_of(body, curve, mesh);
  const std::size_t stations = fem::make_stations(body.strip, curve).size();
  const std::vector<int> chosen = station_numbers(arguments.loads, stations);
  std::vector<int> loads = chosen;
  if (!output.empty()) { // a file needs them all
    loads.resize(stations);
    std::iota(loads.begin(), loads.end(), 0);
  }
  std::optional<Progress> bar;
  std::size_t shown = 0;
  fem::SolidReport report;
  const fem::SolidNumbers numbers = fem::solid_numbers(body, curve, mesh, loads, report,
                                                       {arguments.vtu, chosen.front(), arguments.component},
                                                       [&](std::size_t done, std::size_t all) {
                                                         if (!bar)
                                                           bar.emplace("loaded stations", all);
                                                         bar->step(done - shown);
                                                         shown = done;
                                                         if (done == all)
                                                           bar->finish();
                                                       });
  fmt::print(stderr, "{}: {} cells, {} unknowns, {:.1f} s, {:.2f} GiB, Maxwell-Betti {:.1e}\n", mesh,
             report.cells, report.unknowns, report.seconds, report.peak_memory, report.betti_error);
  if (!arguments.vtu.empty())
    fmt::print(stderr, "{}: field displacement_mm under 1 MPa along {} on station {}, half of the body\n",
               arguments.vtu, "xsn"[arguments.component], chosen.front());
  if (!output.empty()) {
    InfluenceFunction function = fem::as_table(body, curve, numbers, report);
    function.estimated_error = fem::mesh_error(body, curve, mesh, numbers);
    write_influence_file(output, function);
    fmt::print(stderr, "{}: table of {} offsets, Maxwell-Betti between meshes {:.1e}, estimated error {}\n",
               output, numbers.offsets, function.betti_error,
               function.estimated_error < 0 ? "none" : fmt::format("{:.1e}", function.estimated_error));
  }
  if (!arguments.check.empty()) {
    const InfluenceFunction function = read_influence_file(arguments.check);
    require_profile(function, curve.name(), curve.digest());
    require_material(function, body.material);
    const InfluenceNumbers reference =
        expand(function,
               {.dx = numbers.dx, .offsets = numbers.offsets, .structural = StructuralCompliance::included});
    for (const bool removed : {false, true}) {
      fmt::print("{}\n", removed ? "rigid motion of the differences removed:" : "as computed:");
      print_check(fem::compare(numbers, reference, function.reference_radius, removed));
    }
  }
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
  app.add_option("-o,--output", output, "Influence file to write (.h5)");
  SolidArguments solid;
  app.add_flag("--solid", solid.solid, "The mesh is 3-D (mesh_body --solid, or your own)");
  app.add_option("--check", solid.check, "Influence file of the same body to compare the 3-D numbers with");
  app.add_option(
      "--load-station", solid.loads,
      "Stations to load, from 0, as in 12 or 12,40 (with --check and --vtu; default: the middle one)");
  app.add_option("--load-component", solid.component, "Component of the load: 0 = x, 1 = s, 2 = n (default)")
      ->check(CLI::Range(0, 2));
  app.add_option("--vtu", solid.vtu, "Displacement field of one load for ParaView (.vtu)");
  // Before MPI starts, so that --help and misspelt options need no MPI.
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }

  use_one_blas_thread();
  start_quickly_on_one_machine();
  MPI_Init(&argc, &argv);
  int code = 0;
  try {
    if (solid.solid)
      run_solid(body_file, mesh, output, solid);
    else if (output.empty() || !solid.check.empty() || !solid.vtu.empty() || !solid.loads.empty())
      throw InputError(output.empty() ? "There is no file to write" : "The mesh of a section serves -o alone",
                       "--check, --load-station and --vtu belong to 3-D meshes",
                       "give -o OUT.h5, or --solid with a 3-D mesh");
    else
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
