#pragma once

#include "bem_contact/base/tuned.hpp"

#include <cstddef>
#include <numbers>

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

// Outlines of a body file.

/// rad. Pieces of a contact surface that meet at less are smooth: the coordinates of a drawing are rounded.
BEM_CONTACT_TUNED(double, tangent_slack, 0.01);
/// mm. A shorter piece of an outline is a mistake. Chosen: a thousandth of the last digit of a drawing.
BEM_CONTACT_TUNED(double, shortest_outline_piece, 1e-6);
/// 1. An arc's chord may exceed its diameter by so much: a half circle with rounded ends.
BEM_CONTACT_TUNED(double, half_circle_rounding, 1e-9);
/// 1. Points of an arc among which its lowest z is looked for. Chosen.
BEM_CONTACT_TUNED(int, lowest_point_samples, 64);

// Repair of measured points.

/// 1 (lines of the file). More is no measured profile: they have some thousands. Ten million take a minute.
BEM_CONTACT_TUNED(long, most_points, 10'000'000);

/// mm. Nearer points carry the rounding of the file (.01 mm), not shape.
BEM_CONTACT_TUNED(double, crowded, 0.01);
/// rad. No profile turns so sharply between two chords: there the points zig-zag. Chosen: beyond a right
/// angle, which the edge of a wheel's rim may have.
BEM_CONTACT_TUNED(double, zig_zag, 100 * std::numbers::pi / 180);
/// 1 (share of the points). More may not be dropped as stray: then the file is another kind of wrong. Chosen.
BEM_CONTACT_TUNED(double, repairable_share, 0.05);
/// 1 (share of the length of the walk). An end point always shortens the walk when it is dropped; it is
/// dropped only if nothing else shortens the walk by nearly as much.
BEM_CONTACT_TUNED(double, end_point_penalty, 1e-3);
/// mm. A longer loop is shape, not noise. Chosen: about the distance of measured points.
BEM_CONTACT_TUNED(double, repairable_loop, 1.0);
/// mm. Widths that a rail's or wheel's profile can have. A wheel's rim is 140 mm wide.
BEM_CONTACT_TUNED(double, narrowest_profile, 10.0);
BEM_CONTACT_TUNED(double, widest_profile, 300.0); ///< mm. As above.
/// The file's unit. A profile this wide is in metres: no profile in mm is as narrow.
BEM_CONTACT_TUNED(double, narrowest_in_metres, 0.02);
BEM_CONTACT_TUNED(double, widest_in_metres, 0.3); ///< As above.
/// mm. A file whose unit is not said and that is narrower is asked about: heads of rails are wider than 60
/// mm, wheels wider than 100 mm, and in centimetres both are narrower than this.
BEM_CONTACT_TUNED(double, narrowest_unasked, 16.0);
/// mm. Widths that a whole rail or wheel has: what a narrower file would be in another unit.
BEM_CONTACT_TUNED(double, narrowest_guess, 55.0);
BEM_CONTACT_TUNED(double, widest_guess, 160.0); ///< mm. As above.
/// 1. A walk that travels this many times its width along y goes over the same ground twice. Below 2, because
/// overlapping scans rarely cover all of each other; a profile with under-head stays below 1.5.
BEM_CONTACT_TUNED(double, doubled_walk, 1.9);
/// 1. Points are out of order if sorting by y shortens the walk by this factor. Chosen: two shuffled points
/// of a short file already do.
BEM_CONTACT_TUNED(double, shuffled_walk, 1.5);

// Noise of measured points, and smoothing.

