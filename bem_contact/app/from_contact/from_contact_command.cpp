#include "bem_contact/app/command.hpp"
#include "bem_contact/app/from_contact/contact_cases.hpp"
#include "bem_contact/app/from_contact/scene_text.hpp"
#include "bem_contact/base/argument_error.hpp"
#include "bem_contact/base/counted.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/output_folder.hpp"
#include "bem_contact/base/printable.hpp"
#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/record/json.hpp"
#include "bem_contact/scene/scene_file.hpp"
#include "bem_contact/sequence/scene_record.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <ostream>
#include <spdlog/spdlog.h>
#include <string>
#include <system_error>
#include <utility>

namespace bem_contact::app {

namespace {

using namespace from_contact;

constexpr const char* from_contact_help =
    R"(Reads an input file (.inp) of the program CONTACT, cases of a wheel on a rail (module 1) and of a patch (module 3), and
writes a scene for each of them. Transient cases that go on from the one before become the steps of one scene. What has no
counterpart stands as a comment in the scene and is printed; a case that would be another problem without it has no scene.
    bem_contact from-contact CASES.inp -o scenes
    bem_contact solve scenes/CASES_001.toml
You should see a line for each case. The digits side by side, and two examples with both results:
data/tutorial/contact.md.

Exit code 0: every case has a scene; 2: some have none, or the file cannot be read.)";

std::string stem_of(const ContactCase& one, const std::filesystem::path& input) {
  return fmt::format("{}_{:03}", input.stem().string(), one.first);
}

/// Writes the scene of a case with its tables, and returns its name. A case that makes none gets the reason,
/// and "".
std::string write_case(ContactCase& one, const std::filesystem::path& input, OutputFolder& folder) {
  if (!one.refused.empty())
    return "";
  const std::string stem = stem_of(one, input);
  for (const SceneTableFile& table : tables_of_case(one))
    folder.write(name_of_table(stem, table), [&](std::ostream& out) { out << table.text; });
  const std::string text = scene_of_case(one, input, folder.path(), stem);
  try {
    parse_scene_file({text, stem + ".toml", folder.path()});
  } catch (const InputError& error) {
    one.refuse(error.what());
    return "";
  }
  folder.write(stem + ".toml", [&](std::ostream& out) { out << text; });
  return stem + ".toml";
}

void print_case(const ContactCase& one, const std::string& scene) {
  const std::string name = one.first == one.last ? fmt::format("case {}", one.first)
                                                 : fmt::format("cases {} to {}", one.first, one.last);
  for (const std::string& sentence : one.refused)
    print_out("{} (line {}): no scene: {}\n", name, one.line, sentence);
  if (scene.empty())
    return;
  print_out("{}: {}\n", name, scene);
  for (const std::string& sentence : one.left_out)
    print_out("    left out: {}\n", sentence);
}

record::Record record_of(const ContactCase& one, const std::string& scene) {
  return {
      {"first", record::Number{static_cast<double>(one.first), "1", "number in the file, from 1", {}, true}},
      {"last", record::Number{static_cast<double>(one.last), "1", "of the last step", {}, true}},
      {"line", record::Number{static_cast<double>(one.line), "1", "where it begins", {}, true}},
      {"scene", record::Text{scene}},
      {"left_out", record::Texts{one.left_out, "what has no counterpart"}},
      {"refused", record::Texts{one.refused, "why there is no scene"}}};
}

ExitCode convert(const std::string& input, const std::filesystem::path& name, bool as_json) {
  auto [cases, broken] = read_contact_cases(input);
  OutputFolder folder(name, {.maker = "from-contact", .alone = false, .inputs = {input}});
  for (const ContactCase& one : cases) // before one is written
    folder.require(stem_of(one, input) + ".toml");
  record::Record all;
  std::size_t without = 0;
  for (ContactCase& one : cases) {
    const std::string scene = write_case(one, input, folder);
    without += scene.empty();
    if (!as_json)
      print_case(one, scene);
    all.add(fmt::format("{:05}", one.first), record_of(one, scene));
  }
  if (as_json)
    print_out("{}\n", record::to_json(headed(from_contact_format)
                                          .add("cases", std::move(all))
                                          .add("broken", broken ? broken->what() : "")));
  if (broken)
    throw InputError(*broken);
  if (without == 0)
    return success;
  spdlog::error("{} of {} without a scene (see above)", without, counted(cases.size(), "case", "cases"));
  return wrong_input;
}

} // namespace

Command add_from_contact(CLI::App& program) {
  struct Arguments {
    std::string input;
    std::filesystem::path folder;
    bool json = false;
  };
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* line = program.add_subcommand("from-contact", "Scenes of an input file of Kalker's CONTACT");
  line->add_option("file", arguments->input, "Input file (.inp) of CONTACT")->required();
  add_output_option(*line, "-o,--output", arguments->folder, "Folder of the scenes")->required();
  line->footer(from_contact_help);
  line->add_flag("--json", arguments->json, "Print what became of each case as JSON");
  return {line, [arguments] { return convert(arguments->input, arguments->folder, arguments->json); }};
}

} // namespace bem_contact::app
