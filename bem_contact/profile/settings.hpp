#pragma once

#include "bem_contact/base/tuned.hpp"

#include <cstddef>

/// The tuned numbers of this room (base/tuned.hpp).
namespace bem_contact {

// Curves.

/// rad. Chords of measured points that turn by more make a corner; less is taken as curvature. Chosen: a
/// profile sampled every millimetre turns by 0.08 per chord on the sharpest arc of a new rail (R 13).
BEM_CONTACT_TUNED(double, corner_angle, 0.3);
/// 1 (share of a piece). How closely the crossing of y = 0 is found: a few roundings.
BEM_CONTACT_TUNED(double, axis_tolerance, 1e-14);
/// mm. How far beyond its ends a curve may be asked for: the rounding of an arc length.
BEM_CONTACT_TUNED(double, end_slack, 1e-9);
/// 1 (share of a piece's parameter). Where these Newton steps end: a few roundings.
BEM_CONTACT_TUNED(double, parameter_tolerance, 1e-15);
/// mm. Pieces of polynomials of a standard are at most this long, so that ten Gauss points give the arc
/// length to the last digit.
BEM_CONTACT_TUNED(double, polynomial_piece_length, 1.0);

// Tables of standards.

/// mm. So far the pieces of a standard may be apart where they meet, and off their own circles. EN 15302
/// prints joints that miss each other by 0.0008; misprints of a digit are larger.
BEM_CONTACT_TUNED(double, joint_tolerance, 1e-3);
/// rad (.05 degrees). By so much two pieces of a standard may turn without being called a kink: joints that
/// are rounded to 0.001 mm turn pieces of 2 mm by 0.03 degrees.
BEM_CONTACT_TUNED(double, kink_tolerance, 8.727e-4);

/// rad. Pieces of a contact surface that meet at less are smooth: the coordinates of a drawing are rounded.
BEM_CONTACT_TUNED(double, tangent_slack, 0.01);

// Measured points.

/// 1 (lines of the file). More is no measured profile: they have some thousands. Ten million take a minute.
BEM_CONTACT_TUNED(long, most_points, 10'000'000);
/// mm. Nearer points carry the rounding of the file (.01 mm), not shape.
BEM_CONTACT_TUNED(double, crowded, 0.01);
BEM_CONTACT_TUNED(std::size_t, most_named_outliers, 5); ///< 1. Outliers that warnings name. Chosen.
/// 1. Standard deviation of a normal distribution over the median of its absolute values.
BEM_CONTACT_TUNED(double, normal_deviation_over_median, 1.4826);
/// mm. Points that are farther apart tell no noise: a cubic through nine of them leaves 25 um and more of an
/// arc of 13 mm radius, which is shape. They are too few for a curved profile as well.
BEM_CONTACT_TUNED(double, coarsest_spacing, 2.0);

// Datum and orientation of wheels.

/// mm. Less is no flange: the sign of z is left as it is. A flange is 28 mm high, a tread falls by 3 mm.
BEM_CONTACT_TUNED(double, least_flange, 8.0);

} // namespace bem_contact
