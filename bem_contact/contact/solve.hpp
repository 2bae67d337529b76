#pragma once

#include "bem_contact/contact/check/certificate.hpp"
#include "bem_contact/contact/problem.hpp"
#include "bem_contact/contact/result.hpp"
#include "bem_contact/contact/solver_options.hpp"
#include "bem_contact/contact/work.hpp"
#include "bem_contact/contact/workspace.hpp"

namespace bem_contact {

/// Solves one contact problem: the normal problem alone, or with friction. Without contact the result has
/// zero force and no patches. If the solvers do not converge the result says `converged == false` and why;
/// nothing is thrown. Throws InputError for a problem that is not valid or has no solution, ConvergenceError
/// if the work allowed is used up.
ContactResult solve(const ContactProblem& problem, const SolverOptions& options = {});

/// The same with a budget that all problems of one case (one scene) share.
ContactResult solve(const ContactProblem& problem, const SolverOptions& options, WorkBudget& work);

} // namespace bem_contact
