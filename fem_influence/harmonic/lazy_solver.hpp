#pragma once

#include "fem_influence/harmonic/harmonic_solver.hpp"
#include "fem_influence/shared/parallel.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace bem_contact::fem {

/// The solver of a run or of its companion as one process sees it: matrices and factors are there from the
/// first wavenumber that this process does to the last. `body` and `curve` must live as long.
class LazySolver {
public:
  LazySolver(const BodyFile& body, const ProfileCurve& curve, std::filesystem::path mesh)
      : body_(body), curve_(curve), mesh_(std::move(mesh)) {}

  /// The kernel of these stations alone, as in lay_out_system(); before anything else.
  void choose(std::vector<std::size_t> stations) { chosen_ = std::move(stations); }

  /// Mesh and functionals. Throws InputError for a mesh that does not fit.
  void prepare();
  /// Together: what the first of the fellows prepared goes to all, and its matrices and their order of
  /// elimination will: it must call assemble() then, whether it needs them itself or not. Nobody waits for
  /// them before they are needed.
  void share(Fellows& fellows);
  void assemble();
  /// Assembled here unless it is, or the first of the fellows does.
  HarmonicSolver& solver();
  void release();

  Timing timing() const { return solver_ ? timing_ + solver_->timing() : timing_; }
  std::size_t cells() const { return cells_; }
  std::size_t unknowns() const { return unknowns_; }

private:
  const BodyFile& body_;
  const ProfileCurve& curve_;
  std::filesystem::path mesh_;
  std::vector<std::size_t> chosen_;
  std::unique_ptr<Section> section_;     // until the matrices are assembled
  std::optional<HarmonicSystem> system_; // until the solver takes it
  std::vector<int> order_;
  Fellows* fellows_ = nullptr; // with whom the next two are shared
  std::span<SectionOperator::Block> blocks_;
  std::span<int> place_;
  std::unique_ptr<HarmonicSolver> solver_;
  std::size_t cells_ = 0, unknowns_ = 0;
  Timing timing_;
};

} // namespace bem_contact::fem
