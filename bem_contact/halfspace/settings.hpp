#pragma once

#include "bem_contact/base/tuned.hpp"

/// The tuned numbers of this room (base/tuned.hpp).
namespace bem_contact::halfspace {

// How an element's influence number is computed, by the distance of the two elements. Quadrature with N Gauss
// points on each half of an element pair's density is exact to (2 distance)^(-2N), so each switch costs
// 1e-14.

/// 1 (half of the element's longer side). Nearer pairs have the closed form, whose terms cancel farther away.
BEM_CONTACT_TUNED(double, closed_form_radius, 12.0);
/// 1 (as above). Six Gauss points up to here, then four;
BEM_CONTACT_TUNED(double, six_point_radius, 36.0);
/// 1 (as above). and beyond this, three.
BEM_CONTACT_TUNED(double, four_point_radius, 120.0);

// Plane strain.

/// mm. Where the displacement of plane strain is 0 unless the caller says otherwise. A convention: it shifts
/// the approach and nothing else.
BEM_CONTACT_TUNED(double, plane_strain_reference, 100.0);

// Curved strips.

/// rad. Rows whose turns differ by less turn evenly: the rounding of an inclination.
BEM_CONTACT_TUNED(double, equal_turn, 1e-10);

// Resampling.

/// 1 (share of a number). Error of the interpolated half-space numbers. They are added and taken away again,
/// so it is a thousandth of what a file's own estimate is at best.
BEM_CONTACT_TUNED(double, near_field_accuracy, 1e-6);
/// 1 (share of a row's width). Distances that differ by less share their numbers: rounding.
BEM_CONTACT_TUNED(double, same_distance, 1e-12);

} // namespace bem_contact::halfspace
