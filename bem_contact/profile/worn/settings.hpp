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
/// 1 (share of the points). The fit is given up where fewer are near: it would follow noise. Chosen.
BEM_CONTACT_TUNED(double, least_placing_weight, 0.05);
BEM_CONTACT_TUNED(double, largest_placing_angle, 0.12); ///< rad. No rail is measured more inclined.
/// 1. What a point on the top of a rail tells of its place, beside one on a vertical flank: wheels wear the
/// top and the gauge corner. With 1, 0.3 mm off the top and 0.6 mm off the corner turn the place of 60E1 by
/// 1.6 mrad, and 2 mm worn evenly off the top lay it on the worn top.
BEM_CONTACT_TUNED(double, told_on_top, 0.1);
/// mm. A point this near is unworn. Chosen.
BEM_CONTACT_TUNED(double, unworn_distance, 0.1);
/// 1 (scatters). Noise alone moves hardly any point by more.
BEM_CONTACT_TUNED(double, placing_scatters, 3.0);
/// mm. Within these, one after the other, a point counts during the search.
inline constexpr double placing_widths[] = {6.0, 2.0, 0.8, 0.4};
BEM_CONTACT_TUNED(double, searching_tolerance, 1e-4); ///< mm. Where the steps of a fit end in the search.
BEM_CONTACT_TUNED(int, searching_steps, 6);           ///< 1. Steps of a fit in each width,
BEM_CONTACT_TUNED(int, settling_steps, 20);           ///< 1. and at the place found.
BEM_CONTACT_TUNED(double, settling_medians, 5.0);     ///< 1. within so many median distances,
/// mm. So far beyond its end a point still belongs to a nominal profile: noise may move the last one.
BEM_CONTACT_TUNED(double, beyond_end, 0.05);
/// 1 (share of the points). Where more of a profile lies outside a nominal one, by more than its scatter, it
/// is not worn from that: wear takes steel away, and the steel that flows makes narrow lips. Chosen.
BEM_CONTACT_TUNED(double, most_outside, 0.05);
/// rad. Wheels are measured from the flat back of their rim: no file is turned by more.
BEM_CONTACT_TUNED(double, largest_wheel_turn, 0.008);
// Symmetry of a rail's head.

/// rad. The search for the axis begins at these: upright, and inclined 1:20.
inline constexpr double symmetry_starts[] = {0.0, -0.05};
/// mm. Within these, one after the other, a point counts.
inline constexpr double symmetry_widths[] = {3.0, 1.0, 0.4, 0.2, 0.1};

} // namespace bem_contact
