#pragma once

#include "bem_contact/profile/profile_curve.hpp"

#include <string>
#include <vector>

namespace bem_contact {

/// A point of a section, with the derivative of its curve by t before and behind it.
struct SectionNode {
  double u = 0, t = 0; ///< of the surface (SectionedSurface)
  Point2 position, before, after;
};

/// The curve through these nodes, cubic Hermite in t between them. Of nodes at the same place the first one
/// stays. Throws InputError, naming the curve, for fewer than three.
ProfileCurve curve_through(const std::string& name, std::vector<SectionNode>& nodes);

} // namespace bem_contact
