#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bem_contact {

/// What a child process does.
struct ChildWork {
  std::vector<std::string> words; ///< a program's name, as for a shell, and its arguments
  std::vector<std::pair<std::string, std::string>> variables =
      {}; ///< names and values; they join the child's environment
  /// What this very program does when it is started with `words`; its result is the exit code. Where the
  /// system can copy a process it is called in the copy, which saves the start. Empty: another program. This
  /// process must then have one thread alone.
  std::function<int()> here = {};
};

/// A child of this process whose messages come back line by line. It is asked to end (SIGTERM; Windows ends
/// it) when the object goes, and when this process ends.
class ChildProcess {
public:
  /// What it prints goes to the file `text`. Throws Error where no process can be started.
  ChildProcess(const std::filesystem::path& text, const ChildWork& work);
  ~ChildProcess(); ///< asks it to end, and waits
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// "", or why the program is none that can be started here.
  const std::string& why_not_started() const;

  /// Waits for the next line on its standard error. Nothing: there will be none, or another thread has set
  /// `stop` (null: none will). With a stop, `meanwhile` is called ten times a second while nothing comes.
  std::optional<std::string> next_line(const std::atomic<bool>* stop = nullptr,
                                       const std::function<void()>& meanwhile = {});
  /// Waits until it has ended. Its exit code, or -1 where it had none, and `how` says why.
  int wait(std::string& how);

private:
  enum class Read { bytes, nothing_yet, end };
  /// Reads of its standard error, to the end of `rest_`. `patience`: ms; negative: without end.
  Read read_more(int patience);

  struct Started;
  std::unique_ptr<Started> started_;
  std::string rest_; ///< of what was read, not yet given as a line
};

/// This process becomes the program, or ends with it; it inherits standard streams alone. Returns only where
/// it cannot. `words`: as those of a child.
void become_program(const std::vector<std::string>& words);

/// Runs a program, which prints to standard error, and waits for it. True: it did what it had to; else `why`
/// says what happened, or is "" where it has said so itself.
bool run_and_wait(const std::vector<std::string>& words, std::string& why);

void set_variable(const char* name, const std::filesystem::path& value); ///< of the environment

/// A program in the folder CONFORMAL_BIN, else beside this one, else on PATH. "": it is not there.
std::filesystem::path program_named(std::string_view name);

} // namespace bem_contact