/// 1. Neighbours on either side in the fit that tells noise from shape: a cubic through nine points half a
/// millimetre apart leaves less than 0.1 um of an arc of 13 mm radius.
BEM_CONTACT_TUNED(int, noise_neighbours, 4);
/// 1. Standard deviation of a normal distribution over the median of its absolute values.
BEM_CONTACT_TUNED(double, normal_deviation_over_median, 1.4826);
/// MPa. E* of two steel bodies, for the pressure that noise makes.
BEM_CONTACT_TUNED(double, steel_contact_modulus, 115000);
/// mm. Points that are farther apart tell no noise: a cubic through nine of them leaves 25 um and more of an
/// arc of 13 mm radius, which is shape. They are too few for a curved profile as well.
BEM_CONTACT_TUNED(double, coarsest_spacing, 2.0);
/// MPa. Noise that makes less is not worth a word: 1 % of a usual largest pressure.
BEM_CONTACT_TUNED(double, least_noise_pressure, 15);
/// mm over mm^(3/2) to the exponent below. Smoothing advised for noise e at the distance h is this times
/// (e sqrt(h)) to that exponent: the wavelength at which the scatter of the smoothed curvature, which grows
/// as e sqrt(h) L^(-5/2), is the same for every file. Measured with tools/benchmarks/profile_noise.
BEM_CONTACT_TUNED(double, smoothing_for_noise, 120);
BEM_CONTACT_TUNED(double, smoothing_for_noise_exponent, 0.4); ///< 1. As above.
/// mm. Half the height of a wave of the shortest length kept that smoothing still takes for noise. Higher
/// ones are jumps of the curvature. Measured with tools/benchmarks/profile_noise: 8 um leaves noise beside
/// the jumps of S1002, 16 um rounds them.
BEM_CONTACT_TUNED(double, highest_wave, 0.0145);
/// 1. Weights of the repeated least squares settle to this: it moves no point by a nanometre.
BEM_CONTACT_TUNED(double, smoothing_precision, 1e-4);
/// Repetitions. Far more than profiles need.
BEM_CONTACT_TUNED(int, most_smoothing_rounds, 200);
/// rad. Tangents on either side that differ by more make a kink. Noise of 10 um in points 0.25 mm apart,
/// fitted over 3 mm, turns them by 0.012.
BEM_CONTACT_TUNED(double, kink_turn, 0.2);
/// 1. Points on either side that such a tangent needs at least.
BEM_CONTACT_TUNED(int, kink_points, 5);
/// 1. Weight of a point that is held, relative to the others: large, and far from the limits of rounding.
BEM_CONTACT_TUNED(double, kink_weight, 1e6);
/// 1. Points nearer than this part of the wavelength become one: the spline through the rest keeps far
/// shorter waves than are asked for.
BEM_CONTACT_TUNED(double, thinning, 50);
/// 1. What is removed may exceed the noise by this factor. More is shape.
BEM_CONTACT_TUNED(double, removed_over_noise, 2.0);
/// mm. Less removed shape does not matter. Chosen: below it no pressure moved by 1 %.
BEM_CONTACT_TUNED(double, least_removed, 5e-4);
/// 1 (share of the advised smoothing). Less leaves noise that shows: its pressure grows by half.
BEM_CONTACT_TUNED(double, least_smoothing_share, 0.85);

// Nominal profiles, from which measured ones are worn.

