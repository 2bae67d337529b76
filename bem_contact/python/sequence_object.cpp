#include "bem_contact/python/sequence_object.hpp"

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <future>
#include <mutex>
#include <thread>
#include <utility>

namespace py = pybind11;

namespace bem_contact {

namespace {

using Result = std::shared_ptr<const SceneResult>;

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

PythonSequence::PythonSequence(PythonScene scene)
    : shared_(std::make_shared<Shared>(Shared{std::move(scene), Sequence()})) {}

Result PythonSequence::solve(std::vector<SceneChange> changes, std::string model) const {
  const auto stop = std::make_shared<std::atomic<bool>>(false);
  std::packaged_task<Result()> task(
      [stop, shared = shared_, changes = std::move(changes), model = std::move(model)]() -> Result {
        SceneFile scene = parse_scene_file(shared->scene.text, shared->scene.source, changes);
        scene.folder = shared->scene.folder;
        if (!model.empty())
          scene = with_model(std::move(scene), model_named(model));
        return std::make_shared<const SceneResult>(shared->sequence.solve(scene, stop.get()));
      });
  std::future<Result> result = task.get_future();
  bool interrupted = false;
  {
    const py::gil_scoped_release others_may_run;
    std::thread solver(std::move(task));
    while (!interrupted && result.wait_for(look_every) == std::future_status::timeout)
      interrupted = signal_came();
    *stop = interrupted;
    if (!interrupted || result.wait_for(grace) == std::future_status::ready)
      solver.join();
    else
      Stopping::all().add(std::move(solver));
  }
  if (interrupted)
    throw py::error_already_set();
  return result.get();
}

void end_stopped_solutions() {
  const py::gil_scoped_release others_may_run;
  const std::lock_guard lock(Stopping::all().mutex);
  for (std::thread& thread : Stopping::all().threads)
    thread.join();
  Stopping::all().threads.clear();
}

} // namespace bem_contact
