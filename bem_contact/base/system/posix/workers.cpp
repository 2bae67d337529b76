#include "bem_contact/base/workers.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/system/posix/close_others.hpp"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fmt/format.h>
#include <map>
#include <utility>

namespace bem_contact {

struct Workers::Started {
  std::map<pid_t, std::size_t> numbers;
};

namespace {

/// All that a child process does. tools/checks/nothing_worse knows it by this name: callgrind gives a process
/// what its parent had done before, and counts anew from here on.
[[noreturn]] [[gnu::noinline]] void do_in_child_process(pid_t parent, const std::filesystem::path& temporary,
                                                        const std::function<int()>& work) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent)
    _exit(1);
  system::close_others(system::CloseOthers::now); // above all the lock, which must end with its owner
  if (!temporary.empty())
    setenv("TMPDIR", temporary.c_str(), 1);
  _exit(work());
}

} // namespace

Workers::Workers(std::filesystem::path temporary)
    : temporary_(std::move(temporary)), started_(std::make_unique<Started>()) {}

Workers::~Workers() {
  for (const auto& [process, number] : started_->numbers)
    kill(process, SIGKILL);
  for (const auto& [process, number] : started_->numbers)
    while (waitpid(process, nullptr, 0) < 0 && errno == EINTR) {
    }
}

std::size_t Workers::size() const {
  return started_->numbers.size();
}

void Workers::start(std::size_t number, const std::function<int()>& work) {
  const pid_t parent = getpid(), process = fork();
  if (process < 0) // never kept: kill(-1) would end every process of the user
    throw Error("No process to solve cases can be started", std::strerror(errno),
                "Give a smaller --jobs, or end other programs.");
  if (process == 0)
    do_in_child_process(parent, temporary_, work);
  started_->numbers[process] = number;
}

EndOfWork Workers::wait() {
  for (;;) {
    int status = 0;
    const pid_t process = waitpid(-1, &status, 0);
    const auto found = started_->numbers.find(process);
    if (process < 0 && errno != EINTR) {
      started_->numbers.clear(); // somebody else has waited for them
      throw Error("A process that solves cases was lost", std::strerror(errno),
                  "Give the same command again.");
    }
    if (found == started_->numbers.end())
      continue;
    const std::size_t number = found->second;
    started_->numbers.erase(found);
    if (WIFSIGNALED(status))
      return {number, -1,
              fmt::format("the process that solved it was ended by signal {} ({})", WTERMSIG(status),
                          strsignal(WTERMSIG(status)))};
    const int code = WEXITSTATUS(status);
    return {number, code, fmt::format("the process that solved it ended with code {}", code)};
  }
}

} // namespace bem_contact
