#include "bem_contact/app/sweep/child_processes.hpp"

#include "bem_contact/base/error.hpp"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fmt/format.h>
#include <thread>

namespace bem_contact::app {

std::size_t processes_of(int jobs) {
  return jobs > 0 ? static_cast<std::size_t>(jobs) : std::max(1U, std::thread::hardware_concurrency());
}

ChildProcesses::~ChildProcesses() {
  for (const auto& [process, cases] : started_)
    kill(process, SIGKILL);
  for (const auto& [process, cases] : started_)
    while (waitpid(process, nullptr, 0) < 0 && errno == EINTR) {
    }
}

namespace {

/// All that a child process does. tools/checks/nothing_worse knows it by this name: callgrind gives a process
/// what its parent had done before, and counts anew from here on.
[[noreturn]] [[gnu::noinline]] void do_in_child_process(pid_t parent, const std::function<int()>& work) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent)
    _exit(1);
  close_range(STDERR_FILENO + 1, ~0U, 0); // above all the lock, which must end with its owner
  _exit(work());
}

} // namespace

void ChildProcesses::start(CaseRange cases, const std::function<int()>& work) {
  const pid_t parent = getpid(), process = fork();
  if (process < 0) // never kept: kill(-1) would end every process of the user
    throw Error("No process to solve cases can be started", std::strerror(errno),
                "Give a smaller --jobs, or end other programs.");
  if (process == 0)
    do_in_child_process(parent, work);
  started_[process] = cases;
}

EndOfChild ChildProcesses::wait() {
  for (;;) {
    int status = 0;
    const pid_t process = waitpid(-1, &status, 0);
    const auto found = started_.find(process);
    if (process < 0 && errno != EINTR) {
      started_.clear(); // somebody else has waited for them
      throw Error("A process that solves cases was lost", std::strerror(errno),
                  "Give the same command again.");
    }
    if (found == started_.end())
      continue;
    const CaseRange cases = found->second;
    started_.erase(found);
    if (WIFSIGNALED(status))
      return {cases, -1,
              fmt::format("the process that solved it was ended by signal {} ({})", WTERMSIG(status),
                          strsignal(WTERMSIG(status)))};
    const int code = WEXITSTATUS(status);
    return {cases, code, fmt::format("the process that solved it ended with code {}", code)};
  }
}

} // namespace bem_contact::app
