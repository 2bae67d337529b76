#include "bem_contact/contact/tangential/kinetic_friction.hpp"

#include "bem_contact/contact/tangential/settings.hpp"
#include "bem_contact/contact/tangential/solve_tangential.hpp"

#include <cmath>
#include <vector>

namespace bem_contact::contact {

void solve_with_kinetic_friction(const TangentialSystem& system, const SolverOptions& options,
                                 WorkBudget& work, TangentialTask& task, TangentialState& state) {
  const double kinetic = system.problem->kinetic;
  if (kinetic == 1)
    return solve_tangential(system, task, options, work, state);
  const int n = system.size();
  std::vector<char> slipped(n, 0);
  for (bool grown = true; grown;) {
    solve_tangential(system, task, options, work, state);
    const double scale = largest_slip(task.rigid, task.contact, state.slip, task.slip_floor);
    grown = false;
    for (const int i : task.contact)
      if (!slipped[i] && std::hypot(state.p[i], state.p[n + i]) > (1 - at_the_bound) * task.bound[i] &&
          std::hypot(state.slip[i], state.slip[n + i]) > at_the_bound * scale) {
        slipped[i] = 1;
        task.bound[i] *= kinetic;
        grown = true;
      }
  }
}

} // namespace bem_contact::contact
