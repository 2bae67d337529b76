#pragma once

#include "bem_contact/base/tuned.hpp"

#include <cstddef>

/// The tuned numbers of this room (base/tuned.hpp).
namespace bem_contact::app {

// Plain influence numbers.

/// GB. Largest table that `influence expand` writes. The table is held in memory three times (rail, wheel and
/// pair). Chosen, not measured: it allows 20 offsets of 950 rows.
BEM_CONTACT_TUNED(double, largest_table, 4.0);

/// 1, part of the self number. One matrix serves all rows if numbers of equal distance differ by less than
/// this along the strip. Chosen, not measured.
BEM_CONTACT_TUNED(double, largest_variation, 0.01);

// Numbers and messages.

/// Characters. A message that came several times is counted at the end, and quoted up to this length: enough
/// to recognise it. Chosen.
BEM_CONTACT_TUNED(int, repeated_length, 60);

// Profiles in words.

/// mm. `profile` prints one mean radius for each stretch of this length. A wheel has about 30 of them.
BEM_CONTACT_TUNED(double, radius_stretch, 5.0);
/// mm. A larger radius is printed as straight. Chosen.
BEM_CONTACT_TUNED(double, straight_radius, 20000.0);
/// mm. Step of the points that `profile --csv` writes. It is the step of the contact search.
BEM_CONTACT_TUNED(double, profile_csv_step, 0.1);

} // namespace bem_contact::app
