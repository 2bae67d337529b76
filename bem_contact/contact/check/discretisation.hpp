#pragma once

#include "bem_contact/contact/result.hpp"

#include <optional>

namespace bem_contact::contact {

/// Compares a result with that of the same problem on elements twice as large (grid/larger_elements.hpp).
/// Nothing where the certificate of the coarse result is worse than settings.hpp's companion_violation, or
/// where too few of its elements are in contact.
std::optional<Discretisation> compare(const ContactProblem& problem, const ContactResult& result,
                                      const ContactProblem& coarse_problem, const ContactResult& coarse);

} // namespace bem_contact::contact
