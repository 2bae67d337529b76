#include "bem_contact/contact/tangential/kinetic_friction.hpp"

#include "bem_contact/contact/tangential/settings.hpp"
#include "bem_contact/contact/tangential/solve_tangential.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace bem_contact::contact {

void solve_with_kinetic_friction(const TangentialSystem& system, const SolverOptions& options,
                                 WorkBudget& work, TangentialTask& task, TangentialState& state) {
  const double kinetic = system.problem->kinetic;
  if (kinetic == 1)
    return solve_tangential(system, task, options, work, state);
  const int n = system.size();
  std::vector<char>& slipped = state.slipped = state.held;
  slipped.resize(n, 0);
  for (const int i : task.contact)
    if (slipped[i])
      task.bound[i] *= kinetic;
  for (bool grown = true; grown;) {
    solve_tangential(system, task, options, work, state);
    if (!state.converged)
      return;
    const double scale = largest_slip(task.rigid, task.contact, state.slip, task.slip_floor);
    const double slips =
        std::max(at_the_bound, options.tolerance) * scale; // less may be left where it sticks
    grown = false;
    for (const int i : task.contact)
      if (!slipped[i] && std::hypot(state.slip[i], state.slip[n + i]) > slips) {
        slipped[i] = 1;
        task.bound[i] *= kinetic;
        grown = true;
      }
  }
}

} // namespace bem_contact::contact
