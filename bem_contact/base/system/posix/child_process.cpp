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

/// For exec(), made before there is a child, because a child of several threads may not allocate.
class Pointers {
public:
  explicit Pointers(std::vector<std::string> texts) : texts_(std::move(texts)) {
    pointers_.reserve(texts_.size() + 1);
    for (std::string& text : texts_)
      pointers_.push_back(text.data());
    pointers_.push_back(nullptr);
  }
  Pointers(const Pointers&) = delete;
  Pointers& operator=(const Pointers&) = delete;

  char** data() { return pointers_.data(); }

private:
  std::vector<std::string> texts_;
  std::vector<char*> pointers_;
};

std::vector<std::string> environment_with(const ChildWork& work) {
  std::vector<std::string> out;
  for (char** one = environ; *one; ++one)
    out.emplace_back(*one);
  for (const auto& variable : work.variables) {
    const std::string begin = variable.first + "=";
    std::erase_if(out, [&](const std::string& one) { return one.starts_with(begin); });
    out.push_back(begin + variable.second);
  }
  return out;
}

void begin_as_child(pid_t parent, int output, int errors) {
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent)
    _exit(1);
  dup2(output, STDOUT_FILENO);
  dup2(errors, STDERR_FILENO);
}

[[noreturn]] void do_here(const ChildWork& work, char** variables) {
  environ = variables;
  const int code = work.here();
  std::fflush(nullptr);
  std::cout.flush();
  _exit(code);
}

/// `failed`: the end of a pipe that the program no longer has. A normal end takes locks that other threads
/// may have held.
[[noreturn]] void become_other(char** words, char** variables, int failed) {
  environ = variables;
  system::close_others(system::CloseOthers::as_another_program_begins);
  execvp(words[0], words);
  const int why = errno;
  static_cast<void>(!write(failed, &why, sizeof why));
  _exit(1);
}

} // namespace

struct ChildProcess::Started {
  pid_t process = -1;
  int messages = -1;
  std::string why_not;
};

ChildProcess::ChildProcess(const std::filesystem::path& text, const ChildWork& work)
    : started_(std::make_unique<Started>()) {
  std::fflush(stdout);
  std::cout.flush();
  Pointers words(work.words), variables(environment_with(work));
  int messages[2] = {-1, -1}, failed[2] = {-1, -1};
  const int file = open(text.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  const bool ready = file >= 0 && pipe2(messages, O_CLOEXEC) == 0 && pipe2(failed, O_CLOEXEC) == 0;
  const pid_t parent = getpid();
  {
    const HeldSignals held;
    started_->process = ready ? fork() : -1;
    if (started_->process == 0) {
      held.let_go_in_child();
      begin_as_child(parent, file, messages[1]);
      for (const int end : {messages[0], messages[1], failed[0]})
        close(end);
      if (!work.here)
        become_other(words.data(), variables.data(), failed[1]);
      close(failed[1]);
      do_here(work, variables.data());
    }
  }
  const std::string why = std::strerror(errno);
  for (const int end : {file, messages[1], failed[1]})
    close(end);
  started_->messages = messages[0];
  int code = 0;
  ssize_t count = 0;
  while (started_->process > 0 && (count = read(failed[0], &code, sizeof code)) < 0 && errno == EINTR) {
  }
  if (count == sizeof code)
    started_->why_not = std::strerror(code);
  close(failed[0]);
  if (started_->process < 0) {
    close(messages[0]);
    throw Error("No other process can be started", why,
                "End other programs, or look at the folder's rights.");
  }
}

ChildProcess::~ChildProcess() {
  close(started_->messages);
  if (started_->process > 0) {
    kill(started_->process, SIGTERM);
    std::string how;
    wait(how);
  }
}

const std::string& ChildProcess::why_not_started() const {
  return started_->why_not;
}

ChildProcess::Read ChildProcess::read_more(int patience) {
  pollfd ready{.fd = started_->messages, .events = POLLIN, .revents = 0};
  if (patience >= 0 && poll(&ready, 1, patience) == 0)
    return Read::nothing_yet;
  char bytes[4096];
  ssize_t count = 0;
  while ((count = read(started_->messages, bytes, sizeof bytes)) < 0 && errno == EINTR) {
  }
  if (count <= 0)
    return Read::end;
  rest_.append(bytes, static_cast<std::size_t>(count));
  return Read::bytes;
}

int ChildProcess::wait(std::string& how) {
  int status = 0;
  while (waitpid(started_->process, &status, 0) < 0 && errno == EINTR) {
  }
  started_->process = -1;
  if (!started_->why_not.empty()) {
    how = "it cannot be started: " + started_->why_not;
    return -1;
  }
  if (!WIFSIGNALED(status))
    return WEXITSTATUS(status);
  how = fmt::format("signal {}, {}", WTERMSIG(status), strsignal(WTERMSIG(status)));
  return -1;
}

void become_program(const std::vector<std::string>& words) {
  Pointers pointers(words);
  system::close_others(system::CloseOthers::as_another_program_begins);
  execvp(pointers.data()[0], pointers.data());
}

bool run_and_wait(const std::vector<std::string>& words, std::string& why) {
  Pointers arguments(words);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
  pid_t process = 0;
  int status = 0;
  const int failed =
      posix_spawnp(&process, arguments.data()[0], &actions, nullptr, arguments.data(), environ);
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
