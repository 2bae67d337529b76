#pragma once

#include "bem_contact/contact/coupled/contact_operators.hpp"
#include "bem_contact/contact/coupled/solution.hpp"
#include "bem_contact/contact/solver_options.hpp"

#include <functional>

namespace bem_contact::contact {

/// A look at a solution before it is precise.
struct RoughLook {
  double change = 0;                         ///< relative; as EarlyEnd has it
  std::function<bool(const Solution&)> ends; ///< called once at most; true: no more outer iterations
};

/// Solves the normal and the tangential problem in turn (Panagiotopoulos 1975) until the normal displacement
/// and the vertical force that the shear tractions cause no longer change. One outer iteration is enough
/// where shear does not act on the normal problem. Where it acts by its vertical force alone, ForceBalance
/// looks for the pressure that balances the load; else Anderson acceleration finds both. `operators` belong
/// to the influence numbers and the grid of the problem. Throws InputError if friction cannot carry the
/// prescribed shear forces. `look`: null, or what may end the iterations.
Solution solve_coupled(const ContactProblem& problem, const SolverOptions& options,
                       ContactOperators& operators, WorkBudget& work, const RoughLook* look = nullptr);

/// Throws InputError if friction cannot carry the prescribed shear forces.
void require_capacity(const ContactProblem& problem, const FoundCreepage& creepage);

} // namespace bem_contact::contact
