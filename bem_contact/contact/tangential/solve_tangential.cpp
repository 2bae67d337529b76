#include "bem_contact/contact/tangential/solve_tangential.hpp"

#include "bem_contact/contact/settings.hpp"
#include "bem_contact/contact/tangential/element_sweeps.hpp"
#include "bem_contact/contact/tangential/newton.hpp"
#include "bem_contact/contact/tangential/roll_on.hpp"

#include <fmt/format.h>

namespace bem_contact::contact {

void solve_tangential(const TangentialSystem& system, const TangentialTask& task,
                      const SolverOptions& options, WorkBudget& work, TangentialState& state) {
  const int n = system.size();
  if (state.p.size() != 2 * n)
    state.p = Eigen::VectorXd::Zero(2 * n);
  state.remark.clear();
  if (task.contact.empty()) {
    state.p.setZero();
    state.slip = task.drive;
    state.converged = true;
    state.solver = "none";
    return;
  }
  const Eigen::VectorXd start = state.p;
  newton(system, task, options, work, state);
  if (state.converged || options.only_newton)
    return;

  state.p = start;
  sweep_elements(system, task, options.tolerance, options.max_sweeps, work, state);
  if (state.converged)
    return;
  state.remark += fmt::format("sweeps: violation {:.1e} left; ", state.violation);

  roll_on(system, task, options, rolling_on_lengths * system.columns(), work, state);
  if (state.converged)
    return;
  state.remark += fmt::format("rolling on: violation {:.1e} left; ", state.violation);
  if (options.max_tangential > 0) {
    newton(system, task, options, work, state);
    state.solver = "rolling on, then " + state.solver;
  }
}

} // namespace bem_contact::contact
