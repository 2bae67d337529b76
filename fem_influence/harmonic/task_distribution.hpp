#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace bem_contact::fem {

/// Two counters in the first process's memory that every process takes the next number from. Made and
/// destroyed by all processes together, so made where they are together anyway.
class SharedCounters {
public:
  SharedCounters();
  ~SharedCounters();
  SharedCounters(const SharedCounters&) = delete;
  SharedCounters& operator=(const SharedCounters&) = delete;

  /// The number before `step` is added.
  std::size_t add(int counter, std::size_t step);

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Tasks 0 .. count - 1 of two kinds: 0 .. second - 1 and second .. count - 1.
struct TaskOrder {
  std::size_t count = 0, second = 0;
  bool begins_with_second = false; ///< this process does tasks of the second kind before those of the first
};

/// Does all tasks, each by whichever process is free next, those with lower numbers first. What `work`
/// returns goes to `collect` on the first process, in any order and as soon as that one is between two tasks
/// of its own. Called by all processes with fresh counters; nobody waits for another to begin. Fails as
/// together() does; no further task is begun then.
void distribute(SharedCounters& counters, const TaskOrder& order,
                const std::function<std::vector<double>(std::size_t task)>& work,
                const std::function<void(std::size_t task, std::vector<double> result)>& collect);

} // namespace bem_contact::fem
