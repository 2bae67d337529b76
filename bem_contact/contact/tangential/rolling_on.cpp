#include "bem_contact/contact/tangential/friction.hpp"

#include "bem_contact/contact/rolling_step.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact::contact {
namespace {

using Eigen::VectorXd;

void project(const TangentialTask& task, int n, VectorXd& p) {
  VectorXd inside = VectorXd::Zero(2 * n);
  for (const int i : task.contact) {
    const double length = std::hypot(p[i], p[n + i]);
    const double scale = length > task.bound[i] ? task.bound[i] / length : 1.0;
    inside[i] = scale * p[i];
    inside[n + i] = scale * p[n + i];
  }
  p = std::move(inside);
}

/// min 1/2 p'A p - c'p over the friction discs: accelerated projected gradients, restarted when the
/// momentum points uphill (Nesterov 1983; O'Donoghue, Candes 2015).
void solve_shift(const TangentialSystem& system, const TangentialTask& task, const VectorXd& c, double norm,
                 double tolerance, VectorXd& p) {
  const int n = system.size();
  VectorXd y = p;
  double t = 1;
  for (int k = 0; k < 1000; ++k) {
    VectorXd next = y - (system.displacement(y) - c) / norm;
    project(task, n, next);
    const VectorXd change = next - p;
    const double moved = (next - y).cwiseAbs().maxCoeff();
    if ((y - next).dot(change) > 0) {
      t = 1;
      y = next;
    } else {
      const double t_next = 0.5 * (1 + std::sqrt(1 + 4 * t * t));
      y = next + (t - 1) / t_next * change;
      t = t_next;
    }
    p = next;
    if (moved <= tolerance * task.bound.maxCoeff())
      break;
  }
}

} // namespace

void roll_on(const TangentialSystem& system, const TangentialTask& task, const SolverOptions& options,
             int steps, TangentialState& state) {
  VectorXd v = VectorXd::LinSpaced(state.p.size(), 1.0, 1.5);
  double norm = 0;
  for (int k = 0; k < 20; ++k) {
    v.normalize();
    v = system.displacement(v);
    norm = v.norm();
  }
  norm *= 1.2;
  project(task, system.size(), state.p);
  VectorXd older = state.p;
  state.converged = false;
  state.solver = "rolling on";
  if (system.problem->motion != MotionKind::steady) {
    state.solver = "projected gradients";
    ++state.iterations;
    solve_shift(system, task, task.drive / system.rule.present[0], norm, 1e-12, state.p);
    state.slip = task.drive - system.step(state.p);
    state.violation = coulomb_violation(system, task, state.p, state.slip);
    state.converged = state.violation <= options.tolerance;
    return;
  }
  for (int k = 0; k < steps && !state.converged; ++k) {
    ++state.iterations;
    // S = r0 (c - A p); the old fields are those of one and two steps ago
    const VectorXd c = (task.drive - rolling_step[1] * system.displacement(state.p, 1) -
                        rolling_step[2] * system.displacement(older, 2)) /
                       rolling_step[0];
    older = state.p;
    solve_shift(system, task, c, norm, 1e-10, state.p);
    state.slip = task.drive - system.step(state.p);
    state.violation = coulomb_violation(system, task, state.p, state.slip);
    state.converged = state.violation <= options.tolerance;
  }
}

} // namespace bem_contact::contact
