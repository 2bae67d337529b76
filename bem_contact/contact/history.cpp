#include "bem_contact/contact/history.hpp"

#include "bem_contact/base/error.hpp"

namespace bem_contact {

std::vector<ContactResult> solve_history(ContactProblem problem, int steps,
                                         const std::function<void(int, ContactProblem&)>& prescribe,
                                         const SolverOptions& given) {
  Workspace own;
  SolverOptions options = given;
  if (!options.workspace)
    options.workspace = &own; // the numbers stay the same
  if (problem.motion == MotionKind::steady)
    throw InputError("Steady rolling has no steps", "it is the state that steps lead to",
                     "Solve it as one problem, or choose a shift or transient rolling.");
  const std::size_t kept = problem.motion == MotionKind::transient ? 2 : 1;
  std::vector<ContactResult> results;
  for (int k = 0; k < steps; ++k) {
    prescribe(k, problem);
    options.displacements = given.displacements && k == steps - 1;
    options.continues = given.continues || k > 0;
    results.push_back(solve(problem, options));
    problem.previous.insert(problem.previous.begin(), tractions_of(results.back()));
    if (problem.previous.size() > kept)
      problem.previous.resize(kept);
  }
  return results;
}

} // namespace bem_contact
