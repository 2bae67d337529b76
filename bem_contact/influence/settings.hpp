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
/// 1 (harmonics). and without a phase from this harmonic on (Euler-Maclaurin: next term below 1e-16).
BEM_CONTACT_TUNED(double, expansion_start, 64.0);
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
/// Sets of points that are kept: two files, on a few sizes of grids. A set has about 100 kB. Chosen.
BEM_CONTACT_TUNED(std::size_t, series_points_kept, 16);
/// 1. How far the phase of least_half_element_phase may fall short: rounding.
BEM_CONTACT_TUNED(double, phase_slack, 1e-9);
/// 1 (share of a wavenumber). A harmonic that is beyond the last sample by less is not beyond it: rounding.
BEM_CONTACT_TUNED(double, last_sample_slack, 1e-12);
/// 1 (share of a wavenumber). A harmonic this near to a sample is that sample: rounding.
BEM_CONTACT_TUNED(double, sample_snap, 1e-10);

// Numbers on the file's stations.

/// 1. Reciprocal condition of the remote section's compliance, scaled to a unit diagonal, below which the
/// structure is not removed: its inverse would have no correct digits.
BEM_CONTACT_TUNED(double, least_remote_condition, 1e-13);
/// 1. How far the ratio of an element's length to a table's may be from a whole number: rounding.
BEM_CONTACT_TUNED(double, whole_ratio_slack, 1e-9);
/// 1 (station widths). How unequally stations may be spaced: the rounding of s in a file.
BEM_CONTACT_TUNED(double, station_spacing_slack, 1e-6);
/// 1 (share of half a turn). How far the half period of a body of revolution may be off: rounding.
BEM_CONTACT_TUNED(double, half_turn_slack, 1e-9);

/// 1 (share of the arc lengths). How far a patch may reach beyond the strip: rounding.
BEM_CONTACT_TUNED(double, strip_rounding, 1e-9);

// Files.

/// 1. Of an influence file so many times the stations are read that a first contact needs: its patch may
/// grow, and the next case be beside it.
BEM_CONTACT_TUNED(int, first_stations_read, 2);
/// 1. And so many times those that were needed so far, when the contact has left them: each reading goes
/// through the file, 5 ms for 15 MB, so there should be few of them. Chosen, as the one before.
BEM_CONTACT_TUNED(int, more_stations_read, 3);
/// 1. Error figures that a wavenumber may have in the file of finished ones: more mean a damaged file.
BEM_CONTACT_TUNED(std::size_t, most_errors, 1000);

// Structure.

/// mm. Length along x over which the motion of a strip is averaged and its force is spread: about that of a
/// contact. Structural motion varies over 20 mm and more, the distance of the remote section.
BEM_CONTACT_TUNED(double, structure_length, 10.0);
/// 1. Elements of that length. A force spread by 10 in place of 5 changes the matrix by less than 1e-3.
BEM_CONTACT_TUNED(int, structure_elements, 5);
/// 1. Least reciprocal condition number (unit diagonal) of a structure's compliance that is inverted:
/// rounding of the influence numbers would show in the stiffness of a worse one.
BEM_CONTACT_TUNED(double, least_structure_condition, 1e-12);

} // namespace bem_contact
