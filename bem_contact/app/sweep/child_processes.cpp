#include "bem_contact/app/sweep/child_processes.hpp"

#include <algorithm>
#include <thread>

namespace bem_contact::app {

std::size_t processes_of(int jobs) {
  return jobs > 0 ? static_cast<std::size_t>(jobs) : std::max(1U, std::thread::hardware_concurrency());
}

void ChildProcesses::start(CaseRange cases, const std::function<int()>& work) {
  workers_.start(cases.first, work);
  cases_[cases.first] = cases;
}

EndOfChild ChildProcesses::wait() {
  const EndOfWork end = workers_.wait();
  return {cases_.extract(end.number).mapped(), end.code, end.how};
}

} // namespace bem_contact::app
