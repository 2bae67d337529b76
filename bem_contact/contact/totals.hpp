#pragma once

#include "bem_contact/contact/problem.hpp"
#include "bem_contact/contact/result.hpp"

namespace bem_contact {

/// Sets what follows from the fields of a result: its patches, its totals but approach and creepages, and
/// whether the contact reaches an edge of the grid.
void set_totals(const ContactProblem& problem, ContactResult& result);
/// Sets the totals that follow from the patches alone: pmax, area and share of adhesion.
void set_totals_of_patches(ContactResult& result);

} // namespace bem_contact
