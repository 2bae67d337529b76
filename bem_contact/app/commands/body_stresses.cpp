#include "bem_contact/app/commands/body_stresses.hpp"

#include "bem_contact/base/child_process.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/temporary_folder.hpp"
#include "bem_contact/base/told_program.hpp"
#include "bem_contact/record/hdf5.hpp"

#include <fmt/format.h>
#include <vector>

namespace bem_contact::app {

namespace {

void run(const char* program, std::vector<std::string> arguments, const std::filesystem::path& body,
         const TemporaryFolder& folder) {
  const std::filesystem::path file = program_named(program);
  if (file.empty())
    throw InputError("Stresses inside a body cannot be computed here",
                     fmt::format("the program {} is neither beside bem_contact nor on PATH", program),
                     "Build the preset full, after tools/install_packages full.");
  arguments.insert(arguments.begin(), file.string());
  if (const std::string why = run_told_program(std::move(arguments), folder.path()); !why.empty())
    throw InputError(fmt::format("There are no stresses inside '{}'", body.string()), why,
                     "Correct the body file, or leave it out for those of a half-space.");
}

} // namespace

inside::StressesInside stresses_in_body(const std::filesystem::path& result,
                                        const std::filesystem::path& body, const std::string& points) {
  if (!is_regular(body))
    throw InputError(fmt::format("There is no body file '{}'", body.string()), "no file has this name",
                     "Give one like data/bodies/small_rail.toml.");
  const TemporaryFolder folder;
  const std::string mesh = (folder / "body.msh").string(), out = (folder / "stresses.h5").string();
  run("mesh_body", {body.string(), "-o", mesh}, body, folder);
  std::vector<std::string> arguments{body.string(), mesh, "--stresses", out, "--result", result.string()};
  if (!points.empty())
    arguments.insert(arguments.end(), {"--points", points});
  run("fem_influence", std::move(arguments), body, folder);
  return inside::stresses_from(record::read_hdf5(out));
}

} // namespace bem_contact::app
