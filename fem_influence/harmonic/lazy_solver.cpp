#include "fem_influence/harmonic/lazy_solver.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>

namespace bem_contact::fem {

void LazySolver::prepare() {
  const TimedScope watch(timing_.assembly);
  section_ = std::make_unique<Section>(mesh_, body_.harmonic.degree, curve_, body_.strip,
                                       Refinement{.everywhere = 0, .borders = body_.harmonic.border_levels});
  system_ = lay_out_system(*section_, body_, curve_, chosen_);
  cells_ = system_->cells;
  unknowns_ = system_->unknowns();
}

void LazySolver::share(Fellows& fellows) {
  if (!system_)
    system_.emplace();
  system_->for_each_part([&](auto& part) { fellows.broadcast(part); });
  const std::size_t blocks = system_->op.block_count(), bytes = blocks * sizeof(SectionOperator::Block);
  const auto memory = fellows.memory(bytes + system_->nodes() * sizeof(int));
  if (memory.empty())
    return;
  fellows_ = &fellows;
  blocks_ = {reinterpret_cast<SectionOperator::Block*>(memory.data()), blocks};
  place_ = {reinterpret_cast<int*>(memory.data() + bytes), system_->nodes()};
}

void LazySolver::assemble() {
  if (!section_)
    prepare();
  try {
    {
      const TimedScope watch(timing_.assembly);
      fill(system_->op, *section_, reference_radius_of(body_), blocks_);
      section_.reset();
    }
    const TimedScope watch(timing_.analysis);
    order_ = elimination_order(*system_);
  } catch (...) {
    if (fellows_)
      fellows_->announce(false);
    throw;
  }
  if (fellows_) {
    std::copy(order_.begin(), order_.end(), place_.begin());
    fellows_->announce(true);
  }
}

HarmonicSolver& LazySolver::solver() {
  if (solver_)
    return *solver_;
  if (fellows_ && fellows_->rank() > 0) {
    if (!fellows_->wait())
      throw Error("There are no matrices", "the process that assembles them for all of this machine failed",
                  "see its own message");
    system_->op.block = blocks_;
    order_.assign(place_.begin(), place_.end());
  } else if (order_.empty()) {
    assemble();
  }
  solver_ = std::make_unique<HarmonicSolver>(std::move(*system_), std::move(order_));
  system_.reset();
  return *solver_;
}

void LazySolver::release() {
  timing_ = timing();
  solver_.reset();
}

} // namespace bem_contact::fem
