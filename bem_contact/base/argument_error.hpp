#pragma once

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/message_file.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <string>
#include <vector>

// Included by programs alone: the libraries know nothing of CLI11.

namespace bem_contact {

/// The command of a parsed line, with its program's name: "bem_contact influence expand".
struct UsedCommand {
  const CLI::App* app;
  std::string name;

  explicit UsedCommand(const CLI::App& program)
      : app(&program), name(std::filesystem::path(program.get_name()).filename().string()) {
    while (!app->get_subcommands().empty()) {
      app = app->get_subcommands().front();
      name += " " + app->get_name();
    }
  }
};

/// An option that names a file or a folder to write. An empty name is refused, as of a variable of a script
/// that was not set: without it the run would end well, and write nothing.
template <class File>
CLI::Option* add_output_option(CLI::App& line, const std::string& name, File& file,
                               const std::string& description) {
  return line.add_option(name, file, description)
      ->configurable(false) // a scene does not say what is written
      ->check([given = name.substr(name.rfind(',') + 1)](const std::string& value) -> std::string {
        if (value.empty())
          throw InputError(fmt::format("The output of {} cannot be written", given), "it names no file",
                           "Give it a name, or leave the option out.");
        return {};
      });
}

/// What is wrong with the arguments of a program, as all errors are said.
inline std::string argument_error(const CLI::App& program, const CLI::ParseError& error) {
  const UsedCommand command(program);
  const std::string help = fmt::format("See {} --help.", command.name);
  for (const std::string& given : program.remaining(true)) {
    if (!given.starts_with("--"))
      continue;
    std::vector<std::string> options;
    for (const CLI::Option* option : command.app->get_options())
      for (const std::string& name : option->get_lnames())
        options.push_back("--" + name);
    const auto like = nearest_names(given.substr(0, given.find('=')), options, 1);
    return Error(fmt::format("There is no option '{}'", given), fmt::format("{} has others", command.name),
                 like.empty() ? help : fmt::format("Did you mean {}?", like.front()))
        .what();
  }
  return Error("The arguments cannot be used", error.what(), help).what();
}

/// Ends what CLI11 has begun: prints help or version and returns 0, or prints the error and returns 2.
inline int exit_code_of(const CLI::App& program, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0)
    return program.exit(error);
  say_error(argument_error(program, error));
  return 2;
}

} // namespace bem_contact
