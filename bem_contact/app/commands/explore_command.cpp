#include "bem_contact/app/command.hpp"
#include "bem_contact/app/output/repeat.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/explore/explore.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/record/hdf5.hpp"
#include "bem_contact/sequence/scene_record.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>
#include <string>

namespace bem_contact::app {

namespace {

constexpr const char* explore_help =
    R"(Example:
    bem_contact explore data/scenes/conformal_small.toml
It prints an address, and opens it in a browser where there is a desktop. You should see wheel and rail with the patch in
place; turn them with the mouse. Move a slider, and the contact is solved again. The page compares two cases, sweeps over a
slider, and saves the scene, the result, a page, CSV and pictures. It shows the command that does what is on the screen.

Without a file it begins with an S1002 wheel on a 60E1 rail. Of a result (HDF5) it takes the scene with the profiles that
the file keeps. Finite elements can be chosen where the scene names influence files. A button computes influence functions
for the contact on the screen, where mesh_body and fem_influence are installed.

Only this machine reaches the page, and only with the address that was printed. It reads the files that the scene names and
profiles that you drop on the page, and writes none: the browser saves what you ask for. Ctrl-C ends it.)";

constexpr const char* first_scene = R"(# An S1002 wheel on a 60E1 rail
kind = "wheel_rail"
rail.profile = "60E1"
wheel.profile = "S1002"

[position]
rail_inclination = 0.025 # rad, 1:40
lateral = 2.0            # mm, to the right

[load]
force = 1e5 # N

[motion]
friction = 0.3

[grid]
elements = 300 # in contact
)";

struct ExploreArguments {
  std::string file;
  explore::ExploreOptions options;
  bool no_browser = false;
};

/// The scene of a result file, with the profiles that it keeps.
explore::Start start_of_result(const std::filesystem::path& file) {
  const record::Record stored = record::read_hdf5_top(file, "inputs");
  const std::string folder(record::text_at(stored, "scene_folder").value_or(""));
  explore::Start start{.scene = {stored_scene(file, false), fmt::format("the scene of '{}'", file.string()),
                                 (file.parent_path() / folder).lexically_normal()},
                       .file = file.string()};
  if (const auto model = record::text_at(stored, "model_option"); model && !model->empty())
    start.changes.push_back({"solver.model", std::string(*model)});
  for (const InputRecord& input : stored_inputs(stored))
    if (input.content && named_by(input.key).empty())
      start.files.emplace(
          input.name.substr(0, names_profile(input.key) ? input.name.rfind('#') : input.name.npos),
          *input.content);
  return start;
}

explore::Start start_of(const std::string& file) {
  if (file.empty())
    return {.scene = {first_scene, "the first scene"}};
  return is_hdf5(file) ? start_of_result(file) : explore::Start{.scene = read_scene_text(file), .file = file};
}

} // namespace

Command add_explore(CLI::App& program) {
  const auto arguments = std::make_shared<ExploreArguments>();
  CLI::App* line =
      program.add_subcommand("explore", "A page in the browser: turn it, change it, see what happens");
  line->add_option("file", arguments->file, "Scene (TOML) or result (HDF5) to begin with");
  line->add_option("--port", arguments->options.port, "Of the address; 0: any that is free")
      ->check(CLI::Range(0, 65535))
      ->capture_default_str();
  line->add_flag("--no-browser", arguments->no_browser, "Print the address alone");
  line->footer(explore_help);
  return {line, [arguments] {
            explore::ExploreOptions options = arguments->options;
            options.open_browser = !arguments->no_browser;
            explore::explore(start_of(arguments->file), options);
            return success;
          }};
}

} // namespace bem_contact::app
