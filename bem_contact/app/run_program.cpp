#include "bem_contact/app/run_program.hpp"

#include "bem_contact/app/command.hpp"
#include "bem_contact/app/scene_options.hpp"
#include "bem_contact/base/argument_error.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/printable.hpp"
#include "bem_contact/base/provenance.hpp"
#include "bem_contact/base/said_by.hpp"
#include "bem_contact/profile/message_sink.hpp"
#include "bem_contact/scene/scene_file.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <new>
#include <spdlog/spdlog.h>

namespace bem_contact::app {

namespace {

constexpr const char* program_help =
    R"(A scene is a TOML file that says which bodies touch, where they stand, how they are loaded and how they move.
Begin with one that is there, then change it:
    bem_contact solve data/scenes/hertz.toml
You should see one patch, its forces, its largest pressure and the line `certified`. `yes` in this line means that
the result fulfils the contact conditions; code that is not part of the solver checks that.
data/scenes/README.md lists what scenes can ask; --print-default prints every key of a scene.

Units are mm, N, MPa, rad. x points in the direction of rolling, y to the right, z down. s is the arc length of the
rail's profile: 0 at the middle of its top, negative towards the gauge corner. n points into the rail. Forces are
those on the rail.

Exit code 0: the certificate holds (sweep: of every case). 1: an unforeseen error, such as a full disk. 2: the input is
wrong. 3: the solver did not converge or a certificate does not hold.
Each command has its own --help with an example.)";

/// Comes before the options are parsed, because options of an unknown command are no errors of their own.
void refuse_unknown_command(const CLI::App& cli, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* command : cli.get_subcommands(nullptr))
    names.push_back(command->get_name());
  if (word.empty() || word.front() == '-' || std::ranges::count(names, word) > 0)
    return;
  const auto like = nearest_names(word, names, 1);
  throw InputError(fmt::format("There is no command '{}'", word),
                   fmt::format("the commands are {}", fmt::join(names, ", ")),
                   file_exists(word) ? fmt::format("Did you mean bem_contact solve {}?", word)
                   : like.empty()    ? "See bem_contact --help."
                                     : fmt::format("Did you mean {}?", like.front()));
}

/// The command that the line asks for, or --print-default, or the help.
ExitCode run(const CLI::App& cli, const std::vector<Command>& added, bool print_default) {
  if (print_default) {
    print_out("{}", default_scene_file());
    return success;
  }
  for (const Command& command : added)
    if (command.line->parsed()) {
      take_options_of_scene(command, added);
      return command.run();
    }
  print_error("{}", cli.help());
  return wrong_input;
}

int parse_and_run(int argc, char** argv) {
  CLI::App cli{"Conformal wheel-rail contact by the boundary element method"};
  bool print_default = false;
  cli.allow_windows_style_options(false); // on every system /folder/scene.toml is a path
  cli.require_subcommand(0, 1);
  cli.set_version_flag("--version", provenance("bem_contact"));
  cli.add_flag("--print-default", print_default,
               "Print a scene file with every key, its default and its unit");
  cli.footer(program_help);
  std::vector<Command> added;
  for (const auto add : all_commands)
    added.push_back(add(cli));
  refuse_odd_numbers(cli);
  try {
    refuse_unknown_command(cli, argc > 1 ? argv[1] : "");
    cli.parse(argc, argv);
    return run(cli, added, print_default);
  } catch (const CLI::ParseError& error) {
    return exit_code_of(cli, error); // --help is no error
  } catch (const ConvergenceError& error) {
    spdlog::error("{}", error.what());
    return no_convergence;
  } catch (const InputError& error) {
    spdlog::error("{}", error.what());
    return wrong_input;
  } catch (const Error& error) {
    spdlog::error("{}", error.what());
    return unforeseen;
  } catch (const std::bad_alloc& error) {
    spdlog::error("{}", said_by(error));
    return unforeseen;
  } catch (const std::exception& error) {
    if (std::ferror(stdout) == 0) // checked_exit_code() says it
      spdlog::error("Something this program did not foresee: {}", error.what());
    return unforeseen;
  }
}

} // namespace

int run_program(int argc, char** argv) {
  const auto messages = install_message_sink();
  const int code = parse_and_run(argc, argv);
  messages->finish();
  return code;
}

} // namespace bem_contact::app
