#pragma once

#include "bem_contact/base/tuned.hpp"

/// Tuned numbers of sequence/numbers. For the words see base/tuned.hpp.
namespace bem_contact {

// What is kept for the next case.

/// 1. Influence numbers of this many grids are kept: the numbers of one grid take up to 8 GB.
BEM_CONTACT_TUNED(int, numbers_kept, 6);
/// MB. But no more than this, the last grid's not counted; and the same for the rail's own numbers. A case of
/// 2 % accuracy has 2 to 20 MB.
BEM_CONTACT_TUNED(double, largest_kept_numbers, 200.0);
/// MB. No more influence functions than this are kept beside the pair used last and the rails of the kept
/// numbers. Chosen: five pairs of whole running surfaces, 400 stations each, which have 384 MB a pair.
BEM_CONTACT_TUNED(double, largest_kept_files, 2000.0);
BEM_CONTACT_TUNED(int, profiles_kept, 100); ///< 1. Pairs of profiles that are kept: 0.5 MB each. Chosen.

/// 1. Influence files whose stresses of the inside are kept: those of a pair. One has up to 200 MB.
BEM_CONTACT_TUNED(int, files_of_stresses_kept, 2);

// Influence functions.

/// 1 (rows). How much of a row must lie on the strip of an influence file, on either side of its middle: rows
/// of equal width on the rail are a hair shorter or longer on the wheel.
BEM_CONTACT_TUNED(double, row_on_strip, 0.49);

} // namespace bem_contact
