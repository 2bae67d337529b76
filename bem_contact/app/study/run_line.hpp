#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace bem_contact::app {

/// What a command line has come to.
struct LineOutcome {
  int code = 0;                      ///< ExitCode; 1 where its process died
  std::vector<std::string> errors;   ///< in the words of the program
  std::vector<std::string> warnings; ///< in its words, too
};

/// Runs a command of this program ("solve", "case.toml", ...) in a process of its own, so that whatever
/// happens to it leaves this one alone. What it prints goes to the file `text`; its messages and its progress
/// go on to standard error, each line that is not in `said` yet.
LineOutcome run_line(const std::vector<std::string>& words, const std::filesystem::path& text,
                     std::set<std::string>& said);

/// The same for another program.
LineOutcome run_other(const std::vector<std::string>& words, const std::filesystem::path& text,
                      std::set<std::string>& said);

} // namespace bem_contact::app
