#include "bem_contact/app/command.hpp"
#include "bem_contact/app/from_contact/contact_cases.hpp"
#include "bem_contact/base/argument_error.hpp"
#include "bem_contact/base/counted.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/output_folder.hpp"
#include "bem_contact/base/printable.hpp"
#include "bem_contact/scene/scene_file.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <ostream>
#include <spdlog/spdlog.h>
#include <string>

namespace bem_contact::app {

namespace {

constexpr const char* from_contact_help =
    R"(Reads an input file (.inp) of the program CONTACT, cases of a wheel on a rail (module 1) and of a patch (module 3), and
writes a scene for each of them. Transient cases that go on from the one before become the steps of one scene. What has no
counterpart stands as a comment in the scene and is printed; a case that would be another problem without it has no scene.
    bem_contact from-contact CASES.inp -o scenes
    bem_contact solve scenes/CASES_001.toml
You should see a line for each case. The digits side by side, and two examples with both results:
data/tutorial/contact.md.

Exit code 0: every case has a scene; 2: some have none, or the file cannot be read.)";

/// The name of a profile as a scene in `folder` finds it: CONTACT looks beside the input file.
std::string profile_beside(const std::string& value, const std::filesystem::path& input,
                           const std::filesystem::path& folder) {
  std::string name = value.substr(1, value.size() - 2);
  std::replace(name.begin(), name.end(), '\\', '/');
  const auto file = std::filesystem::absolute(input).parent_path() / name;
  return fmt::format("\"{}\"", file.lexically_normal()
                                   .lexically_proximate(std::filesystem::absolute(folder).lexically_normal())
                                   .generic_string());
}

std::string scene_of_case(const ContactCase& one, const std::filesystem::path& input,
                          const std::filesystem::path& folder, const std::string& stem) {
  std::string out = fmt::format("# {} of {}, written by bem_contact from-contact.\n",
                                one.first == one.last ? fmt::format("Case {}", one.first)
                                                      : fmt::format("Cases {} to {}", one.first, one.last),
                                input.filename().string());
  for (const std::string& sentence : one.left_out)
    out += fmt::format("# Left out: {}.\n", sentence);
  const bool steps = std::ranges::count(one.tables, "motion.step_table", &SceneTableFile::key) > 0;
  for (const auto& [key, value] : one.keys)
    if (!(steps && (key == "motion.xi" || key == "motion.eta" || key == "motion.phi"))) // the table has them
      out += fmt::format("{} = {}\n", key,
                         key.ends_with(".profile") ? profile_beside(value, input, folder) : value);
  for (const SceneTableFile& table : one.tables)
    out += fmt::format("{} = \"{}_{}.csv\"\n", table.key, stem, table.key.substr(table.key.find('.') + 1));
  return out;
}

std::string stem_of(const ContactCase& one, const std::filesystem::path& input) {
  return fmt::format("{}_{:03}", input.stem().string(), one.first);
}

/// Writes the scene of a case with its tables. False where it has none; says what was left out.
bool write_case(const ContactCase& one, const std::filesystem::path& input, OutputFolder& folder) {
  const std::string stem = stem_of(one, input);
  const std::string name = one.first == one.last ? fmt::format("case {}", one.first)
                                                 : fmt::format("cases {} to {}", one.first, one.last);
  for (const std::string& sentence : one.refused)
    print_out("{} (line {}): no scene: {}\n", name, one.line, sentence);
  if (!one.refused.empty())
    return false;
  for (const SceneTableFile& table : one.tables)
    folder.write(fmt::format("{}_{}.csv", stem, table.key.substr(table.key.find('.') + 1)),
                 [&](std::ostream& out) { out << table.text; });
  const std::string text = scene_of_case(one, input, folder.path(), stem);
  try {
    parse_scene_file({text, stem + ".toml", folder.path()});
  } catch (const InputError& error) {
    print_out("{} (line {}): no scene: {}\n", name, one.line, error.what());
    return false;
  }
  folder.write(stem + ".toml", [&](std::ostream& out) { out << text; });
  print_out("{}: {}.toml\n", name, stem);
  for (const std::string& sentence : one.left_out)
    print_out("    left out: {}\n", sentence);
  return true;
}

} // namespace

Command add_from_contact(CLI::App& program) {
  struct Arguments {
    std::string input;
    std::filesystem::path folder;
  };
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* line = program.add_subcommand("from-contact", "Scenes of an input file of Kalker's CONTACT");
  line->add_option("file", arguments->input, "Input file (.inp) of CONTACT")->required();
  add_output_option(*line, "-o,--output", arguments->folder, "Folder of the scenes")->required();
  line->footer(from_contact_help);
  return {line, [arguments] {
            const std::vector<ContactCase> cases = read_contact_cases(arguments->input);
            OutputFolder folder(arguments->folder,
                                {.maker = "from-contact", .alone = false, .inputs = {arguments->input}});
            for (const ContactCase& one : cases) // before one is written
              folder.require(stem_of(one, arguments->input) + ".toml");
            std::size_t without = 0;
            for (const ContactCase& one : cases)
              without += !write_case(one, arguments->input, folder);
            if (without == 0)
              return success;
            spdlog::error("{} of {} without a scene (see above)", without,
                          counted(cases.size(), "case", "cases"));
            return wrong_input;
          }};
}

} // namespace bem_contact::app
