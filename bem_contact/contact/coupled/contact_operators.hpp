#pragma once

#include "bem_contact/contact/grid/larger_elements.hpp"
#include "bem_contact/contact/normal/normal_operators.hpp"
#include "bem_contact/contact/problem.hpp"
#include "bem_contact/contact/tangential/tangential_operators.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

namespace bem_contact::contact {

/// Names a set of influence numbers on a grid. Two sets have the same key only if all their values are
/// identical, bit by bit (up to a collision of 64-bit digests). Offsets beyond those of the grid count too.
struct NumbersKey {
  int mx = 0, ms = 0, offsets = 0, rows = 0;
  bool translational = false;
  double dx = 0, ds = 0;
  std::uint64_t digest = 0; ///< of the bits of all values

  bool operator==(const NumbersKey&) const = default;
};

NumbersKey key_of(const ContactProblem& problem);

/// How shear acts on the normal displacement, and pressure on the tangential ones; on the whole grid.
struct Coupling {
  Coupling(const ContactProblem& problem, TransformPool* pool);

  StripOperator normal_from_shear, shear_from_normal;
};

struct StartingOperators;
struct CompanionOperators;

/// Everything that solving prepares from one set of influence numbers on one grid. Each operator is made when
/// it is first asked for; it is complete then and stays as it is. Every call gives a problem with these
/// numbers and this grid. Serves one thread at a time.
class ContactOperators {
public:
  /// `key` names the numbers where this outlives a problem.
  explicit ContactOperators(std::shared_ptr<TransformPool> pool = std::make_shared<TransformPool>(),
                            const NumbersKey& key = {});
  ~ContactOperators();

  const NumbersKey& key() const { return key_; }
  /// What follows does not depend on the problems that were solved before.
  void forget_solutions();
  /// Null if the influence numbers do not couple the normal and the tangential problem.
  const Coupling* coupling(const ContactProblem& problem, WorkBudget& work);
  /// Returns operators for starting_problem() (grid/larger_elements.hpp), made about the fine row `middle`.
  StartingOperators& start(const InfluenceNumbers& fine, const ContactGrid& coarse, int middle,
                           bool only_normal);
  /// Returns operators for companion_of() on these larger elements.
  CompanionOperators& companion(const InfluenceNumbers& fine, const LargerElements& larger, bool only_normal);

private:
  std::shared_ptr<TransformPool> pool_;
  NumbersKey key_;
  std::optional<bool> couples_;
  std::optional<Coupling> coupling_;
  std::unique_ptr<StartingOperators> start_;
  std::unique_ptr<CompanionOperators> companion_;

public:
  NormalOperators normal;
  TangentialOperators tangential;
};

/// Influence numbers of starting_problem() and what is prepared from them.
struct StartingOperators {
  int middle;
  bool only_normal;
  InfluenceNumbers numbers;
  ContactOperators operators;
};

/// Influence numbers of companion_of() and what is prepared from them.
struct CompanionOperators {
  LargerElements larger;
  bool only_normal;
  InfluenceNumbers numbers;
  ContactOperators operators;
};

/// While it lives, a problem has these numbers; then they are given back. Numbers may take gigabytes.
class LentNumbers {
public:
  LentNumbers(InfluenceNumbers& kept, ContactProblem& problem) : kept_(kept), problem_(problem) {
    std::swap(kept_, problem_.numbers);
  }
  ~LentNumbers() { std::swap(kept_, problem_.numbers); }
  LentNumbers(const LentNumbers&) = delete;
  LentNumbers& operator=(const LentNumbers&) = delete;

private:
  InfluenceNumbers& kept_;
  ContactProblem& problem_;
};

/// Says whether a tangential traction causes normal displacements, or the other way round, beyond rounding.
bool numbers_couple(const InfluenceNumbers& numbers);

/// Says whether shear tractions as large as a pressure can cause normal displacements of more than `share` of
/// those of the pressure. If no element displaces another by more than this share, no sum of them does.
bool shear_moves_normal(const InfluenceNumbers& numbers, double share);

} // namespace bem_contact::contact
