#include "bem_contact/contact/tangential/newton.hpp"

#include "bem_contact/contact/settings.hpp"
#include "bem_contact/contact/tangential/newton_matrix.hpp"
#include "bem_contact/contact/tangential/row_sweeps.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace bem_contact::contact {
namespace {

using Eigen::VectorXd;

class Newton {
public:
  Newton(const TangentialSystem& system, const TangentialTask& task, WorkBudget& work, const VectorXd& start)
      : system_(system), work_(work), elements_(system, task), matrix_(system, elements_, work),
        drive_(elements_.gather(task.drive)), now_(at(elements_.gather(start))) {}

  VectorXd tractions() const { return elements_.scatter(now_.p); }
  VectorXd slip() const { return elements_.scatter(now_.slip); }

  /// One Newton step with line search. False if the matrix is singular. `enough`: no linear system need be
  /// solved more precisely.
  bool step(double enough, TangentialState& state);
  bool stalls() const { return failed_searches_ >= most_failed_searches; }

private:
  struct Point {
    VectorXd p, slip;
    Linearisation linearisation;
    double residual() const { return linearisation.residual.norm(); }
  };
  Point at(VectorXd p) const {
    VectorXd slip;
    matrix_.step(p, slip);
    slip = drive_ - slip;
    return point(std::move(p), std::move(slip));
  }
  Point point(VectorXd p, VectorXd slip) const {
    Linearisation linearisation = linearise(elements_.stiffness, elements_.bound, p, slip);
    return {std::move(p), std::move(slip), std::move(linearisation)};
  }
  bool search(const VectorXd& step, double before);
  void help_worst_rows();

  const TangentialSystem& system_;
  WorkBudget& work_;
  ContactElements elements_;
  NewtonMatrix matrix_;
  VectorXd drive_;
  Point now_;
  double last_ = 0; ///< residual before the former step; 0: there was none
  int failed_searches_ = 0;
};

/// Halves the step until the residual decreases. If it does not, takes the shortest step.
bool Newton::search(const VectorXd& step, double before) {
  VectorXd step_slip;
  matrix_.step(step, step_slip);
  step_slip = -step_slip;
  double length = 1;
  for (int halving = 0; halving < newton_halvings; ++halving, length *= 0.5) {
    Point there = point(now_.p + length * step, now_.slip + length * step_slip);
    const bool decreased = there.residual() < (1 - newton_decrease * length) * before;
    if (decreased || halving == newton_halvings - 1) {
      now_ = std::move(there);
      return decreased;
    }
  }
  return false;
}

void Newton::help_worst_rows() {
  VectorXd trial = now_.p;
  if (!sweep_rows(system_, elements_, now_.slip, now_.linearisation, work_, trial))
    return;
  if (Point there = at(std::move(trial)); there.residual() < now_.residual())
    now_ = std::move(there);
}

bool Newton::step(double enough, TangentialState& state) {
  // Linear systems are solved only as precisely as the states are known: quadratic convergence shows that
  // they are.
  const double before = now_.residual();
  const double ratio = last_ == 0 ? 1 : before / last_;
  const double forcing = std::clamp(newton_forcing * ratio * ratio, std::max(finest_newton_forcing, enough),
                                    coarsest_newton_forcing);
  last_ = before;
  const VectorXd step = matrix_.newton_step(now_.linearisation, forcing, work_, state);
  if (!step.allFinite())
    return false;
  failed_searches_ += !search(step, before);
  if (now_.residual() > slow_newton_step * before)
    help_worst_rows();
  return true;
}

} // namespace

void newton(const TangentialSystem& system, const TangentialTask& task, const SolverOptions& options,
            WorkBudget& work, TangentialState& state) {
  Newton method(system, task, work, state.p);
  int steps = 0;
  for (bool possible = true; possible;) {
    state.p = method.tractions();
    state.slip = method.slip();
    state.violation = coulomb_violation(task, state.p, state.slip);
    state.converged = state.violation <= options.tolerance;
    if (state.converged || steps == options.max_tangential || method.stalls())
      break;
    ++state.iterations;
    ++steps;
    possible = method.step(
        std::min(coarsest_newton_forcing, newton_end_forcing * options.tolerance / state.violation), state);
  }
  if (!state.converged)
    state.remark += "Newton: no answer in " + std::to_string(steps) + " steps; ";
}

} // namespace bem_contact::contact
