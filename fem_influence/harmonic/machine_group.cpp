#include "fem_influence/harmonic/machine_group.hpp"

#include "fem_influence/shared/parallel.hpp"

#include <mpi.h>
#include <sys/statvfs.h>

#include <algorithm>

namespace bem_contact::fem {

namespace {

/// 1. Shared memory of a machine must have room for this many times what is needed. The rest is for others: a
/// page too few ends all processes without a message.
constexpr double shared_memory_reserve = 1.125;

} // namespace

struct MachineGroup::Impl {
  MPI_Comm group = MPI_COMM_NULL;
  MPI_Win window = MPI_WIN_NULL;
  int rank = 0, count = 1, first_rank = 0;
  int word = -1;                     // announced; -1: not yet
  std::vector<MPI_Request> requests; // of announce()
};

MachineGroup::MachineGroup() : impl_(std::make_unique<Impl>()) {
  MPI_Comm& group = impl_->group;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &group);
  MPI_Comm_rank(group, &impl_->rank);
  MPI_Comm_size(group, &impl_->count);
  const int mine = process_rank();
  MPI_Allreduce(&mine, &impl_->first_rank, 1, MPI_INT, MPI_MIN, group);
}

MachineGroup::~MachineGroup() {
  MPI_Waitall(static_cast<int>(impl_->requests.size()), impl_->requests.data(), MPI_STATUSES_IGNORE);
  if (impl_->window != MPI_WIN_NULL) {
    MPI_Win_unlock_all(impl_->window);
    MPI_Win_free(&impl_->window);
  }
  MPI_Comm_free(&impl_->group);
}

int MachineGroup::rank() const {
  return impl_->rank;
}
int MachineGroup::count() const {
  return impl_->count;
}
int MachineGroup::first_rank() const {
  return impl_->first_rank;
}

void MachineGroup::broadcast(std::span<std::byte> bytes) const {
  constexpr std::size_t most = std::size_t{1} << 30; // MPI counts in int
  for (std::size_t from = 0; from < bytes.size(); from += most) {
    const auto part = bytes.subspan(from, std::min(most, bytes.size() - from));
    MPI_Bcast(part.data(), static_cast<int>(part.size()), MPI_BYTE, 0, impl_->group);
  }
}

std::span<std::byte> MachineGroup::memory(std::size_t bytes) {
  // MPI's shared memory is a file there, and one that does not fit ends all processes without a word.
  struct statvfs room {};
  int fits = statvfs("/dev/shm", &room) != 0 || static_cast<double>(room.f_bavail * room.f_frsize) >
                                                    shared_memory_reserve * static_cast<double>(bytes);
  MPI_Bcast(&fits, 1, MPI_INT, 0, impl_->group);
  if (!fits)
    return {};
  std::byte* memory = nullptr;
  MPI_Win_allocate_shared(rank() == 0 ? static_cast<MPI_Aint>(bytes) : 0, 1, MPI_INFO_NULL, impl_->group,
                          &memory, &impl_->window);
  MPI_Win_lock_all(MPI_MODE_NOCHECK, impl_->window);
  MPI_Aint size = 0;
  int unit = 1;
  MPI_Win_shared_query(impl_->window, 0, &size, &unit, &memory);
  return {memory, static_cast<std::size_t>(size)};
}

void MachineGroup::announce(bool there) {
  MPI_Win_sync(impl_->window);
  impl_->word = there;
  for (int to = 1; to < impl_->count; ++to)
    MPI_Isend(&impl_->word, 1, MPI_INT, to, 0, impl_->group, &impl_->requests.emplace_back(MPI_REQUEST_NULL));
}

bool MachineGroup::wait() {
  if (impl_->word < 0)
    MPI_Recv(&impl_->word, 1, MPI_INT, 0, 0, impl_->group, MPI_STATUS_IGNORE);
  MPI_Win_sync(impl_->window);
  return impl_->word;
}

} // namespace bem_contact::fem
