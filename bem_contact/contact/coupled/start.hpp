#pragma once

#include "bem_contact/contact/coupled/contact_operators.hpp"
#include "bem_contact/contact/coupled/solution.hpp"
#include "bem_contact/contact/solver_options.hpp"

namespace bem_contact::contact {

/// What the outer iterations start from: options.near, or the guess of options.start; else
/// (options.coarse_start) the solution of the same problem on elements twice as large, solved loosely; else
/// nothing.
Solution start(const ContactProblem& problem, const SolverOptions& options, ContactOperators& operators,
               WorkBudget& work);

} // namespace bem_contact::contact
