#include "bem_contact/python/stoppable.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/system/forks.hpp"

#include <chrono>
#include <condition_variable>
#include <future>
#include <mutex>
#include <new>
#include <thread>

namespace py = pybind11;

namespace bem_contact {

namespace {

/// How often the calling thread looks for Ctrl-C, and how long it lets a stopped solution end by itself: both
/// well below the tenth of a second in which nobody notices a delay.
constexpr std::chrono::milliseconds look_every{20}, grace{40};

/// How long the end of Python waits for calls that do not solve: a profile is read in a hundredth of it.
constexpr std::chrono::seconds longest_call{5};

/// What all calls have in common.
struct Calls {
  std::mutex mutex;
  std::condition_variable changed;
  int away = 0;    ///< threads without Python's lock that will ask for it
  int inside = 0;  ///< calls of functions of this module that have not returned
  int solving = 0; ///< threads that solve, those that were stopped and have not noticed among them
  bool python_ends = false;
  std::thread::id ender;
  bool forked = false; ///< while a thread was solving, which this process does not have

  template <class Change> void change(const Change& change) {
    const std::lock_guard lock(mutex);
    change();
    changed.notify_all();
  }
};

/// Never destroyed: threads may need it to the very end of the process.
Calls& calls() {
  alignas(Calls) static std::byte place[sizeof(Calls)];
  static Calls* const made = new (place) Calls;
  return *made;
}

/// Of a daemon thread when Python ends.
[[noreturn]] void stay_here() {
  for (;;)
    std::this_thread::sleep_for(std::chrono::hours(1));
}

/// Whether Ctrl-C, or another signal whose handler raises, has come; Python's exception is then set.
bool signal_came() {
  const py::gil_scoped_acquire python;
  return PyErr_CheckSignals() != 0;
}

/// Not for the thread that ends Python: functions that it calls on its way (atexit) may solve.
bool python_ends() {
  const std::lock_guard lock(calls().mutex);
  return calls().python_ends && calls().ender != std::this_thread::get_id();
}

struct Solving {
  Solving() {
    calls().change([] { ++calls().solving; });
  }
  ~Solving() {
    calls().change([] { --calls().solving; });
  }
  Solving(const Solving&) = delete;
  Solving& operator=(const Solving&) = delete;
};

/// Whoever solves in another process of this one may hold locks that nobody gives back here.
void refuse_forked() {
  const std::lock_guard lock(calls().mutex);
  if (calls().forked)
    throw Error("Nothing can be solved in this process", "it was forked while another thread was solving",
                "Fork before that, or start processes by multiprocessing.get_context(\"spawn\").");
}

} // namespace

CallFromPython::CallFromPython() {
  if (python_ends()) {
    PyEval_SaveThread();
    stay_here();
  }
  calls().change([] { ++calls().inside; });
}

CallFromPython::~CallFromPython() {
  calls().change([] { --calls().inside; });
}

OthersMayRun::OthersMayRun() {
  calls().change([] { ++calls().away; });
  released_.emplace();
}

OthersMayRun::~OthersMayRun() {
  if (python_ends()) {
    calls().change([] { --calls().away, --calls().inside; });
    stay_here();
  }
  released_.reset(); // until this thread has the lock, end_all_solutions() waits
  calls().change([] { --calls().away; });
}

void run_stoppable(std::function<void(const std::atomic<bool>*)> work) {
  refuse_forked();
  const auto stop = std::make_shared<std::atomic<bool>>(false);
  std::packaged_task<void()> task([stop, work = std::move(work)] { work(stop.get()); });
  std::future<void> done = task.get_future();
  bool interrupted = false;
  {
    const OthersMayRun others_may_run;
    // What counts the thread is destroyed in it, with all that the task owns.
    std::thread solver([counted = std::make_shared<Solving>(), task = std::move(task)]() mutable { task(); });
    while (!interrupted && !*stop && done.wait_for(look_every) == std::future_status::timeout) {
      *stop = python_ends();
      interrupted = !*stop && signal_came();
    }
    if (interrupted)
      *stop = true;
    !*stop || done.wait_for(grace) == std::future_status::ready ? solver.join() : solver.detach();
  }
  if (interrupted)
    throw py::error_already_set();
  done.get();
}

void end_all_solutions() {
  const py::gil_scoped_release others_may_run;
  calls().change([] { calls().python_ends = true, calls().ender = std::this_thread::get_id(); });
  std::unique_lock lock(calls().mutex);
  calls().changed.wait(lock, [] { return calls().away == 0 && calls().solving == 0; });
  // One may wait in a function of the caller for what never comes.
  calls().changed.wait_for(lock, longest_call, [] { return calls().inside <= 0; });
}

void watch_forks() {
  system::watch_forks([] { calls().mutex.lock(); }, [] { calls().mutex.unlock(); },
                      [] {
                        const bool solving = calls().solving > 0 || calls().forked;
                        new (&calls()) Calls; // no other thread is here
                        calls().forked = solving;
                      });
}

} // namespace bem_contact
