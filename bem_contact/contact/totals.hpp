#pragma once

#include "bem_contact/contact/problem.hpp"
#include "bem_contact/contact/result.hpp"

namespace bem_contact {

/// Sets what follows from the tractions and states of a result: forces and moment, patches, and whether the
/// contact reaches an edge of the grid.
void set_totals(const ContactProblem& problem, ContactResult& result);

} // namespace bem_contact
