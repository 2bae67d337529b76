#include "bem_contact/inside/stresses_in_body.hpp"

#include "bem_contact/base/child_process.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/temporary_folder.hpp"
#include "bem_contact/base/told_program.hpp"
#include "bem_contact/influence/file_seal.hpp"
#include "bem_contact/inside/stresses_by_file.hpp"
#include "bem_contact/record/hdf5.hpp"

#include <fmt/format.h>
#include <utility>
#include <vector>

namespace bem_contact::inside {

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

void stresses_in_body(const std::vector<std::filesystem::path>& results, const std::filesystem::path& body,
                      const std::string& points,
                      const std::function<void(std::size_t, StressesInside)>& take) {
  if (!is_regular(body))
    throw InputError(fmt::format("There is no body file '{}'", body.string()), "no file has this name",
                     "Give one like data/bodies/small_rail.toml, or an influence file with stresses.");
  if (begins_with_seal(body)) {
    const FileOfStresses file(body);
    const std::vector<BelowSurface> own =
        points.empty() ? std::vector<BelowSurface>{} : read_points_below(points);
    for (std::size_t i = 0; i < results.size(); ++i)
      take(i, stresses_by_file(record::read_hdf5(results[i]), file, own));
    return;
  }
  const TemporaryFolder folder;
  const std::string mesh = (folder / "body.msh").string();
  run("mesh_body", {body.string(), "-o", mesh}, body, folder);
  const auto output = [&](std::size_t i) { return folder / fmt::format("stresses_{}.h5", i); };
  std::vector<std::string> arguments{body.string(), mesh};
  for (std::size_t i = 0; i < results.size(); ++i)
    arguments.insert(arguments.end(), {"--stresses", output(i).string(), "--result", results[i].string()});
  if (!points.empty())
    arguments.insert(arguments.end(), {"--points", points});
  run("fem_influence", std::move(arguments), body, folder);
  for (std::size_t i = 0; i < results.size(); ++i)
    take(i, stresses_from(record::read_hdf5(output(i))));
}

StressesInside stresses_in_body(const std::filesystem::path& result, const std::filesystem::path& body,
                                const std::string& points) {
  StressesInside out;
  stresses_in_body(std::vector{result}, body, points,
                   [&](std::size_t, StressesInside one) { out = std::move(one); });
  return out;
}

} // namespace bem_contact::inside
