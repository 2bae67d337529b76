#include "fem_influence/harmonic/machine_system.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <utility>

namespace bem_contact::fem {

MachineSystem::MachineSystem(MachineGroup& group, std::optional<MeshedSystem> meshed, Timing& timing)
    : group_(group) {
  HarmonicSystem& system = meshed ? meshed->system : system_;
  system.for_each_part([&](auto& part) { group.broadcast(part); });
  const std::size_t blocks = system.op.block_count(), bytes = blocks * sizeof(SectionOperator::Block);
  if (const auto memory = group.memory(bytes + system.nodes() * sizeof(int)); !memory.empty()) {
    blocks_ = {reinterpret_cast<SectionOperator::Block*>(memory.data()), blocks};
    order_ = {reinterpret_cast<int*>(memory.data() + bytes), system.nodes()};
  }
  if (!meshed)
    return;
  try {
    assembled_ = add_matrices(std::move(*meshed), timing, blocks_);
  } catch (...) {
    failure_ = std::current_exception();
  }
  if (blocks_.empty())
    return;
  if (assembled_)
    std::copy(assembled_->order.begin(), assembled_->order.end(), order_.begin());
  group.announce(!failure_);
}

std::optional<AssembledSystem> MachineSystem::take() {
  require_matrices();
  if (group_.rank() == 0 || blocks_.empty())
    return std::exchange(assembled_, std::nullopt);
  if (!group_.wait())
    throw Error("There are no matrices", "the process that assembles them for all of this machine failed",
                "See its own message.");
  system_.op.block = blocks_;
  return AssembledSystem{std::move(system_), {order_.begin(), order_.end()}};
}

void MachineSystem::require_matrices() const {
  if (failure_)
    std::rethrow_exception(failure_);
}

} // namespace bem_contact::fem
