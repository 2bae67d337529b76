#pragma once

#include "bem_contact/sequence/plan/contact_estimate.hpp"

#include <vector>

namespace bem_contact {

/// One area where the undeformed distance is below what the approach asks for.
struct PotentialArea {
  double s_from = 0, s_to = 0, x_from = 0, x_to = 0; ///< mm

  bool operator==(const PotentialArea&) const = default;
};
/// Returns all areas, h < q cos(delta), along s.
std::vector<PotentialArea> potential_areas(const ContactEstimate& estimate, double q);
/// Returns the areas where the undeformed distance is below potential_share of the estimate's own approach.
std::vector<PotentialArea> potential_areas(const ContactEstimate& estimate);

/// How large the estimate says that the contact is, mm, mm^2. In s the sum over all areas.
struct ContactExtent {
  double along_x = 0, along_s = 0, area = 0;
};
ContactExtent contact_extent(const ContactEstimate& estimate);

} // namespace bem_contact
