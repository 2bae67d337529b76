#include "bem_contact/contact/tangential/friction.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace bem_contact::contact {

void solve_tangential(const TangentialSystem& system, const TangentialTask& task,
                      const SolverOptions& options, TangentialState& state) {
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
  newton(system, task, options, state);
  if (state.converged || options.only_newton)
    return;

  state.p = start;
  sweeps(system, task, options.tolerance, options.max_sweeps, state);
  if (state.converged)
    return;
  state.remark += fmt::format("sweeps: violation {:.1e} left; ", state.violation);

  roll_on(system, task, options, 6 * system.problem->grid.mx, state);
  if (state.converged)
    return;
  state.remark += fmt::format("rolling on: violation {:.1e} left; ", state.violation);
  if (options.max_tangential > 0) {
    newton(system, task, options, state);
    state.solver = "rolling on, then " + state.solver;
  }
}

} // namespace bem_contact::contact
