#pragma once

#include "bem_contact/contact/result.hpp"

#include <string>

namespace bem_contact::contact {

/// Why the result of the same problem on elements twice as large says nothing of errors: its certificate is
/// worse than settings.hpp's companion_violation, or too few of its elements are in contact. With what to do.
/// "": it says something.
std::string why_not_compared(const ContactProblem& coarse_problem, const ContactResult& coarse);

/// Compares a result with that of the same problem on elements twice as large (grid/larger_elements.hpp):
/// adds its Discretisation and the errors of its numbers, or why_not_compared().
void compare(const ContactProblem& problem, const ContactProblem& coarse_problem, const ContactResult& coarse,
             ContactResult& result);

} // namespace bem_contact::contact
