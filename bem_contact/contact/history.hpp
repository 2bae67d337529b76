#pragma once

#include "bem_contact/contact/solve.hpp"

#include <functional>
#include <vector>

namespace bem_contact {

/// Solves `steps` load steps of a shift, or rolling steps of transient rolling, one after the other.
/// `prescribe(k, problem)` sets what step k = 0 .. steps - 1 prescribes (load, rigid slip, forces, undeformed
/// distance). Then the step is solved, with the tractions of the steps before it as `problem.previous`. Step
/// 0 has the `previous` of the problem given (empty: the bodies start from rest). Returns one result a step.
/// If a step did not converge, its result says so and the next steps go on from it.
/// Throws InputError for steady rolling, and whatever solve() throws.
std::vector<ContactResult> solve_history(ContactProblem problem, int steps,
                                         const std::function<void(int, ContactProblem&)>& prescribe,
                                         const SolverOptions& options = {});

} // namespace bem_contact
