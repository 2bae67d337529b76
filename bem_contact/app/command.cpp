#include "bem_contact/app/command.hpp"

#include "bem_contact/base/argument_error.hpp"
#include "bem_contact/scene/choices.hpp"

#include <CLI/CLI.hpp>
#include <spdlog/spdlog.h>

namespace bem_contact::app {

void add_model(CLI::App& line, std::string& model) {
  std::vector<std::string> names{std::string(automatic_model)};
  names.insert(names.end(), EnumNames<Model>::names.begin(), EnumNames<Model>::names.end());
  line.add_option("--model", model, "Model of the bodies, instead of the scene's own choice")
      ->check(CLI::IsMember(names));
}

void add_strict(CLI::App& line, bool& strict) {
  line.add_flag("--strict", strict, "End with exit code 2 at a warning, and write no file");
}

void add_jobs(CLI::App& line, int& jobs) {
  constexpr int most_jobs = 4096; // a typing error, not a machine
  line.add_option("--jobs", jobs, "Number of processes; 0: one for each core")
      ->check(CLI::Range(0, most_jobs))
      ->capture_default_str();
}

void add_output(CLI::App& line, std::string& output) {
  add_output_option(line, "-o,--output", output, "Result file (HDF5)");
}

void add_json(CLI::App& line, bool& json) {
  line.add_flag("--json", json, "Print one JSON object instead of the text");
}

void warn(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings)
    spdlog::warn("{}", warning);
}

} // namespace bem_contact::app
