#include "bem_contact/contact/tangential/solve_tangential.hpp"

#include "bem_contact/contact/operator/norm_bound.hpp"
#include "bem_contact/contact/tangential/element_sweeps.hpp"
#include "bem_contact/contact/tangential/newton.hpp"

#include <cmath>
#include <fmt/format.h>

namespace bem_contact::contact {

namespace {

using Eigen::VectorXd;

/// Steps of the projected gradients for one rolling step or shift. Chosen.
constexpr int most_gradient_steps = 1000;
/// 1. Their precision relative to the largest bound, for a shift and for each of many rolling steps. Chosen.
constexpr double shift_precision = 1e-12;
constexpr double rolling_precision = 1e-10;
/// Lengths of the grid to roll on. Chosen: transients decay within a few lengths of the contact.
constexpr int rolling_on_lengths = 6;

/// Into the friction discs; zero outside the contact.
VectorXd project(const TangentialTask& task, const VectorXd& p) {
  const Eigen::Index n = task.bound.size();
  VectorXd inside = VectorXd::Zero(2 * n);
  for (const int i : task.contact) {
    const double length = std::hypot(p[i], p[n + i]);
    const double scale = length > task.bound[i] ? task.bound[i] / length : 1.0;
    inside[i] = scale * p[i];
    inside[n + i] = scale * p[n + i];
  }
  return inside;
}

/// min 1/2 p'A p - c'p over the friction discs.
class ShiftProblem {
public:
  ShiftProblem(const TangentialSystem& system, const TangentialTask& task, WorkBudget& work)
      : system_(system), task_(task), work_(work),
        norm_(
            norm_bound(2 * system.size(), [&](const VectorXd& v) { return system.displacement(v, work); })) {}

  /// Accelerated projected gradients from p, restarted when the momentum points uphill (Nesterov 1983;
  /// O'Donoghue, Candes 2015).
  void solve(const VectorXd& c, double tolerance, VectorXd& p) const {
    VectorXd y = p;
    double t = 1;
    for (int k = 0; k < most_gradient_steps; ++k) {
      const VectorXd next = project(task_, y - (system_.displacement(y, work_) - c) / norm_);
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
      if (moved <= tolerance * task_.bound.maxCoeff())
        break;
    }
  }

private:
  const TangentialSystem& system_;
  const TangentialTask& task_;
  WorkBudget& work_;
  double norm_;
};

/// Rolls on from the present tractions, by `steps` columns with p_n held: each rolling step is a convex
/// problem, min 1/2 p'A p - c'p over the friction discs. A transient step or a shift is one such problem.
void roll_on(const TangentialSystem& system, const TangentialTask& task, const SolverOptions& options,
             int steps, WorkBudget& work, TangentialState& state) {
  const ShiftProblem shift(system, task, work);
  state.p = project(task, state.p);
  state.converged = false;
  if (system.problem->motion != MotionKind::steady) {
    state.solver = "projected gradients";
    ++state.iterations;
    shift.solve(task.drive / system.rule.present[0], shift_precision, state.p);
    judge(system, task, options.tolerance, work, state);
    return;
  }
  state.solver = "rolling on";
  VectorXd older = state.p;
  for (int k = 0; k < steps && !state.converged; ++k) {
    ++state.iterations;
    // S = rolling_step[0] (c - A p); the old fields are those of one and two rolling steps ago
    const VectorXd c = (task.drive - rolling_step[1] * system.displacement(state.p, work, 1) -
                        rolling_step[2] * system.displacement(older, work, 2)) /
                       rolling_step[0];
    older = state.p;
    shift.solve(c, rolling_precision, state.p);
    judge(system, task, options.tolerance, work, state);
  }
}

/// Newton's method for a layer that hardens or softens, from the solution of one that does neither.
void start_from_held_limit(const TangentialSystem& system, const TangentialTask& task,
                           const SolverOptions& options, WorkBudget& work, TangentialState& state) {
  const YieldLimit& limit = task.layer->limit();
  TangentialTask held = task;
  held.layer = nullptr;
  if (task.limits.size() > 0)
    held.bound = task.bound.cwiseMin(task.limits);
  else
    held.bound = task.bound.cwiseMin(limit.shear);
  state.p.setZero();
  newton(system, held, options, work, state);
  newton(system, task, options, work, state);
  if (!state.converged && limit.hardening < 0)
    state.remark += "the layer softens, so that there may be more than one solution: let it soften less; ";
}

} // namespace

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
  if (task.layer) // the fall-backs hold the bounds
    return start_from_held_limit(system, task, options, work, state);

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
