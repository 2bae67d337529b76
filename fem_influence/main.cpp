#include "bem_contact/base/argument_error.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/message_file.hpp"
#include "bem_contact/base/printable.hpp"
#include "bem_contact/base/program.hpp"
#include "bem_contact/base/provenance.hpp"
#include "bem_contact/base/said_by.hpp"
#include "bem_contact/base/temporary_folder.hpp"
#include "bem_contact/profile/message_sink.hpp"
#include "fem_influence/commands.hpp"
#include "fem_influence/shared/parallel.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <mpi.h>

#include <dlfcn.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>

namespace {

using namespace bem_contact;

/// Processes share the wavenumbers, so threads of OpenBLAS would only disturb them. The function is looked up
/// at run time, because it is not part of the BLAS interface that this program is linked with.
void use_one_blas_thread() {
  using Setter = void (*)(int);
  if (const auto set = reinterpret_cast<Setter>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads")))
    set(1);
}

/// What OpenMPI shall use, where the user has not chosen otherwise.
///
/// It searches for UCX at the start, which takes 0.2 s and only serves networks: not if all processes are on
/// one machine. And OpenMPI 4.1 cannot make a window of processes on several machines by UCX ("invalid
/// window"), with which we count the wavenumbers; its other ways can.
void choose_transport() {
  ::setenv("OMPI_MCA_osc", "^ucx", 0);
  const char *all = std::getenv("OMPI_COMM_WORLD_SIZE"), *here = std::getenv("OMPI_COMM_WORLD_LOCAL_SIZE");
  if ((!all && !here) || (all && here && std::string_view(all) == here))
    ::setenv("OMPI_MCA_pml", "ob1", 0);
}

/// A process alone makes OpenMPI's folder of sessions itself, and OpenMPI leaves it behind at Ctrl-C. Ours is
/// removed (base/temporary_folder.hpp), with what is in it; mpirun removes its own.
std::unique_ptr<TemporaryFolder> folder_of_sessions() {
  if (std::getenv("OMPI_COMM_WORLD_SIZE") || std::getenv("PMIX_RANK"))
    return nullptr;
  auto folder = std::make_unique<TemporaryFolder>();
  ::setenv("TMPDIR", folder->path().c_str(), 1);
  return folder;
}

constexpr const char* description =
    R"(Computes the influence functions of a wheel or rail: how its surface moves under tractions on it.

Mesh the cross-section of a body, then compute on two processes (from the repository's folder):

    mesh_body data/bodies/small_rail.toml -o rail.msh
    mpirun -n 2 fem_influence data/bodies/small_rail.toml rail.msh -o rail.h5

You should see a progress bar over 39 wavenumbers, and after some seconds four lines: what was solved,
how long it took, two checks, both below 1e-6 (Maxwell-Betti: the numbers are symmetric; reaction: the support
bears the load), and the estimated error: 2.0e-03 of the number of a loaded element on itself. A run that was
stopped goes on when you give the same command again.

With --solid the mesh is 3-D (from mesh_body --solid, or your own). This compares the two methods:

    mesh_body data/bodies/small_rail.toml --solid -o rail3d.msh
    fem_influence data/bodies/small_rail.toml rail3d.msh --solid --check rail.h5

You should see how much the two differ, by distance from the load, in percent of the number of the loaded
element on itself: less than 0.1 %. It takes a minute or two and 3.5 GB of memory.)";

struct Arguments {
  std::string body, mesh;
  bool solid = false;
  fem::StressOptions stresses;
  fem::SolidOptions options;
};

void add_options(CLI::App& app, Arguments& arguments) {
  app.set_version_flag("--version", provenance("fem_influence"));
  app.add_option("body", arguments.body, "Body file (TOML), the one mesh_body read")->required();
  app.add_option("mesh", arguments.mesh,
                 "Mesh of the cross-section (gmsh .msh); with --solid of the 3-D body")
      ->required();
  add_output_option(app, "-o,--output", arguments.options.output, "Influence file to write (.h5)");
  app.add_flag("--solid", arguments.solid, "The mesh is 3-D: half of the body in hexahedra");
  app.add_option("--check", arguments.options.check,
                 "With --solid: influence file of the same body to compare with (.h5)");
  app.add_option(
         "--load-station", arguments.options.load_stations,
         "With --check or --vtu: stations to load, the points of the strip, counted from 0: 12 or 12,40 "
         "(default: the middle one)")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("--load-component", arguments.options.component,
                 "With --vtu: component of the load, 0 = x, 1 = s, 2 = n (default)")
      ->check(CLI::Range(0, 2));
  add_output_option(app, "--vtu", arguments.options.vtu,
                    "With --solid: displacement field of the first loaded station, for ParaView (.vtu)");
  add_output_option(app, "--stresses", arguments.stresses.outputs,
                    "Write the stresses below a contact, with those of a half-space beside them (.h5; .csv; "
                    ".vtu for ParaView)")
      ->allow_extra_args(false);
  app.add_option(
         "--result", arguments.stresses.results,
         "With --stresses: what bem_contact solve -o wrote; its tractions load the body. Both may be given "
         "again, pair by pair: many results in one run take a fraction of the time")
      ->allow_extra_args(false);
  app.add_option("--points", arguments.stresses.points,
                 "With --stresses: points of your own, a CSV file with s,depth (mm)");
  app.add_option(
         "--ellipse", arguments.stresses.ellipse,
         "With --stresses, in place of --result: a Hertz contact that slips; arc length of the middle, "
         "semi-axes along x and s (mm), largest pressure (MPa), friction")
      ->expected(5);
  app.footer("Exit code 0: done; 2: wrong input; 1: anything else. More: fem_influence/README.md.");
}

void compute(const Arguments& arguments) {
  const fem::SolidOptions& options = arguments.options;
  const fem::StressOptions& stresses = arguments.stresses;
  if (!stresses.outputs.empty() || !stresses.ellipse.empty() || !stresses.results.empty() ||
      !stresses.points.empty()) {
    const std::size_t loads = stresses.ellipse.empty() ? stresses.results.size() : 1;
    if (arguments.solid || loads == 0 || stresses.outputs.size() != loads ||
        stresses.ellipse.empty() == stresses.results.empty() || !options.output.empty())
      throw InputError("Stresses need a mesh of the section, and a load for each output",
                       "--stresses belongs to --result or to --ellipse, and to neither -o nor --solid",
                       "Give --stresses OUT.h5 --result RESULT.h5.");
    if (fem::process_rank() == 0) // one process does it all
      fem::stress_command(arguments.body, arguments.mesh, stresses);
  } else if (arguments.solid) {
    if (fem::process_rank() == 0) // one process does it all
      fem::solid_command(arguments.body, arguments.mesh, options);
  } else if (options.output.empty() || !options.check.empty() || !options.vtu.empty() ||
             !options.load_stations.empty()) {
    throw InputError(options.output.empty() ? "There is no file to write"
                                            : "The mesh of a section serves -o alone",
                     "--check, --load-station and --vtu belong to 3-D meshes",
                     "Give -o OUT.h5, or --solid with a 3-D mesh.");
  } else {
    fem::harmonic_command(arguments.body, arguments.mesh, options.output);
  }
}

int run_program(int argc, char** argv) {
  CLI::App app{description, "fem_influence"};
  Arguments arguments;
  add_options(app, arguments);
  // Before MPI starts, so that --help and misspelt options need no MPI.
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return exit_code_of(app, error);
  } catch (const InputError& error) {
    say_error(error.what());
    return 2;
  }

  use_one_blas_thread();
  choose_transport();
  const std::unique_ptr<TemporaryFolder> sessions = folder_of_sessions();
  MPI_Init(&argc, &argv);
  const auto messages = install_message_sink();
  if (fem::process_rank() != 0)
    messages->set_level(
        spdlog::level::off); // each process reads the same profile; errors do not come this way
  int code = 0;
  try {
    compute(arguments);
  } catch (const fem::OtherProcessFailed&) {
    code = 2;
  } catch (const InputError& error) {
    say_error(error.what());
    code = 2;
  } catch (const std::exception& error) {
    say_error(said_by(error));
    code = 1;
  }
  MPI_Finalize();
  return code;
}

} // namespace

int main(int argc, char** argv) {
  begin_program(argv);
  return checked_exit_code(run_program(argc, argv));
}
