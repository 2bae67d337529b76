#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace bem_contact::fem {

/// The processes that run on one machine. The first of them can give the others what it has, in memory that
/// all of them see. Made and destroyed by all processes together.
class MachineGroup {
public:
  MachineGroup();
  ~MachineGroup();
  MachineGroup(const MachineGroup&) = delete;
  MachineGroup& operator=(const MachineGroup&) = delete;

  int rank() const;       ///< of this process in the group
  int count() const;      ///< of the group's processes
  int first_rank() const; ///< of the group's first process among all processes

  /// All of the group together: the first one's value goes to all. Spans are equally long on each.
  void broadcast(std::span<std::byte> bytes) const;
  template <class T> void broadcast(T& number) const {
    broadcast(std::as_writable_bytes(std::span(&number, 1)));
  }
  template <class T> void broadcast(std::vector<T>& array) const {
    std::size_t size = array.size();
    broadcast(size);
    array.resize(size);
    broadcast(std::as_writable_bytes(std::span(array)));
  }

  /// All of the group together, once: memory that all of them see while the group exists. The first one's
  /// `bytes` counts. Empty where the machine has no room for it.
  std::span<std::byte> memory(std::size_t bytes);
  /// The first process tells the others, once, whether what they wait for is in the memory (false: it will
  /// never be there). Nobody waits in this function.
  void announce(bool there);
  /// What the first process announces; the others wait here until it does.
  bool wait();

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace bem_contact::fem
