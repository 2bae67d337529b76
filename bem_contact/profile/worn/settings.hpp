#pragma once

#include "bem_contact/base/tuned.hpp"

#include <cstddef>

/// Tuned numbers of profile/worn. For the words see base/tuned.hpp.
namespace bem_contact {

// Nominal profiles, from which measured ones are worn.

/// rad and mm. The search for a place begins at all of these: how measured profiles are inclined and shifted.
inline constexpr double placing_angles[] = {0.0, -0.025, 0.025, -0.05, 0.05};
inline constexpr double placing_sides[] = {0.0, -4.0, 4.0, -10.0, 10.0}; ///< mm. As above.
/// mm. Arm with which turns become lengths: half of a head's width.
BEM_CONTACT_TUNED(double, placing_arm, 30.0);
/// 1 (of the total weight). Added to the diagonal of the fit, so that a place along which a profile can slide
/// stays where it is.
BEM_CONTACT_TUNED(double, placing_damping, 1e-9);
BEM_CONTACT_TUNED(double, placing_tolerance, 1e-6); ///< mm. Where the steps of a fit end.
/// 1 (share of the points). The fit is given up where fewer are near: it would follow noise. Chosen.
BEM_CONTACT_TUNED(double, least_placing_weight, 0.05);
BEM_CONTACT_TUNED(double, largest_placing_angle, 0.12); ///< rad. No rail is measured more inclined.
/// 1. What a point on the top of a rail tells of its place, beside one on a vertical flank: wheels wear the
/// top and the gauge corner. With 1, .3 mm off the top and .6 mm off the corner turn the place of 60E1 by
/// 1.6 mrad, and 2 mm worn evenly off the top lay it on the worn top.
BEM_CONTACT_TUNED(double, told_on_top, 0.1);
/// 1 (widths of Tukey's weights). Points outside a nominal profile count up to so many times as far off as
/// worn ones: wear takes steel away. Lips of the steel, some tenths high, still do not count. Chosen.
BEM_CONTACT_TUNED(double, outside_widths, 4.0);
/// mm. A point this near is unworn. Chosen.
BEM_CONTACT_TUNED(double, unworn_distance, 0.1);
/// 1 (scatters). Noise alone moves hardly any point by more.
BEM_CONTACT_TUNED(double, placing_scatters, 3.0);
/// mm. Within these, one after the other, a point counts during the search.
inline constexpr double placing_widths[] = {6.0, 2.0, 0.8, 0.4};
BEM_CONTACT_TUNED(double, searching_tolerance, 1e-4); ///< mm. Where the steps of a fit end in the search.
BEM_CONTACT_TUNED(int, searching_steps, 6);           ///< 1. Steps of a fit in each width,
BEM_CONTACT_TUNED(int, settling_steps, 20);           ///< 1. and at the place found.
BEM_CONTACT_TUNED(int, settling_rounds, 3);           ///< 1. Of a fit to what lies as near as most does:
BEM_CONTACT_TUNED(double, settling_medians, 5.0);     ///< 1. within so many median distances,
BEM_CONTACT_TUNED(double, settling_least, 0.01);      ///< mm. but not within less: the rounding of a file.
BEM_CONTACT_TUNED(std::size_t, searched_places, 5);   ///< 1. Starts that are followed: the nearest ones.
BEM_CONTACT_TUNED(std::size_t, settled_places, 2);    ///< 1. Places of which the share is asked for,
BEM_CONTACT_TUNED(double, nearly_as_near, 1.5);    ///< 1. the second if it is off by less than so many times.
BEM_CONTACT_TUNED(std::size_t, rating_points, 25); ///< 1. Points by which starts are compared. Chosen.
BEM_CONTACT_TUNED(int, polishing_steps, 6);        ///< 1. Steps of the last fit, on the profile itself.
BEM_CONTACT_TUNED(std::size_t, placing_points, 40);   ///< 1. Points with which a place is looked for. Chosen.
BEM_CONTACT_TUNED(std::size_t, settling_points, 150); ///< 1. Points with which it is found. Chosen.
BEM_CONTACT_TUNED(double, apart_distance, 0.5);       ///< mm. Nearer places are the same,
BEM_CONTACT_TUNED(double, apart_angle, 5e-3);         ///< rad. if their angles are as near.
/// mm. Chords with which points are placed. Their bulges counted, an arc of 13 mm radius is off by
/// nanometres, the curve at a jump of the curvature by 2 um.
BEM_CONTACT_TUNED(double, outline_chord, 0.5);
/// 1. Of so many chords one is looked at where a point is far from the one before.
BEM_CONTACT_TUNED(std::size_t, looked_at_chords, 6);
/// mm. A point that is farther from the chord of the point before may be nearer to another part of the curve.
BEM_CONTACT_TUNED(double, far_from_chord, 6.0);
/// mm. Points this near to the top (of a wheel: to the tip) say where the middle of it is. Chosen.
BEM_CONTACT_TUNED(double, placing_top, 2.0);
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
/// mm. So near a point lies on the nominal profile but for its scatter.
BEM_CONTACT_TUNED(double, lies_on_nominal, 0.02);
/// 1 (share of the points). A standard on which less of a profile lies is not like it. New wheels of seven
/// other shapes lie on S1002 by .05 to .16, S1002 worn by 2 mm on the whole tread by .33.
BEM_CONTACT_TUNED(double, least_unworn_share, 0.25);
BEM_CONTACT_TUNED(double, surely_like_share,
                  0.5); ///< 1. On the standard from which it is worn more lies. Chosen.
/// 1 (share of the points). Where more of a profile lies outside a nominal one, by more than its scatter, it
/// is not worn from that: wear takes steel away, and the steel that flows makes narrow lips. Chosen.
BEM_CONTACT_TUNED(double, most_outside, 0.05);
/// rad. Inclinations by a standard and by symmetry that differ by more do not belong together: 1 mm off the
/// top and .6 mm off the gauge corner move that by symmetry by 4 mrad (46E3), and 49E1 lies on 54E1 turned by
/// 6 mrad and more.
BEM_CONTACT_TUNED(double, symmetry_slack, 0.005);
/// rad. Wheels are measured from the flat back of their rim: no file is turned by more.
BEM_CONTACT_TUNED(double, largest_wheel_turn, 0.008);
/// rad. A rail that is turned by this or more towards the track's centre was measured as it lies in the
/// track: half of 1:40, the smallest inclination in use.
BEM_CONTACT_TUNED(double, least_inclination, 0.0125);
// Symmetry of a rail's head.

/// rad. Heads turn by 160 degrees from side to side; a running surface that turns by less is another thing.
BEM_CONTACT_TUNED(double, least_head_turn, 1.0);
/// rad. The search for the axis begins at these: upright, and inclined 1:20.
inline constexpr double symmetry_starts[] = {0.0, -0.05};
/// 1. Chords of the measured head: about a millimetre long. Chosen.
BEM_CONTACT_TUNED(int, symmetry_chords, 150);
/// mm. Within these, one after the other, a point counts.
inline constexpr double symmetry_widths[] = {3.0, 1.0, 0.4, 0.2, 0.1};
BEM_CONTACT_TUNED(double, symmetry_least,
                  0.03); ///< mm. Last width at least: what sides differ by, as rolled.
/// 1 (last widths). What lies so near to its mirror image is symmetric.
BEM_CONTACT_TUNED(double, symmetric_widths, 1.5);
/// 1 (cosine to the horizontal). Steeper parts, beyond 64 degrees, are the sides of a head.
BEM_CONTACT_TUNED(double, steep_cosine, 0.44);
/// 1. Shares of the sides and of what is between that must be symmetric. A flank and a worn gauge face, with
/// an axis that is wrong by 25 to 50 mrad, cross the top so that .03 to .04 of it lies on its image; 1 mm off
/// the top and .6 mm off the gauge corner of 39 standards leave .15 and more.
BEM_CONTACT_TUNED(double, least_symmetric_sides, 0.5);
BEM_CONTACT_TUNED(double, least_symmetric_top, 0.15); ///< 1. As above.
BEM_CONTACT_TUNED(double, whole_top, 0.9); ///< 1. Share of a top that is not worn on one side. Chosen.

// The depth of wear.

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

} // namespace bem_contact
