#pragma once

#include "bem_contact/contact/problem.hpp"
#include "bem_contact/contact/result.hpp"

namespace bem_contact::contact {

/// Estimates the error of each printed number: sets those of `result`'s totals and patches, and what its
/// Discretisation says of the moment and of convergence. Each estimate is a share of the change from the
/// coarse result to this one, and a local part, because the two may agree by chance: whole elements at the
/// borders of contact and adhesion, the tractions of the elements in adhesion, and the fall of the pressure
/// beside its peak (theory/estimates_and_heat.md, section 2). This result is certified; the coarse one
/// violates its conditions by at most companion_violation (settings.hpp).
void estimate_errors(const ContactProblem& problem, const ContactProblem& coarse_problem,
                     const ContactResult& coarse, ContactResult& result);

/// The error of ContactTotals::creepage_x alone, of two rough solutions; unknown_error where the coarse one
/// says nothing.
double creepage_x_error(const ContactProblem& problem, const ContactResult& result,
                        const ContactProblem& coarse_problem, const ContactResult& coarse);

} // namespace bem_contact::contact
