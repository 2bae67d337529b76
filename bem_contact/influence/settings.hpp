#pragma once

#include "bem_contact/base/tuned.hpp"

#include <cstddef>

/// The tuned numbers of this room (base/tuned.hpp).
namespace bem_contact {

// The Fourier series.

/// 1. Half an element's length times the largest wavenumber must be at least this. What is left beyond is
/// then about 1 % of self, and its extrapolation is good to a hundredth of that (tests/influence).
BEM_CONTACT_TUNED(double, least_half_element_phase, 5.0);
/// 1 (largest wavenumbers). How far the series is summed beyond the last sample. What is left is 1/16^2 of a
/// tail that is itself about 1 % of self; its mean is added in closed form.
BEM_CONTACT_TUNED(double, tail_reach, 16.0);
/// rad. From this phase on a sum over harmonics is replaced by its expansion, whose smallest term is then
/// below 1e-10 of its first;
BEM_CONTACT_TUNED(double, expansion_phase, 36.0);
/// 1 (share of the sum). Smaller terms of it no longer count.
BEM_CONTACT_TUNED(double, expansion_tolerance, 1e-17);
/// Octaves of harmonics beyond the last sample that have points. The shortest elements
/// (least_half_element_phase) need two.
BEM_CONTACT_TUNED(int, tail_octaves, 2);
/// 1 (offsets). Cosines follow from each other by rotation, and anew from the angle after so many: rounding
/// grows with their number.
BEM_CONTACT_TUNED(long, rotated_offsets, 16);
/// 1. Points that stand for a run of harmonics (harmonic_points()): so many more than the radians in half
/// of the run, times their cube root. There the Chebyshev series of a wave has ended at 1e-16.
BEM_CONTACT_TUNED(double, point_reserve, 7.0);
/// 1. And so many for the factor beside the wave: it is analytic down to k = 0, and a run is a third of its
/// wavenumber long.
BEM_CONTACT_TUNED(int, least_points, 18);
/// 1. Points that are kept for later elements serve angles up to a step on this ladder: up to a fifth more
/// points than the elements need, and few different sets.
BEM_CONTACT_TUNED(double, angles_per_octave, 4);

// Packed files.

/// 1 (smallest self number). Step to which a packed file rounds: a hundredth of what two computations of one
/// body differ by. 1e-5 would save a sixth of the bytes more.
BEM_CONTACT_TUNED(double, packed_step, 1e-6);

} // namespace bem_contact
