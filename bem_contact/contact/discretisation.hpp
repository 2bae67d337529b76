#pragma once

#include "bem_contact/contact/solve.hpp"

#include <span>

namespace bem_contact::contact {

/// Estimated relative discretisation error of the normal force at the approach found: the normal problem is
/// solved again on elements twice as large in x and s, whose numbers are exact sums of the fine ones (both
/// average over the element) and whose gap is taken at their centres, and |F_coarse - F_fine| / F_fine is
/// returned. On Hertz contacts this is .7 to 8 times the true error. Friction enters
/// through the given displacement `from_shear` = (A p_t)_n. Returns -1 where an odd row or column in contact
/// forbids it, or where nothing touches.
double estimate_discretisation(const ContactProblem& problem, const ContactResult& result,
                               std::span<const double> from_shear, const SolverOptions& options);

} // namespace bem_contact::contact
