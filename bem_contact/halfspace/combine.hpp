#pragma once

#include "bem_contact/influence/influence_numbers.hpp"

namespace bem_contact::halfspace {

/// The pair's numbers in the contact frame: A = A_rail + T A_wheel T, where T = diag(1, -1, -1) turns the
/// wheel's own frame into the contact frame. Rows of `upper` are already in the order of the contact's rows.
/// Throws InputError unless both belong to the same grid.
InfluenceNumbers combine(const InfluenceNumbers& lower, InfluenceNumbers upper);

} // namespace bem_contact::halfspace
