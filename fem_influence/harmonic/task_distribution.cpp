#include "fem_influence/harmonic/task_distribution.hpp"

#include "fem_influence/shared/parallel.hpp"

#include <mpi.h>

#include <deque>
#include <exception>
#include <optional>

namespace bem_contact::fem {

struct SharedCounters::Impl {
  long long* memory = nullptr;
  MPI_Win window = MPI_WIN_NULL;
};

SharedCounters::SharedCounters() : impl_(std::make_unique<Impl>()) {
  auto& [memory, window] = *impl_;
  MPI_Win_allocate(process_rank() == 0 ? 2 * sizeof(long long) : 0, sizeof(long long), MPI_INFO_NULL,
                   MPI_COMM_WORLD, &memory, &window);
  if (process_rank() == 0) {
    MPI_Win_lock(MPI_LOCK_EXCLUSIVE, 0, 0, window);
    memory[0] = memory[1] = 0;
    MPI_Win_unlock(0, window);
  }
  MPI_Barrier(MPI_COMM_WORLD);
  MPI_Win_lock_all(0, window);
}

SharedCounters::~SharedCounters() {
  MPI_Win_unlock_all(impl_->window);
  MPI_Win_free(&impl_->window);
}

std::size_t SharedCounters::add(int counter, std::size_t step) {
  const auto mine = static_cast<long long>(step);
  long long before = 0;
  MPI_Fetch_and_op(&mine, &before, MPI_LONG_LONG, 0, counter, MPI_SUM, impl_->window);
  MPI_Win_flush(0, impl_->window);
  return static_cast<std::size_t>(before);
}

namespace {

using Work = std::function<std::vector<double>(std::size_t)>;
using Collect = std::function<void(std::size_t, std::vector<double>)>;

constexpr int result_tag = 1, done_tag = 2;

/// The next task that no process has begun; none: all have been begun.
std::optional<std::size_t> next_task(SharedCounters& counters, const TaskOrder& order) {
  const int preferred = order.begins_with_second ? 1 : 0;
  for (const int kind : {preferred, 1 - preferred}) {
    const std::size_t from = kind == 0 ? 0 : order.second, to = kind == 0 ? order.second : order.count;
    if (from < to)
      if (const std::size_t task = from + counters.add(kind, 1); task < to)
        return task;
  }
  return std::nullopt;
}

/// The first exception of this process. From then on no process begins another task.
class Failure {
public:
  Failure(SharedCounters& counters, std::size_t tasks) : counters_(counters), tasks_(tasks) {}
  explicit operator bool() const { return failure_ != nullptr; }
  /// Runs `step`, unless one has failed already.
  template <class Step> void guard(Step&& step) {
    if (failure_)
      return;
    try {
      step();
    } catch (...) {
      failure_ = std::current_exception();
      counters_.add(0, tasks_);
      counters_.add(1, tasks_);
    }
  }
  void rethrow() const {
    if (failure_)
      std::rethrow_exception(failure_);
  }

private:
  SharedCounters& counters_;
  std::size_t tasks_;
  std::exception_ptr failure_;
};

/// Results on their way from another process to the first one, for which nobody waits.
class Outbox {
public:
  void send(std::size_t task, std::vector<double> result) {
    forget_received();
    result.push_back(static_cast<double>(task));
    Message& message = sent_.emplace_back(std::move(result));
    MPI_Isend(message.numbers.data(), static_cast<int>(message.numbers.size()), MPI_DOUBLE, 0, result_tag,
              MPI_COMM_WORLD, &message.request);
  }
  /// Waits until all have arrived and says that no other follows.
  void close() {
    for (Message& message : sent_)
      MPI_Wait(&message.request, MPI_STATUS_IGNORE);
    MPI_Send(nullptr, 0, MPI_DOUBLE, 0, done_tag, MPI_COMM_WORLD);
  }

private:
  struct Message {
    std::vector<double> numbers;
    MPI_Request request = MPI_REQUEST_NULL;
  };
  void forget_received() {
    for (int received = 1; !sent_.empty() && received;) {
      MPI_Test(&sent_.front().request, &received, MPI_STATUS_IGNORE);
      if (received)
        sent_.pop_front();
    }
  }
  std::deque<Message> sent_;
};

/// Results of the other processes as the first one takes them.
class Inbox {
public:
  /// collect(task, result) for all results that are there; `all`: that are still to come as well.
  void receive(bool all, const Collect& collect) {
    while (working_ > 0) {
      MPI_Status status;
      int there = 1;
      if (all)
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
      if (status.MPI_TAG == done_tag) {
        --working_;
      } else {
        const auto task = static_cast<std::size_t>(message.back());
        message.pop_back();
        collect(task, std::move(message));
      }
    }
  }

private:
  int working_ = process_count() - 1;
};

} // namespace

void distribute(SharedCounters& counters, const TaskOrder& order, const Work& work, const Collect& collect) {
  Failure failure(counters, order.count);
  const bool first = process_rank() == 0;
  Inbox inbox;
  Outbox outbox;
  const Collect collect_unless_failed = [&](std::size_t task, std::vector<double> result) {
    failure.guard([&] { collect(task, std::move(result)); });
  };
  while (const auto task = next_task(counters, order)) {
    std::vector<double> result;
    failure.guard([&] {
      result = work(*task);
      if (first)
        collect(*task, std::move(result));
    });
    if (first)
      inbox.receive(false, collect_unless_failed);
    else if (!failure)
      outbox.send(*task, std::move(result));
  }
  if (first)
    inbox.receive(true, collect_unless_failed);
  else
    outbox.close();
  together([&] { failure.rethrow(); });
}

} // namespace bem_contact::fem
