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

} // namespace bem_contact
