#include "bem_contact/app/study/run_line.hpp"

#include "bem_contact/app/command.hpp"
#include "bem_contact/app/run_program.hpp"
#include "bem_contact/base/error.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fmt/format.h>
#include <functional>
#include <iostream>
#include <string_view>

namespace bem_contact::app {

namespace {

/// Takes the messages of a process line by line.
class Messages {
public:
  Messages(LineOutcome& outcome, std::set<std::string>& said) : outcome_(outcome), said_(said) {}

  void take(std::string_view bytes) {
    rest_ += bytes;
    for (std::size_t end; (end = rest_.find('\n')) != std::string::npos; rest_.erase(0, end + 1))
      line(rest_.substr(0, end));
  }
  void finish() {
    if (!rest_.empty())
      line(rest_);
  }

private:
  void line(const std::string& text) {
    const auto keep = [&](std::string_view begin, std::vector<std::string>& kept) {
      if (text.starts_with(begin))
        kept.push_back(text.substr(begin.size()));
    };
    keep("error: ", outcome_.errors);
    keep("warning: ", outcome_.warnings);
    const bool message = text.starts_with("info: ") || text.starts_with("warning: ");
    if (!message || said_.insert(text).second)
      fmt::print(stderr, "{}\n", text);
  }

  LineOutcome& outcome_;
  std::set<std::string>& said_;
  std::string rest_;
};

std::vector<char*> pointers_of(std::vector<std::string>& words) {
  std::vector<char*> out;
  for (std::string& word : words)
    out.push_back(word.data());
  out.push_back(nullptr);
  return out;
}

/// How a process ended, as an exit code; a signal is said.
int ended(pid_t process, LineOutcome& outcome) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  if (!WIFSIGNALED(status))
    return WEXITSTATUS(status);
  outcome.errors.push_back(
      fmt::format("Its process was ended (signal {}, {}) If memory ran out, give it less to "
                  "do; then call bem_contact study again.",
                  WTERMSIG(status), strsignal(WTERMSIG(status))));
  return unforeseen;
}

/// Starts a process whose output goes to the file and whose messages come back; `work` never returns there.
LineOutcome in_process(const std::filesystem::path& text, std::set<std::string>& said,
                       const std::function<int()>& work) {
  std::fflush(stdout);
  std::cout.flush();
  int ends[2] = {-1, -1};
  const int file = open(text.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  const pid_t process = file >= 0 && pipe(ends) == 0 ? fork() : -1;
  if (process < 0) {
    const std::string why = std::strerror(errno);
    for (const int end : {file, ends[0], ends[1]})
      close(end);
    throw Error("A part of the study cannot be started", why,
                "End other programs, or look at the folder's rights.");
  }
  if (process == 0) {
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    dup2(file, STDOUT_FILENO);
    dup2(ends[1], STDERR_FILENO);
    close(ends[0]);
    close(ends[1]);
    const int code = work();
    std::fflush(nullptr);
    std::cout.flush();
    _exit(code);
  }
  close(file);
  close(ends[1]);
  LineOutcome out;
  Messages messages(out, said);
  char bytes[4096];
  for (ssize_t count; (count = read(ends[0], bytes, sizeof bytes)) != 0;)
    if (count > 0)
      messages.take({bytes, static_cast<std::size_t>(count)});
    else if (errno != EINTR)
      break;
  messages.finish();
  close(ends[0]);
  out.code = ended(process, out);
  return out;
}

} // namespace

LineOutcome run_line(const std::vector<std::string>& words, const std::filesystem::path& text,
                     std::set<std::string>& said) {
  return in_process(text, said, [&] {
    std::vector<std::string> line{"bem_contact"};
    line.insert(line.end(), words.begin(), words.end());
    return run_program(static_cast<int>(line.size()), pointers_of(line).data());
  });
}

LineOutcome run_other(const std::vector<std::string>& words, const std::filesystem::path& text,
                      std::set<std::string>& said) {
  return in_process(text, said, [&] {
    std::vector<std::string> line = words;
    execvp(line.front().c_str(), pointers_of(line).data());
    fmt::print(stderr, "error: '{}' cannot be started ({}) Give influence.program a program that is there.\n",
               line.front(), std::strerror(errno));
    return static_cast<int>(wrong_input);
  });
}

} // namespace bem_contact::app