/// mm. Arm with which turns become lengths: half of a head's width.
BEM_CONTACT_TUNED(double, placing_arm, 30.0);
/// 1 (of the total weight). Added to the diagonal of the fit, so that a place along which a profile can slide
/// stays where it is.
BEM_CONTACT_TUNED(double, placing_damping, 1e-9);
BEM_CONTACT_TUNED(double, placing_tolerance, 1e-6); ///< mm. Where the steps of a fit end.
/// 1. Bound of the steps of a fit; a worn profile takes some 15.
BEM_CONTACT_TUNED(int, placing_steps, 60);
/// 1 (scatters). Nearer points are as near as noise allows: the sum of distances is rounded there.
BEM_CONTACT_TUNED(double, placing_scatters, 3.0);
BEM_CONTACT_TUNED(double, least_placing_distance, 1e-3); ///< mm. As above, of exact points.
/// 1. Tukey's width over the standard deviation: 95 % as good as least squares on normal noise
/// (Holland and Welsch 1977).
BEM_CONTACT_TUNED(double, tukey_width, 4.685);
BEM_CONTACT_TUNED(int, placing_points, 80); ///< 1. Points with which a place is looked for. Chosen.
/// mm. Half of the points lie nearer where the file's own frame is about that of the nominal profile. A wheel
/// worn by 1 mm on half of its tread stays below.
BEM_CONTACT_TUNED(double, placed_distance, 0.5);
/// mm. Points this near to the top (of a wheel: to the tip) say where the middle of it is. Chosen.
BEM_CONTACT_TUNED(double, placing_top, 2.0);
/// rad and mm. The search for a place begins at all of these: how measured profiles are inclined and shifted.
inline constexpr double placing_angles[] = {0.0, -0.025, 0.025, -0.05, 0.05};
inline constexpr double placing_sides[] = {0.0, -4.0, 4.0, -10.0, 10.0}; ///< mm. As above.
/// mm. So far beyond its end a point still belongs to a nominal profile: noise may move the last one.
BEM_CONTACT_TUNED(double, beyond_end, 0.05);
/// mm. No rail or wheel in service is worn by more; a point farther off is that of another shape.
BEM_CONTACT_TUNED(double, farthest_from_nominal, 5.0);
BEM_CONTACT_TUNED(double, farthest_rms_from_nominal, 2.0); ///< mm. Root mean square, as above. Chosen.
/// mm. Noise says which nominal profile would help if the points lie this near to it. Chosen.
BEM_CONTACT_TUNED(double, farthest_advised, 3.0);
/// mm. A standard is not like a profile that has more steel outside it: flow of the steel makes lips of some
/// tenths.
BEM_CONTACT_TUNED(double, farthest_added_steel, 1.0);
/// 1. Points of a measured curve by which it is compared with the standards: closer than 1 mm. Chosen.
BEM_CONTACT_TUNED(int, like_points, 200);
/// 1. How unlike a standard is: the steel outside it and this share of the whole depth, root mean squares.
/// Wear of 2 mm then weighs as much as 0.1 mm of steel that nothing can have added. Chosen.
BEM_CONTACT_TUNED(double, worn_share, 0.1);
/// 1. A second standard that is not more unlike than this is named too. Chosen: a 60E2 with its top worn
/// evenly lies as well on 60E1.
BEM_CONTACT_TUNED(double, like_tie, 1.5);
/// mm (root mean square). With more steel outside a standard the turn of a rail is not told. A 60E1 that
/// bumps of wear take 0.3 to 2 mm off, 8 to 30 mm wide, is then placed askew by less than least_inclination.
BEM_CONTACT_TUNED(double, most_added_steel, 0.02);
/// rad. A rail that is turned by this or more towards the track's centre was measured as it lies in the
/// track: half of 1:40, the smallest inclination in use.
BEM_CONTACT_TUNED(double, least_inclination, 0.0125);
/// 1. Fewer points tell no depth.
BEM_CONTACT_TUNED(std::size_t, least_nominal_points, 20);
/// 1 (median distances of points). Depths nearer to each other become one.
BEM_CONTACT_TUNED(double, least_depth_step, 0.3);
BEM_CONTACT_TUNED(double, least_depth_scatter, 1e-6); ///< mm. Exact points scatter by their rounding.
/// mm. Waves of the depth shorter than this are removed where the points tell of none: half of the running
/// surface. Noise of 10 um then moves the conformal corner of S1002 on 60E1 by less than 1 %.
BEM_CONTACT_TUNED(double, longest_depth_wave, 50.0);
/// 1 (median distances of points). Shorter waves are not looked for: a wave needs so many points.
BEM_CONTACT_TUNED(double, shortest_depth_wave, 8.0);
/// 1. Where it must be, the wavelength is shortened by this factor at a time, and once more at the end.
/// Without that, 23 % of the contacts of tools/benchmarks/profile_noise (both, rolled: 10 um, 20 draws) were
/// off by 3 %, with it 11 %.
BEM_CONTACT_TUNED(double, depth_wave_step, 0.8);
/// mm. and so far beyond the stretch on which it must be. Six times as much gives nearly the same.
BEM_CONTACT_TUNED(double, depth_wave_reach, 2.0);
/// 1 (points). The shortest stretch on which what is removed is compared with noise.
BEM_CONTACT_TUNED(std::size_t, shortest_stretch, 4);
/// 1 (share of the wavelength there). Shorter stretches are not looked at: what smoothing takes of the shape
/// changes its sign after about this length, and a chance run of a few points is no shape.
BEM_CONTACT_TUNED(double, stretch_share, 0.25);
/// mm. A jump of the nominal curvature is looked for so far before and after a joint.
BEM_CONTACT_TUNED(double, jump_distance, 1e-6);
/// 1/mm. Less is no jump: it moves no curvature in contact by a thousandth.
BEM_CONTACT_TUNED(double, curvature_jump, 1e-5);
/// 1. Chords of a worn profile from one jump to the next, at least: a cubic spline needs four points.
BEM_CONTACT_TUNED(std::ptrdiff_t, least_smooth_chords, 4);

