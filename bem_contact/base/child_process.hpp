#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bem_contact {

/// A child of this process whose messages come back line by line. It is asked to end (SIGTERM) when the
/// object goes, and when the thread ends that has made it.
class ChildProcess {
public:
  /// `work` runs in the child and never returns here; its result is the exit code. What it prints goes to the
  /// file `text`. Where this process has several threads, `work` may only become_program(). Throws Error
  /// where no process can be started.
  ChildProcess(const std::filesystem::path& text, const std::function<int()>& work);
  ~ChildProcess(); ///< asks it to end, and waits
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Waits for the next line on its standard error. Nothing: there will be none, or another thread has set
  /// `stop` (null: none will). With a stop, `meanwhile` is called ten times a second while nothing comes.
  std::optional<std::string> next_line(const std::atomic<bool>* stop = nullptr,
                                       const std::function<void()>& meanwhile = {});
  /// Waits until it has ended. Its exit code, or -1 for a signal, which `how` then names.
  int wait(std::string& how);

private:
  int process_ = -1;
  int messages_ = -1;
  std::string rest_;
};

/// Another program with its arguments, made ready so that starting it allocates nothing.
class ProgramLine {
public:
  explicit ProgramLine(std::vector<std::string> words); ///< its name, as for a shell, and its arguments
  ProgramLine(const ProgramLine&) = delete;
  ProgramLine& operator=(const ProgramLine&) = delete;

  /// This process becomes the program, which inherits standard streams alone. Returns only where it cannot.
  void become() const;

private:
  std::vector<std::string> words_;
  std::vector<char*> pointers_;
};

/// Runs a program, which prints to standard error, and waits for it. True: it did what it had to; else `why`
/// says what happened, or is "" where it has said so itself.
bool run_and_wait(const std::vector<std::string>& words, std::string& why);

void set_variable(const char* name, const std::filesystem::path& value); ///< of the environment

/// A program in the folder CONFORMAL_BIN, else beside this one, else on PATH. "": it is not there.
std::filesystem::path program_named(std::string_view name);

} // namespace bem_contact
