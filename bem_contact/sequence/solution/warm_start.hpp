#pragma once

#include "bem_contact/contact/solve.hpp"
#include "bem_contact/sequence/plan/potential_area.hpp"

#include <optional>
#include <vector>

namespace bem_contact {

/// The solution of an earlier case, from which a case may start.
struct FormerSolution {
  ContactGrid grid;
  double first_s = 0;               ///< of the first row, on the rail's arc length, mm
  double force = 0;                 ///< Fz, N
  double approach = 0;              ///< mm
  std::vector<PotentialArea> areas; ///< where the bodies might touch, along s
  std::vector<double> px, ps, pn;   ///< MPa; fields
  Model model{};
};

/// Returns nothing if no case can start from the result: it is neither certified nor ended early, or has no
/// contact.
std::optional<FormerSolution> former_of(Model model, const ContactProblem& problem,
                                        const ContactResult& result, const ContactEstimate& estimate);

/// Says whether the two have as many areas, each of them over its counterpart. If not, neither is a start for
/// the other.
bool alike(const std::vector<PotentialArea>& a, const std::vector<PotentialArea>& b);

/// Says where the elements in contact of `former` are expected, by their middles, and takes all of an area in
/// which it had none. `areas` are alike() the former ones, and not empty.
PotentialArea expected_contact(const FormerSolution& former, const std::vector<PotentialArea>& areas);

/// `former` where this problem expects it: what lay in an area lies in its counterpart, as far from its
/// edges. Pressure scaled by the third root of the force, as Hertz has it, the approach by its square (force
/// 0: not scaled). `areas` are alike() the former ones.
StartingPoint start_from(const FormerSolution& former, const ContactProblem& problem,
                         const std::vector<PotentialArea>& areas, double force);

} // namespace bem_contact
