#pragma once

#include "bem_contact/base/tuned.hpp"

#include <cstddef>

/// The tuned numbers of this room (base/tuned.hpp).
namespace bem_contact::app {

// Profiles in words.

/// mm. Step of the points that `profile --csv` writes. It is the step of the contact search.
BEM_CONTACT_TUNED(double, profile_csv_step, 0.1);

} // namespace bem_contact::app
