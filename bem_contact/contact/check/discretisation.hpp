#pragma once

#include "bem_contact/contact/result.hpp"

#include <optional>
#include <string>

namespace bem_contact::contact {

/// Why the result of the same problem on elements twice as large says nothing of errors: its certificate is
/// worse than settings.hpp's companion_violation, or too few of its elements are in contact. With what to do.
/// "": it says something.
std::string why_not_compared(const ContactProblem& coarse_problem, const ContactResult& coarse);

/// Compares a result with that of the same problem on elements twice as large (grid/larger_elements.hpp).
/// Nothing where why_not_compared() says why.
std::optional<Discretisation> compare(const ContactProblem& problem, const ContactResult& result,
                                      const ContactProblem& coarse_problem, const ContactResult& coarse);

} // namespace bem_contact::contact
