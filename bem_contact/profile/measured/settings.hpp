#pragma once

#include "bem_contact/base/tuned.hpp"

#include <cstddef>
#include <numbers>

/// Tuned numbers of profile/measured. For the words see base/tuned.hpp.
namespace bem_contact {

// Marks of missing values.

/// 1 (median distances from the median). A point farther away may mark a missing value: on a line the ends
/// are two such distances away, and where most points lie on the flange its tread ends at some twenty.
/// Chosen.
BEM_CONTACT_TUNED(double, farthest_point, 30.0);
/// 1 (median distances of neighbouring points). A mark of a missing value lies behind such a jump. Chosen.
BEM_CONTACT_TUNED(double, jump_to_mark, 10.0);
/// 1. In fewer points there is no median to trust.
BEM_CONTACT_TUNED(std::size_t, least_points_with_marks, 8);

// Repair of measured points.

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

// Dense scans, and closed outlines.

/// mm. Means of neighbours lie no farther apart: over 1 mm a mean lies 3 um inside an arc of 13 mm radius.
BEM_CONTACT_TUNED(double, farthest_means, 1.0);
/// 1. Fewer means are no scan. Chosen.
BEM_CONTACT_TUNED(std::size_t, least_means, 20);
/// mm. Points that scatter by more are no scan of one surface. Chosen: laser scanners scatter by .1 mm.
BEM_CONTACT_TUNED(double, largest_scan_scatter, 0.3);
/// 1 (median distances of neighbours). An outline whose ends are this near is closed. Chosen.
BEM_CONTACT_TUNED(double, closing_spacings, 3.0);
BEM_CONTACT_TUNED(double, widest_closing, 0.1); ///< 1 (share of its length). As above, of few points.
/// 1 (share of the square of the length). A closed outline encloses more: a rail .017, a scan there and back
/// .001.
BEM_CONTACT_TUNED(double, least_enclosed, 0.005);
/// 1 (share of the height). Within so much of its end in z a rail's base has its whole width.
BEM_CONTACT_TUNED(double, base_band, 0.02);
BEM_CONTACT_TUNED(double, least_base, 0.9); ///< 1 (share of that width). As above.

// Noise of measured points, and smoothing.

/// 1. Neighbours on either side in the fit that tells noise from shape: a cubic through nine points half a
/// millimetre apart leaves less than 0.1 um of an arc of 13 mm radius.
BEM_CONTACT_TUNED(std::size_t, noise_neighbours, 4);
BEM_CONTACT_TUNED(std::size_t, near_noise_neighbours, 2); ///< 1. The same where points are far apart.
/// mm. Over longer windows a cubic does not follow the arcs of 8 to 13 mm radius of all standards.
BEM_CONTACT_TUNED(double, shapeless_window, 3.0);
/// 1. The share of the points at which scatter is then looked for: of 39 rails and 12 wheels with a point
/// every 1.9 mm so many lie on one arc with their neighbours.
BEM_CONTACT_TUNED(double, quiet_share, 0.35);
/// 1. Standard deviation of a normal distribution over that quantile of its absolute values.
BEM_CONTACT_TUNED(double, normal_deviation_over_quiet, 2.2037);
/// 1. Scatter on arcs that is less than this share of the other shows that the other is shape. Of white noise
/// both agree within a third. Chosen.
BEM_CONTACT_TUNED(double, shape_share, 0.5);
/// MPa. E* of two steel bodies, for the pressure that noise makes.
BEM_CONTACT_TUNED(double, steel_contact_modulus, 115000);
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

// Holes in measured points. They are reported, not mended. All chosen.

BEM_CONTACT_TUNED(double, hole_length, 10.0); ///< 1. A hole is so many times as long as the median chord,
BEM_CONTACT_TUNED(double, least_hole, 2.0);   ///< mm. and at least so long;
BEM_CONTACT_TUNED(double, hole_turn, 2.0);    ///< deg. and the profile turns by more over it.
/// deg. Two chords that turn by more, there and back, are a jump between two scans.
BEM_CONTACT_TUNED(double, jump_turn, 45.0);
/// 1 (scatters). A single point that lies off the line of its neighbours by more is an outlier: noise hardly
/// ever has so much. Chosen.
BEM_CONTACT_TUNED(double, outlier_scatters, 12.0);
BEM_CONTACT_TUNED(double, least_outlier, 0.05); ///< mm. As above, of exact points. Chosen.
/// 1 (share of the outlier's distance). Its neighbours lie nearer to their own line without it. At a corner
/// they are off by 0.1 times as much as its point and more.
BEM_CONTACT_TUNED(double, neighbour_share, 0.05);
/// 1 (scatters). Noise alone may move a neighbour so far from its line. Chosen.
BEM_CONTACT_TUNED(double, neighbour_scatters, 5.0);

// Which side of a rail's head is worn. Both flanks are looked at as they lie at equal depths below the top.

/// mm. So far below the top the crown tells its axis; above it is too flat for a comparison along y.
BEM_CONTACT_TUNED(double, crown_depth, 2.0);
/// mm. New heads are convex. A flank that lies farther behind the line between two of its points is worn;
/// noise and the rounding of drawings stay below. Chosen.
BEM_CONTACT_TUNED(double, deepest_recess, 0.15);
/// mm. Heads of rails are no deeper; below lie fishing surface and web.
BEM_CONTACT_TUNED(double, largest_flank_depth, 34.0);
/// mm. Where a flank leads inwards by more, the head ends. What lies farther outwards, and higher than that,
/// is a keeper or another rail.
BEM_CONTACT_TUNED(double, under_head, 3.0);
/// mm. What the lowest part of the flanks is: below the wear, which ends where the flange does. It tells the
/// axis.
BEM_CONTACT_TUNED(double, unworn_flank, 6.0);
/// mm. A scan that shows less of the flanks does not tell which is worn.
BEM_CONTACT_TUNED(double, least_flanks, 16.0);
/// rad. Flanks whose axis leans by more are not inclined in the track (1:20), but one of them is worn down to
/// the end of the scan.
BEM_CONTACT_TUNED(double, largest_lean, 0.07);
/// mm. Less wear of one side than of the other tells nothing: rolling tolerances are .5 mm. Chosen.
BEM_CONTACT_TUNED(double, least_side_wear, 1.0);

// Orientation of measured points.

/// 1 (share of the chord between the ends). A rail's head that bulges down by more has its z upside down.
/// Chosen: a rail's head bulges by more than a tenth of its width.
BEM_CONTACT_TUNED(double, least_bulge, 0.005);
/// 1. A profile that bulges to the other side of that chord by more than this share has no side that is up: a
/// head beside a groove has a half. Chosen; worn heads stay below a twentieth.
BEM_CONTACT_TUNED(double, both_bulges, 0.2);
/// mm. The middle of a rail that is measured from the centre of the track lies between these, for gauges from
/// 600 to 1676 mm.
BEM_CONTACT_TUNED(double, nearest_rail_to_centre, 250.0);
BEM_CONTACT_TUNED(double, farthest_rail_from_centre, 950.0); ///< mm. As above.
/// rad. The flank of a flange is as steep as 60 to 78 degrees, chamfers are 45, and faces of rims vertical.
BEM_CONTACT_TUNED(double, flattest_flank, 50 * std::numbers::pi / 180);
BEM_CONTACT_TUNED(double, steepest_flank, 82 * std::numbers::pi / 180); ///< rad. As above.
/// mm. Something wider than a rail's head whose top is narrower than this, so far below its highest point, is
/// a wheel with its flange up. The head of 60E1 is 72 mm wide, and 56 mm at this depth.
BEM_CONTACT_TUNED(double, top_depth, 3.0);
BEM_CONTACT_TUNED(double, narrowest_top, 25.0);    ///< mm. As above.
BEM_CONTACT_TUNED(double, widest_rail_head, 90.0); ///< mm. As above.

} // namespace bem_contact
