#pragma once

#include "bem_contact/base/tuned.hpp"

/// The tuned numbers of this room (base/tuned.hpp).
namespace bem_contact::reference {

/// 1. Least ratio of the axes of Hertz's ellipse: far below that of any contact, far above the least number.
BEM_CONTACT_TUNED(double, least_axis_ratio, 1e-12);
/// 1. Directions of the chords in the creep coefficients, per ratio of the long to the short axis. The
/// integrand has its nearest pole about one over that ratio off the real axis; 20 give all digits.
BEM_CONTACT_TUNED(double, directions_per_aspect, 20.0);
/// 1. Points of the leading edge at which the creep coefficients ask for finite tractions, per degree of the
/// polynomials plus 1. Chosen: enough for a mean square over the edge.
BEM_CONTACT_TUNED(int, edge_points_per_degree, 8);

} // namespace bem_contact::reference
