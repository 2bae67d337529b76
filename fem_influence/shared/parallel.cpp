#include "fem_influence/shared/parallel.hpp"

#include <mpi.h>
#include <sys/statvfs.h>

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
  MPI_Win window = MPI_WIN_NULL;
  int rank = 0, count = 1, first = 0;
  int word = -1;                     // announced; -1: not yet
  std::vector<MPI_Request> requests; // of announce()
};

Fellows::Fellows() : impl_(std::make_unique<Impl>()) {
  MPI_Comm& together = impl_->together;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &together);
  MPI_Comm_rank(together, &impl_->rank);
  MPI_Comm_size(together, &impl_->count);
  const int mine = process_rank();
  MPI_Allreduce(&mine, &impl_->first, 1, MPI_INT, MPI_MIN, together);
}

Fellows::~Fellows() {
  MPI_Waitall(static_cast<int>(impl_->requests.size()), impl_->requests.data(), MPI_STATUSES_IGNORE);
  if (impl_->window != MPI_WIN_NULL) {
    MPI_Win_unlock_all(impl_->window);
    MPI_Win_free(&impl_->window);
  }
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

std::span<std::byte> Fellows::memory(std::size_t bytes) {
  // MPI's shared memory is a file there, and one that does not fit ends all processes without a word.
  struct statvfs room {};
  int fits = statvfs("/dev/shm", &room) != 0 || room.f_bavail * room.f_frsize > bytes + bytes / 8;
  MPI_Bcast(&fits, 1, MPI_INT, 0, impl_->together);
  if (!fits)
    return {};
  std::byte* memory = nullptr;
  MPI_Win_allocate_shared(rank() == 0 ? static_cast<MPI_Aint>(bytes) : 0, 1, MPI_INFO_NULL, impl_->together,
                          &memory, &impl_->window);
  MPI_Win_lock_all(MPI_MODE_NOCHECK, impl_->window);
  MPI_Aint size = 0;
  int unit = 1;
  MPI_Win_shared_query(impl_->window, 0, &size, &unit, &memory);
  return {memory, static_cast<std::size_t>(size)};
}

void Fellows::announce(bool there) {
  MPI_Win_sync(impl_->window);
  impl_->word = there;
  for (int to = 1; to < impl_->count; ++to)
    MPI_Isend(&impl_->word, 1, MPI_INT, to, 0, impl_->together,
              &impl_->requests.emplace_back(MPI_REQUEST_NULL));
}

bool Fellows::wait() {
  if (impl_->word < 0)
    MPI_Recv(&impl_->word, 1, MPI_INT, 0, 0, impl_->together, MPI_STATUS_IGNORE);
  MPI_Win_sync(impl_->window);
  return impl_->word;
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
                const std::function<void(std::size_t, std::vector<double>)>& collect) {
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
          const auto task = static_cast<std::size_t>(message.back());
          message.pop_back();
          collect(task, std::move(message));
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
        collect(task, std::move(result));
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
