#include "bem_contact/base/child_process.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/program.hpp"
#include "bem_contact/base/system/posix/close_others.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fmt/format.h>
#include <iostream>
#include <sstream>
#include <utility>

namespace bem_contact {

namespace {

/// A signal that reaches a child before it is another program must end it, and not run a handler of this
/// process. So signals wait while there is such a child.
class HeldSignals {
public:
  HeldSignals() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~HeldSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;

  void let_go_in_child() const {
    for (const int signal_that_ends : {SIGINT, SIGTERM, SIGHUP})
      signal(signal_that_ends, SIG_DFL);
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }

private:
  sigset_t before_;
};

} // namespace

ChildProcess::ChildProcess(const std::filesystem::path& text, const std::function<int()>& work) {
  std::fflush(stdout);
  std::cout.flush();
  int ends[2] = {-1, -1};
  const int file = open(text.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  const pid_t parent = getpid();
  const HeldSignals held;
  process_ = file >= 0 && pipe2(ends, O_CLOEXEC) == 0 ? fork() : -1;
  if (process_ < 0) {
    const std::string why = std::strerror(errno);
    for (const int end : {file, ends[0], ends[1]})
      close(end);
    throw Error("No other process can be started", why,
                "End other programs, or look at the folder's rights.");
  }
  if (process_ == 0) {
    held.let_go_in_child();
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != parent)
      _exit(1);
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
  messages_ = ends[0];
}

ChildProcess::~ChildProcess() {
  close(messages_);
  if (process_ > 0) {
    kill(process_, SIGTERM);
    std::string how;
    wait(how);
  }
}

std::optional<std::string> ChildProcess::next_line(const std::atomic<bool>* stop,
                                                   const std::function<void()>& meanwhile) {
  constexpr int patience = 100; // ms, after which `stop` is looked at
  char bytes[4096];
  while (!stop || !*stop) {
    if (const std::size_t end = rest_.find('\n'); end != std::string::npos) {
      std::string line = rest_.substr(0, end);
      rest_.erase(0, end + 1);
      return line;
    }
    pollfd ready{.fd = messages_, .events = POLLIN, .revents = 0};
    if (stop && poll(&ready, 1, patience) == 0) {
      if (meanwhile)
        meanwhile();
      continue;
    }
    const ssize_t count = read(messages_, bytes, sizeof bytes);
    if (count > 0)
      rest_.append(bytes, static_cast<std::size_t>(count));
    else if (count == 0 || errno != EINTR)
      break;
  }
  return rest_.empty() ? std::nullopt : std::optional(std::exchange(rest_, {}));
}

int ChildProcess::wait(std::string& how) {
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  if (!WIFSIGNALED(status))
    return WEXITSTATUS(status);
  how = fmt::format("signal {}, {}", WTERMSIG(status), strsignal(WTERMSIG(status)));
  return -1;
}

ProgramLine::ProgramLine(std::vector<std::string> words) : words_(std::move(words)) {
  for (std::string& word : words_)
    pointers_.push_back(word.data());
  pointers_.push_back(nullptr);
}

void ProgramLine::become() const {
  system::close_others(system::CloseOthers::as_another_program_begins);
  execvp(pointers_.front(), pointers_.data());
}

bool run_and_wait(const std::vector<std::string>& words, std::string& why) {
  std::vector<std::string> copies = words;
  std::vector<char*> arguments;
  arguments.reserve(copies.size() + 1);
  for (std::string& word : copies)
    arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
  pid_t process = 0;
  int status = 0;
  const int failed = posix_spawnp(&process, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed == 0)
    while (waitpid(process, &status, 0) < 0 && errno == EINTR)
      ;
  why = failed != 0 ? std::strerror(failed) : "";
  return failed == 0 && status == 0;
}

void set_variable(const char* name, const std::filesystem::path& value) {
  setenv(name, value.c_str(), 1);
}

std::filesystem::path program_named(std::string_view name) {
  const auto self = this_program().parent_path();
  const auto variable = [](const char* of) {
    const char* value = std::getenv(of);
    return std::string(value ? value : "");
  };
  std::istringstream folders(variable("CONFORMAL_BIN") + ":" + self.string() + ":" + variable("PATH"));
  for (std::string folder; std::getline(folders, folder, ':');)
    if (auto file = std::filesystem::path(folder) / name; !folder.empty() && access(file.c_str(), X_OK) == 0)
      return file;
  return {};
}

} // namespace bem_contact
