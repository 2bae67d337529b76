#include "bem_contact/app/command.hpp"

#include "bem_contact/base/argument_error.hpp"
#include "bem_contact/scene/choices.hpp"
#include "bem_contact/scene/warning.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <fmt/format.h>
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
  line.add_flag("--json", json, "Print one JSON object instead of the text")->configurable(false);
}

void refuse_odd_numbers(CLI::App& line) {
  for (CLI::Option* option : line.get_options()) {
    const std::string type = option->get_type_name();
    if (option->get_expected_max() > 0 && option->get_type_size_max() > 0)
      option->check([](const std::string& text) {
        return text.empty() ? std::string("it has an empty value, as of a variable that was not set")
                            : std::string();
      });
    if (type.starts_with(CLI::detail::type_name<double>()))
      option->check([](const std::string& text) {
        double number = 0;
        const bool read = CLI::detail::lexical_cast(text, number); // the library says what is no number
        return read && !std::isfinite(number) ? fmt::format("{} is no finite number", text) : std::string();
      });
    else if (type.starts_with(CLI::detail::type_name<std::size_t>()))
      option->check([](const std::string& text) {
        return text.starts_with('-') ? fmt::format("{} is below 0", text) : std::string();
      });
  }
  for (CLI::App* command : line.get_subcommands(nullptr))
    refuse_odd_numbers(*command);
}

void warn(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings)
    spdlog::warn("{}", warning);
}

void warn(const Warnings& warnings) {
  warn(warnings.texts());
}

} // namespace bem_contact::app
