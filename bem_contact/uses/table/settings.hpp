#pragma once

#include "bem_contact/base/tuned.hpp"

#include <cstddef>

/// The tuned numbers of this room (base/tuned.hpp).
namespace bem_contact::table {

/// 1, of the largest of a cell's errors along its axes: axes with a larger one are refined, all at once.
BEM_CONTACT_TUNED(double, axis_share, 0.7);

} // namespace bem_contact::table
