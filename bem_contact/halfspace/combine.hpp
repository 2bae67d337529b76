#pragma once

#include "bem_contact/influence/influence_numbers.hpp"

namespace bem_contact::halfspace {

/// The pair's numbers in the contact frame: A = A_rail + T A_wheel T, where T = diag(1, -1, -1) turns the
/// wheel's own frame into the contact frame. Rows of `upper` are already in the order of the contact's rows.
/// Throws InputError unless both belong to the same grid.
InfluenceNumbers combine(const InfluenceNumbers& lower, InfluenceNumbers upper);

/// The pair of two equal bodies whose numbers are translational. The rows of the upper one run against those
/// of the lower one, so that its number from row J to row I is A_ij(m; J, I), which is parity(i, j) A_ji(m;
/// I, J): together A + A^T for each pair of rows.
InfluenceNumbers combine_equal(InfluenceNumbers body);

} // namespace bem_contact::halfspace
