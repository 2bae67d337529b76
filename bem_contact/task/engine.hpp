#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace bem_contact::task {

/// A pure function that each process with this library finds by its name. What it is asked and what it
/// answers are bytes (packing.hpp). `common`: the same for all portions of some work.
struct Task {
  const char* name;
  std::string (*run)(const std::string& common, const std::string& portion, const std::atomic<bool>* stop);
};
/// Throws Error where there is none.
const Task& task_named(std::string_view name);

/// Much work of one task.
struct Portions {
  const Task& task;
  std::string common;                           ///< may be long: the text of a scene
  std::vector<std::string> asked = {};          ///< of each portion
  std::function<std::string(std::size_t)> name; ///< of a portion, in a message
  /// Gets the answer of each portion as soon as it is there, in any order.
  std::function<void(std::size_t portion, const std::string& answer)> take;

  std::string answer(std::size_t portion, const std::atomic<bool>* stop) const {
    return task.run(common, asked[portion], stop);
  }
};

/// Has every portion answered, side by side or not. Throws what a portion throws.
using Engine = std::function<void(const Portions&)>;

/// One portion after the other, in this process. `stop`: as Sequence::solve().
Engine here(const std::atomic<bool>* stop = nullptr);
/// In `jobs` processes side by side, which end with this one; 0: one for each core. Throws ConvergenceError
/// where one dies.
Engine in_children(int jobs);

/// How many processes --jobs means; 0: one for each core.
std::size_t processes_of(int jobs);

} // namespace bem_contact::task
