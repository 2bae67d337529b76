#pragma once

#include "fem_influence/harmonic_solver.hpp"
#include "fem_influence/parallel.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace bem_contact::fem {

/// The solver of a run or of its companion as one process sees it: mesh and factors are there from the first
/// wavenumber that this process does to the last. `body` and `curve` must live as long.
class LazySolver {
public:
  LazySolver(const BodyFile& body, const ProfileCurve& curve, std::filesystem::path mesh)
      : body_(body), curve_(curve), mesh_(std::move(mesh)) {}

  /// Throws InputError for a mesh that does not fit.
  void assemble();
  /// Together: what the first of the fellows assembled goes to all, and then its order of elimination. Nobody
  /// waits for that order before it is needed.
  void share(Fellows& fellows);
  /// Assembled here unless it is already.
  HarmonicSolver& solver();
  void release();

  Timing timing() const { return solver_ ? timing_ + solver_->timing() : timing_; }
  std::size_t cells() const { return cells_; }
  std::size_t unknowns() const { return unknowns_; }

private:
  const BodyFile& body_;
  const ProfileCurve& curve_;
  std::filesystem::path mesh_;
  std::optional<HarmonicSystem> system_; // until the solver takes it
  std::function<std::vector<int>()> order_;
  std::unique_ptr<HarmonicSolver> solver_;
  std::size_t cells_ = 0, unknowns_ = 0;
  Timing timing_;
};

} // namespace bem_contact::fem
