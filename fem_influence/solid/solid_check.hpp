#pragma once

#include "bem_contact/influence/influence_numbers.hpp"
#include "fem_influence/solid/solid_numbers.hpp"

namespace bem_contact::fem {

/// Largest differences to other numbers in a band of distance from the load.
struct SolidDifference {
  double up_to = 0;           ///< distance of the elements' centres, mm; 0: the loaded element
  int elements = 0;           ///< compared
  double of_self[3][3] = {};  ///< |difference| of A_ij over sqrt(A_ii A_jj) of the loaded element
  double of_local[3][3] = {}; ///< over max_i |A_ii| at the same element
};

/// Differences of the 3-D numbers to others (all stations, the same dx and ds, at least as many offsets) in
/// four bands: the loaded element, then up to 1.6, 4.5 and 16 mm.
/// rigid_motion_removed: first the rigid motion that fits the differences beyond 4.5 mm best (least squares,
/// one for each load) is taken from them: what the two methods say of the body's motion as a whole, which
/// depends on its far surface, is set aside.
std::vector<SolidDifference> compare(const SolidNumbers& numbers, const InfluenceNumbers& reference,
                                     double reference_radius, bool rigid_motion_removed);

} // namespace bem_contact::fem
