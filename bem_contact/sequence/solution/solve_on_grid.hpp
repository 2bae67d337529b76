#pragma once

#include "bem_contact/contact/history.hpp"
#include "bem_contact/contact/solve.hpp"
#include "bem_contact/sequence/numbers/numbers_store.hpp"
#include "bem_contact/sequence/plan/contact_case.hpp"
#include "bem_contact/sequence/scene_result.hpp"
#include "bem_contact/sequence/solution/warm_start.hpp"

#include <string>
#include <vector>

namespace bem_contact {

/// What may be used to solve a case. All of it belongs to the caller.
struct SolveResources {
  WorkBudget& work;                ///< of the case
  SequenceFiles* files = nullptr;  ///< where fem finds influence files that are not read; null: they are
  NumbersStore* numbers = nullptr; ///< null: influence numbers are computed anew
  Workspace* operators = nullptr;  ///< null: what solving prepares is made anew, too
  const FormerSolution* start = nullptr; ///< of an alike() case; null: none
  bool coarse_start = true;              ///< without a start a case starts from larger elements
  bool free_rolling = false;             ///< the result has it, if it is found in passing
  bool totals_only = false;              ///< no error of the elements, no displacements
  bool displacements = true;             ///< the result holds them
  bool derivatives = false;              ///< and those derivatives that the scene asks for
  const EarlyEnd* early_end = nullptr;   ///< null: every solution is precise
  int threads = 1; ///< share the influence numbers; `operators` have a number of their own

  /// Returns the same resources for a further solution of this case, a precise one, with its own work budget
  /// and its own start.
  SolveResources with(WorkBudget& budget, const FormerSolution* from) const {
    return {.work = budget,
            .files = files,
            .numbers = numbers,
            .operators = operators,
            .start = from,
            .coarse_start = coarse_start,
            .totals_only = totals_only,
            .displacements = displacements,
            .threads = threads};
  }
};

/// Says with which numbers, and how much of, the problem is solved.
struct SolveTask {
  Model model{};
  bool normal_only = false; ///< a look at the normal problem, for the choice of the model: no steps, no error
                            ///< of the elements, no displacements
};

/// A case solved on the elements of one plan.
struct GridSolution {
  Model model{};
  ContactOnGrid contact;              ///< with what the last step prescribes
  InfluenceNumbers numbers;           ///< of tangent planes: no store keeps them
  ContactResult result;               ///< of the last step
  std::vector<ContactResult> history; ///< transient and shift: of every step
  Warnings warnings;
  PhaseSeconds seconds;
};

/// Throws InputError where the model does not serve, where the grid needs too much memory, and what solve()
/// throws.
GridSolution solve_on_grid(const ContactCase& asked, ContactOnGrid contact, const SolveTask& task,
                           const SolveResources& resources);

/// Free rolling of a certified solution, on its elements (free_creepage() of contact/solve.hpp): load.force_x
/// = 0, and no motion.xi but by motion.pitch_rate. Takes the numbers of `solved`.
std::optional<Measured> free_creepage_of(const ContactCase& asked, GridSolution& solved,
                                         const SolveResources& resources);

} // namespace bem_contact
