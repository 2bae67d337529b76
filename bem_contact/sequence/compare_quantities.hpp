#pragma once

#include "bem_contact/sequence/quantities.hpp"

#include <map>
#include <string>
#include <vector>

namespace bem_contact {

/// One quantity that is not what it was.
struct QuantityDifference {
  const Quantity* quantity;
  double before = 0, now = 0;
  double allowed = 0; ///< largest difference that two certified solutions of one problem may have
};

/// Quantities of a result that differ from those of an earlier solution of the same scene by more than the
/// certificate's tolerance, each measured by a scale that is not near zero: forces by the largest force,
/// moments by this force times the root of the area, pressures by pmax, lengths and creepages by their own
/// size but no less than `least_length` and `least_creepage`. Counts must be equal. Left out are quantities
/// that say how the solver went (QuantityKind::effort), and those that only one of the two results has:
/// `before` may come from another version.
std::vector<QuantityDifference> differing_quantities(const std::map<std::string, double>& before,
                                                     const SceneResult& now);

} // namespace bem_contact
