#include "fem_influence/lazy_solver.hpp"

#include "bem_contact/base/error.hpp"

#include <chrono>

namespace bem_contact::fem {

void LazySolver::assemble() {
  const auto start = std::chrono::steady_clock::now();
  system_ = assemble_system(
      {mesh_, body_.harmonic.degree, curve_, body_.strip, {.borders = body_.harmonic.border_levels}}, body_,
      curve_);
  timing_.assembly += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  cells_ = system_->cells;
  unknowns_ = system_->unknowns();
}

void LazySolver::share(Fellows& fellows) {
  if (!system_)
    system_.emplace();
  system_->for_each_part([&](auto& part) { fellows.broadcast(part); });
  order_ = [&fellows] {
    if (fellows.received().empty())
      throw Error("The unknowns have no order of elimination",
                  "the process that finds it for all of this machine failed", "see its own message");
    return fellows.received();
  };
  if (fellows.rank() > 0) {
    fellows.expect(system_->nodes());
    return;
  }
  const auto start = std::chrono::steady_clock::now();
  std::vector<int> order;
  try {
    order = elimination_order(*system_);
  } catch (...) {
    fellows.send({}); // they wait for something
    throw;
  }
  fellows.send(std::move(order));
  timing_.analysis += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

HarmonicSolver& LazySolver::solver() {
  if (!solver_) {
    if (!system_)
      assemble();
    solver_ = std::make_unique<HarmonicSolver>(std::move(*system_), order_);
    system_.reset();
  }
  return *solver_;
}

void LazySolver::release() {
  timing_ = timing();
  solver_.reset();
}

} // namespace bem_contact::fem
