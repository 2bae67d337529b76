#pragma once

#include "bem_contact/base/tuned.hpp"

/// The tuned numbers of this room (base/tuned.hpp).
namespace bem_contact::inside {

/// 1. Points across a patch along s at which stresses are taken, about; fewer where it has fewer rows.
BEM_CONTACT_TUNED(int, points_across, 20);
/// 1. The same along x, which is the time of the passage. Chosen: half as many would miss the corners of the
/// path.
BEM_CONTACT_TUNED(int, times_across, 30);
/// 1 (smaller half width of the patch). How far before and behind the patch the passage begins and ends:
/// chosen.
BEM_CONTACT_TUNED(double, passage_margin, 1.0);
/// 1 (smaller half width of the patch). Width of the block beside the patch, in which residual stresses may
/// be. Chosen.
BEM_CONTACT_TUNED(double, block_margin, 2.5);

/// 1. Terms of a body's Fourier series along x that are taken as they are; the others are an integral over
/// wavenumbers.
BEM_CONTACT_TUNED(int, lowest_waves, 8);
/// 1 (over the least depth). The largest wavenumber of stresses: what is above it has decayed at this depth
/// to 4 % of an amplitude that is a hundredth itself.
BEM_CONTACT_TUNED(double, largest_wavenumber_times_depth, 5);
/// 1 (width of a station). The least depth at which a body is solved for: nearer to the surface the mesh
/// shows, and the more wavenumbers are needed the nearer it is.
BEM_CONTACT_TUNED(double, least_depth_of_station, 1.5);

} // namespace bem_contact::inside
