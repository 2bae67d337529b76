#pragma once

#include "bem_contact/base/tuned.hpp"

#include <cstddef>

/// The tuned numbers of this room (base/tuned.hpp).
namespace bem_contact {

// Curves.

/// rad. Chords of measured points that turn by more make a corner; less is taken as curvature. Chosen: a
/// profile sampled every millimetre turns by .08 per chord on the sharpest arc of a new rail (R 13).
BEM_CONTACT_TUNED(double, corner_angle, 0.3);
/// 1. A corner also turns by more than this many times the turns beside it. On a coarsely sampled arc all
/// turns are alike, so that it gets no corners.
BEM_CONTACT_TUNED(double, corner_contrast, 2.0);
/// mm. Nearer points of a curve coincide: a chord between them has no direction.
BEM_CONTACT_TUNED(double, coinciding_points, 1e-9);
/// mm. A point this near to y = 0 lies on it: the rounding of a joint's coordinates.
BEM_CONTACT_TUNED(double, on_axis, 1e-12);
/// 1 (share of a piece). How closely the crossing of y = 0 is found: a few roundings.
BEM_CONTACT_TUNED(double, axis_tolerance, 1e-14);
/// mm. How far beyond its ends a curve may be asked for: the rounding of an arc length.
BEM_CONTACT_TUNED(double, end_slack, 1e-9);
/// 1. Samples of a polynomial piece from which the search for its nearest point starts. Pieces are about 1 mm
/// long, so that the distance has no second minimum between two samples. Chosen.
BEM_CONTACT_TUNED(int, nearest_samples, 6);
/// 1. Newton steps inside a polynomial piece: bounds. Newton converges in about four.
BEM_CONTACT_TUNED(int, arc_length_steps, 20);
BEM_CONTACT_TUNED(int, nearest_steps, 60); ///< 1. As above; each step may be a halving instead.
/// 1 (share of a piece's parameter). Where these Newton steps end: a few roundings.
BEM_CONTACT_TUNED(double, parameter_tolerance, 1e-15);
/// mm. Pieces of the polynomial zones of S1002 are at most this long, so that ten Gauss points give the arc
/// length to the last digit.
BEM_CONTACT_TUNED(double, s1002_piece, 1.0);
/// 1. Bounds of a search for the nearest piece are widened by so much, so that no piece's own bound, rounded,
/// excludes it.
BEM_CONTACT_TUNED(double, bound_rounding, 1e-12);

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
/// 1. What is removed may exceed the noise by this factor. More is shape.
BEM_CONTACT_TUNED(double, removed_over_noise, 2.0);
/// mm. Less removed shape does not matter. Chosen: below it no pressure moved by 1 %.
BEM_CONTACT_TUNED(double, least_removed, 5e-4);
/// 1 (share of the advised smoothing). Less leaves noise that shows: its pressure grows by half.
BEM_CONTACT_TUNED(double, least_smoothing_share, 0.85);

// Datum and orientation of wheels.

/// mm. How far the tip of a flange lies from its back: 15 mm on S1002 (EN 13715), 12 to 22 on worn and
/// American wheels.
BEM_CONTACT_TUNED(double, nearest_tip_to_back, 5.0);
BEM_CONTACT_TUNED(double, farthest_tip_from_back, 32.0); ///< mm. As above.
/// mm. Range of the tip's y over wheels whose y = 0 is at the tape circle: 62 to 78 mm from the back.
BEM_CONTACT_TUNED(double, lowest_tip, -75.0);
BEM_CONTACT_TUNED(double, highest_tip, -35.0); ///< mm. As above.
BEM_CONTACT_TUNED(double, usual_tip, -55.0);   ///< mm. y of the tip of S1002.
/// mm. A file whose flange ends in a steep face elsewhere than at its usual place by more has another datum,
/// or another distance of the tape circle from the back: 58 to 65 mm on trams, 77.8 in America.
BEM_CONTACT_TUNED(double, usual_back, 3.0);
BEM_CONTACT_TUNED(double, back_face, 0.5); ///< mm. So wide is what belongs to that face: draft, and noise.
/// 1. Slope from there to the face's end: 1 mm of S1002 beside its back rises by 7.
BEM_CONTACT_TUNED(double, least_back_slope, 2.5);
/// mm. A worn wheel may be as low at its tape circle; more is another datum.
BEM_CONTACT_TUNED(double, highest_tape_circle, 6.0);
/// mm. Less is no flange: the sign of z is left as it is. A flange is 28 mm high, a tread falls by 3 mm.
BEM_CONTACT_TUNED(double, least_flange, 8.0);

} // namespace bem_contact
