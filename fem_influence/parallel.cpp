#include "fem_influence/parallel.hpp"

#include <mpi.h>

namespace bem_contact::fem {

int process_rank() {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}

int process_count() {
  int count = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &count);
  return count;
}

void together(const std::function<void()>& work) {
  std::exception_ptr failure;
  try {
    work();
  } catch (...) {
    failure = std::current_exception();
  }
  const int none = process_count();
  int mine = failure ? process_rank() : none, lowest = none;
  MPI_Allreduce(&mine, &lowest, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
  if (lowest == none)
    return;
  if (lowest == process_rank())
    std::rethrow_exception(failure);
  throw FellowFailed();
}

namespace {

constexpr int result_tag = 1, done_tag = 2;

/// A counter in the first process's memory that every process takes the next number from.
class SharedCounter {
public:
  SharedCounter() {
    MPI_Win_allocate(process_rank() == 0 ? sizeof(long long) : 0, sizeof(long long), MPI_INFO_NULL,
                     MPI_COMM_WORLD, &memory_, &window_);
    if (process_rank() == 0) {
      MPI_Win_lock(MPI_LOCK_EXCLUSIVE, 0, 0, window_);
      *memory_ = 0;
      MPI_Win_unlock(0, window_);
    }
    MPI_Barrier(MPI_COMM_WORLD);
    MPI_Win_lock_all(0, window_);
  }
  ~SharedCounter() {
    MPI_Win_unlock_all(window_);
    MPI_Win_free(&window_);
  }
  SharedCounter(const SharedCounter&) = delete;
  SharedCounter& operator=(const SharedCounter&) = delete;

  /// The number before `step` is added.
  std::size_t add(std::size_t step) {
    const auto mine = static_cast<long long>(step);
    long long before = 0;
    MPI_Fetch_and_op(&mine, &before, MPI_LONG_LONG, 0, 0, MPI_SUM, window_);
    MPI_Win_flush(0, window_);
    return static_cast<std::size_t>(before);
  }

private:
  long long* memory_ = nullptr;
  MPI_Win window_ = MPI_WIN_NULL;
};

} // namespace

void distribute(std::size_t count, const std::function<std::vector<double>(std::size_t)>& work,
                const std::function<void(std::size_t, std::span<const double>)>& collect) {
  SharedCounter next;
  std::exception_ptr failure;
  const auto guarded = [&](auto&& step) {
    if (failure)
      return;
    try {
      step();
    } catch (...) {
      failure = std::current_exception();
      next.add(count); // nobody begins another task
    }
  };
  int working = process_count() - 1; // fellows, on the first process
  const auto receive = [&](bool wait) {
    for (int there = 1; working > 0 && there;) {
      MPI_Status status;
      if (wait)
        MPI_Probe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &status);
      else
        MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &status);
      if (!there)
        return;
      int size = 0;
      MPI_Get_count(&status, MPI_DOUBLE, &size);
      std::vector<double> message(static_cast<std::size_t>(size));
      MPI_Recv(message.data(), size, MPI_DOUBLE, status.MPI_SOURCE, status.MPI_TAG, MPI_COMM_WORLD,
               MPI_STATUS_IGNORE);
      if (status.MPI_TAG == done_tag)
        --working;
      else
        guarded([&] {
          collect(static_cast<std::size_t>(message.back()),
                  std::span<const double>(message).first(message.size() - 1));
        });
    }
  };

  const bool first = process_rank() == 0;
  std::vector<double> sent;
  MPI_Request request = MPI_REQUEST_NULL;
  for (std::size_t task = next.add(1); task < count; task = next.add(1)) {
    std::vector<double> result;
    guarded([&] {
      result = work(task);
      if (first)
        collect(task, result);
    });
    if (first) {
      receive(false);
    } else if (!failure) {
      MPI_Wait(&request, MPI_STATUS_IGNORE);
      sent = std::move(result);
      sent.push_back(static_cast<double>(task));
      MPI_Isend(sent.data(), static_cast<int>(sent.size()), MPI_DOUBLE, 0, result_tag, MPI_COMM_WORLD,
                &request);
    }
  }
  if (first) {
    receive(true);
  } else {
    MPI_Wait(&request, MPI_STATUS_IGNORE);
    MPI_Send(nullptr, 0, MPI_DOUBLE, 0, done_tag, MPI_COMM_WORLD);
  }
  together([&] {
    if (failure)
      std::rethrow_exception(failure);
  });
}

} // namespace bem_contact::fem
