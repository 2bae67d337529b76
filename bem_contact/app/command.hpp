#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace bem_contact::app {

/// What the program returns to the shell. `unforeseen`: neither the input nor the problem is to blame
/// (standard output cannot be written, an error of the program itself).
enum ExitCode { success = 0, unforeseen = 1, wrong_input = 2, no_convergence = 3 };

/// A subcommand: its options and its help are in `line`, `run` does it once the options are parsed.
/// Errors are thrown; main() turns them into messages and exit codes.
struct Command {
  CLI::App* line = nullptr;
  std::function<ExitCode()> run;
};

} // namespace bem_contact::app
