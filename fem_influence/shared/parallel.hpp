#pragma once

#include <cstddef>
#include <exception>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace bem_contact::fem {

/// This process among those of MPI_COMM_WORLD; MPI must be initialised.
int process_rank();
int process_count();

/// Thrown on the processes whose fellow failed; that one reports the error itself.
class FellowFailed : public std::exception {
public:
  const char* what() const noexcept override { return "another process failed and says why"; }
};

/// Runs `work` on every process and waits for all of them. Where it throws on some, the lowest of those
/// rethrows and all others throw FellowFailed: nobody is left waiting.
void together(const std::function<void()>& work);

/// The processes of one machine: the first of them can give the others what it has, which there costs little.
/// Made and destroyed by all processes together.
class Fellows {
public:
  Fellows();
  ~Fellows();
  Fellows(const Fellows&) = delete;
  Fellows& operator=(const Fellows&) = delete;

  int rank() const; ///< among the fellows
  int count() const;
  int first() const; ///< the first one's rank among all processes

  /// Together; bytes of the first one, as many on each.
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

  /// Together, once; memory that all of them see, until the fellows are destroyed. `bytes` of the first one
  /// counts. Empty where the machine has no room for it.
  std::span<std::byte> memory(std::size_t bytes);
  /// The first one's word that what the others wait for is in the memory, or that it will never be.
  void announce(bool there);
  /// The others wait for that word; false: never.
  bool wait();

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

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

/// Tasks 0 .. count-1, each done by whichever process is free next, lower ones first; a process that
/// `begins_with_second` takes those from `second` on before the others. What `work` gives comes
/// to `collect` on the first process, in any order and as soon as that one is between two tasks of its own.
/// Called by all processes with fresh counters; nobody waits for another to begin. Fails as together() does;
/// then no further task is begun.
void distribute(SharedCounters& counters, std::size_t count, std::size_t second, bool begins_with_second,
                const std::function<std::vector<double>(std::size_t)>& work,
                const std::function<void(std::size_t, std::vector<double>)>& collect);

} // namespace bem_contact::fem
