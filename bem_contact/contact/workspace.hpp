#pragma once

#include "bem_contact/contact/problem.hpp"

#include <list>
#include <memory>

namespace bem_contact {

namespace contact {
struct Prepared;
class TransformPool;
struct DeletePrepared {
  void operator()(Prepared* prepared) const;
};
} // namespace contact

/// What solving makes of influence numbers: spectra, transforms and their plans, preconditioners, the vectors
/// of the iterations, and all of that on coarser elements. Give it to every solve() of a sequence
/// (SolverOptions::workspace): what the former cases made is used again where the numbers and the grid are
/// the same, which is told from all bits of the numbers. Results are those without it. One workspace serves
/// one thread at a time.
class Workspace {
public:
  /// `most`: how many different sets of numbers are kept; the one longest not used goes first.
  explicit Workspace(int most = 2);

  /// For the solvers: what is prepared for the numbers and the grid of this problem.
  contact::Prepared& of(const ContactProblem& problem);

  int prepared() const { return prepared_; } ///< sets of numbers met for the first time
  int kept() const { return kept_; }         ///< how often a set was met again

private:
  int most_, prepared_ = 0, kept_ = 0;
  std::shared_ptr<contact::TransformPool> pool_; ///< plans are the same for many sets
  std::list<std::unique_ptr<contact::Prepared, contact::DeletePrepared>> sets_; ///< used last: in front
};

} // namespace bem_contact
