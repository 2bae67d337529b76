#include "fem_influence/parallel.hpp"

#include <mpi.h>

#include <algorithm>
#include <deque>

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

struct Fellows::Impl {
  MPI_Comm together = MPI_COMM_NULL;
  int rank = 0, count = 1, first = 0;
  std::vector<int> busy, numbers;    // busy: [fellow], on the first one
  std::vector<MPI_Request> requests; // of send(), of expect()
};

Fellows::Fellows(bool busy) : impl_(std::make_unique<Impl>()) {
  auto& [together, rank, count, first, all_busy, numbers, requests] = *impl_;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &together);
  MPI_Comm_rank(together, &rank);
  MPI_Comm_size(together, &count);
  const int mine = process_rank(), is_busy = busy;
  MPI_Allreduce(&mine, &first, 1, MPI_INT, MPI_MIN, together);
  all_busy.resize(static_cast<std::size_t>(count));
  MPI_Gather(&is_busy, 1, MPI_INT, all_busy.data(), 1, MPI_INT, 0, together);
}

Fellows::~Fellows() {
  MPI_Waitall(static_cast<int>(impl_->requests.size()), impl_->requests.data(), MPI_STATUSES_IGNORE);
  MPI_Comm_free(&impl_->together);
}

int Fellows::rank() const {
  return impl_->rank;
}
int Fellows::count() const {
  return impl_->count;
}
int Fellows::first() const {
  return impl_->first;
}

void Fellows::broadcast(std::span<std::byte> bytes) const {
  constexpr std::size_t most = std::size_t{1} << 30; // MPI counts in int
  for (std::size_t from = 0; from < bytes.size(); from += most) {
    const auto part = bytes.subspan(from, std::min(most, bytes.size() - from));
    MPI_Bcast(part.data(), static_cast<int>(part.size()), MPI_BYTE, 0, impl_->together);
  }
}

void Fellows::send(std::vector<int> numbers) {
  impl_->numbers = std::move(numbers);
  for (int to = 1; to < impl_->count; ++to)
    MPI_Isend(impl_->numbers.data(), static_cast<int>(impl_->numbers.size()), MPI_INT, to, 0, impl_->together,
              &impl_->requests.emplace_back(MPI_REQUEST_NULL));
  for (std::size_t to = 1; to < impl_->busy.size(); ++to)
    if (!impl_->busy[to])
      MPI_Wait(&impl_->requests[to - 1], MPI_STATUS_IGNORE);
}

void Fellows::expect(std::size_t size) {
  impl_->numbers.resize(size);
  MPI_Irecv(impl_->numbers.data(), static_cast<int>(size), MPI_INT, 0, 0, impl_->together,
            &impl_->requests.emplace_back(MPI_REQUEST_NULL));
}

const std::vector<int>& Fellows::received() {
  if (rank() > 0) // the first one has them at once, whether the others took them or not
    MPI_Waitall(static_cast<int>(impl_->requests.size()), impl_->requests.data(), MPI_STATUSES_IGNORE);
  return impl_->numbers;
}

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
constexpr int result_tag = 1, done_tag = 2;
}

void distribute(SharedCounters& counters, std::size_t count, std::size_t second, bool begins_with_second,
                const std::function<std::vector<double>(std::size_t)>& work,
                const std::function<void(std::size_t, std::span<const double>)>& collect) {
  const auto next = [&] {
    std::size_t task = count;
    for (const int which : {begins_with_second ? 1 : 0, begins_with_second ? 0 : 1}) {
      const std::size_t from = which == 0 ? 0 : second, to = which == 0 ? second : count;
      if (task == count && from < to)
        if (const std::size_t at = from + counters.add(which, 1); at < to)
          task = at;
    }
    return task;
  };
  std::exception_ptr failure;
  const auto guarded = [&](auto&& step) {
    if (failure)
      return;
    try {
      step();
    } catch (...) {
      failure = std::current_exception();
      counters.add(0, count); // nobody begins another task
      counters.add(1, count);
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
  // The first process listens between two tasks of its own, and others do not wait for it.
  struct Message {
    std::vector<double> numbers;
    MPI_Request request = MPI_REQUEST_NULL;
  };
  std::deque<Message> sent;
  for (std::size_t task = next(); task < count; task = next()) {
    std::vector<double> result;
    guarded([&] {
      result = work(task);
      if (first)
        collect(task, result);
    });
    if (first) {
      receive(false);
    } else if (!failure) {
      for (int gone = 1; !sent.empty() && gone;) {
        MPI_Test(&sent.front().request, &gone, MPI_STATUS_IGNORE);
        if (gone)
          sent.pop_front();
      }
      result.push_back(static_cast<double>(task));
      Message& message = sent.emplace_back(std::move(result));
      MPI_Isend(message.numbers.data(), static_cast<int>(message.numbers.size()), MPI_DOUBLE, 0, result_tag,
                MPI_COMM_WORLD, &message.request);
    }
  }
  if (first) {
    receive(true);
  } else {
    for (Message& message : sent)
      MPI_Wait(&message.request, MPI_STATUS_IGNORE);
    MPI_Send(nullptr, 0, MPI_DOUBLE, 0, done_tag, MPI_COMM_WORLD);
  }
  together([&] {
    if (failure)
      std::rethrow_exception(failure);
  });
}

} // namespace bem_contact::fem