// Holes in measured points. They are reported, not mended. All chosen.

BEM_CONTACT_TUNED(double, hole_length, 10.0); ///< 1. A hole is so many times as long as the median chord,
BEM_CONTACT_TUNED(double, least_hole, 2.0);   ///< mm. and at least so long;
BEM_CONTACT_TUNED(double, hole_turn, 2.0);    ///< deg. and the profile turns by more over it.
/// deg. Two chords that turn by more, there and back, are a jump between two scans.
BEM_CONTACT_TUNED(double, jump_turn, 45.0);

/// 1 (scatters). A single point that lies off the line of its neighbours by more is an outlier: noise hardly
/// ever has so much. Chosen.
BEM_CONTACT_TUNED(double, outlier_scatters, 12.0);
BEM_CONTACT_TUNED(double, least_outlier, 0.05);         ///< mm. As above, of exact points. Chosen.
BEM_CONTACT_TUNED(std::size_t, most_named_outliers, 5); ///< 1. Outliers that warnings name. Chosen.
/// 1 (share of the outlier's distance). Its neighbours lie nearer to their own line without it. At a corner
/// they are off by 0.1 times as much as its point and more.
BEM_CONTACT_TUNED(double, neighbour_share, 0.05);
/// 1 (scatters). Noise alone may move a neighbour so far from its line. Chosen.
BEM_CONTACT_TUNED(double, neighbour_scatters, 5.0);

// Datum of wheels.

/// mm. How far the tip of a flange lies from its back: 15 mm on S1002 (EN 13715), 12 to 22 on worn and
/// American wheels.
BEM_CONTACT_TUNED(double, nearest_tip_to_back, 5.0);
BEM_CONTACT_TUNED(double, farthest_tip_from_back, 32.0); ///< mm. As above.
/// mm. Range of the tip's y over wheels whose y = 0 is at the tape circle: 62 to 78 mm from the back.
BEM_CONTACT_TUNED(double, lowest_tip, -75.0);
BEM_CONTACT_TUNED(double, highest_tip, -35.0); ///< mm. As above.
BEM_CONTACT_TUNED(double, usual_tip, -55.0);   ///< mm. y of the tip of S1002.
/// mm. A worn wheel may be as low at its tape circle; more is another datum.
BEM_CONTACT_TUNED(double, highest_tape_circle, 6.0);

// Orientation of measured points.

/// 1 (share of the chord between the ends). A rail's head that bulges down by more has its z upside down.
/// Chosen: a rail's head bulges by more than a tenth of its width.
BEM_CONTACT_TUNED(double, least_bulge, 0.005);
/// mm. Less is no flange: the sign of z is left as it is. A flange is 28 mm high, a tread falls by 3 mm.
BEM_CONTACT_TUNED(double, least_flange, 8.0);
/// mm. Something wider than a rail's head whose top is narrower than this, so far below its highest point, is
/// a wheel with its flange up. The head of 60E1 is 72 mm wide, and 56 mm at this depth.
BEM_CONTACT_TUNED(double, top_depth, 3.0);
BEM_CONTACT_TUNED(double, narrowest_top, 25.0);    ///< mm. As above.
BEM_CONTACT_TUNED(double, widest_rail_head, 90.0); ///< mm. As above.

} // namespace bem_contact
