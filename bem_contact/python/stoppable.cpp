#include "bem_contact/python/stoppable.hpp"

#include <pybind11/pybind11.h>

#include <chrono>
#include <future>
#include <mutex>
#include <thread>
#include <vector>

namespace py = pybind11;

namespace bem_contact {

namespace {

/// How often the calling thread looks for Ctrl-C, and how long it lets a stopped solution end by itself: both
/// well below the tenth of a second in which nobody notices a delay.
constexpr std::chrono::milliseconds look_every{20}, grace{40};

/// Solutions that were stopped and have not noticed yet. Python must not end before them.
struct Stopping {
  std::mutex mutex;
  std::vector<std::thread> threads;

  static Stopping& all() {
    static Stopping stopping;
    return stopping;
  }
  void add(std::thread thread) {
    const std::lock_guard lock(mutex);
    threads.push_back(std::move(thread));
  }
};

/// Whether Ctrl-C, or another signal whose handler raises, has come; Python's exception is then set.
bool signal_came() {
  const py::gil_scoped_acquire python;
  return PyErr_CheckSignals() != 0;
}

} // namespace

void run_stoppable(std::function<void(const std::atomic<bool>*)> work) {
  const auto stop = std::make_shared<std::atomic<bool>>(false);
  std::packaged_task<void()> task([stop, work = std::move(work)] { work(stop.get()); });
  std::future<void> done = task.get_future();
  bool interrupted = false;
  {
    const py::gil_scoped_release others_may_run;
    std::thread solver(std::move(task));
    while (!interrupted && done.wait_for(look_every) == std::future_status::timeout)
      interrupted = signal_came();
    *stop = interrupted;
    if (!interrupted || done.wait_for(grace) == std::future_status::ready)
      solver.join();
    else
      Stopping::all().add(std::move(solver));
  }
  if (interrupted)
    throw py::error_already_set();
  done.get();
}

void end_stopped_solutions() {
  const py::gil_scoped_release others_may_run;
  const std::lock_guard lock(Stopping::all().mutex);
  for (std::thread& thread : Stopping::all().threads)
    thread.join();
  Stopping::all().threads.clear();
}

} // namespace bem_contact
