#include "bem_contact/contact/tangential/newton.hpp"

#include "bem_contact/base/counted.hpp"
#include "bem_contact/contact/tangential/hardening.hpp"
#include "bem_contact/contact/tangential/newton_matrix.hpp"
#include "bem_contact/contact/tangential/row_sweeps.hpp"
#include "bem_contact/contact/tangential/settings.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace bem_contact::contact {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// 1. Precision of the tractions under a unit of creepage at a solution, from which its compliance follows: a
/// share of a stated error. Chosen.
constexpr double compliance_precision = 0.01;
/// Newton steps with creepages among the unknowns; then they are searched for. Chosen.
constexpr int most_forced_steps = 20;

class Newton {
public:
  Newton(const TangentialSystem& system, const TangentialTask& task, WorkBudget& work, const VectorXd& start,
         const PrescribedForces* forces = nullptr)
      : system_(system), work_(work), elements_(system, task), matrix_(system, elements_, work),
        forces_(forces), slips_(unit_slips()), drive_(elements_.gather(task.drive)),
        now_(at(elements_.gather(start))) {}

  /// Tells the state, whose fields are zero outside the contact, where the method is.
  void write(TangentialState& state) const {
    elements_.write(now_.p, state.p);
    elements_.write(now_.slip, state.slip);
  }

  /// One Newton step with line search. False if the matrix is singular. `enough`: no linear system need be
  /// solved more precisely.
  bool step(double enough, TangentialState& state);
  bool stalls() const { return failed_searches_ >= most_failed_searches; }
  /// What the tractions miss of the prescribed forces, N; and what the steps changed the creepages by. One
  /// value an unknown creepage.
  VectorXd missing() const { return missing(now_.p); }
  const VectorXd& creepages() const { return now_.creepages; }
  /// What the equations of all elements miss, as forces, N.
  double missing_in_elements() const {
    return system_.problem->element_area() * now_.linearisation.residual.lpNorm<1>();
  }
  /// Of each unknown creepage under a unit of its force, the others held.
  VectorXd compliances(TangentialState& state) const;

private:
  struct Point {
    VectorXd p, slip, creepages;
    Linearisation linearisation;
    double residual; ///< MPa; what forces miss counts as a traction on all elements
  };
  MatrixXd unit_slips() const;
  VectorXd missing(const VectorXd& p) const;
  Point at(VectorXd p) const { return at(std::move(p), VectorXd::Zero(slips_.cols())); }
  Point at(VectorXd p, VectorXd creepages) const {
    VectorXd slip;
    matrix_.step(p, slip);
    slip = drive_ + slips_ * creepages - slip;
    return point(std::move(p), std::move(slip), std::move(creepages));
  }
  Point point(VectorXd p, VectorXd slip, VectorXd creepages) const {
    Linearisation linearisation = elements_.layer ? linearise_hardening(elements_, system_.columns(), p, slip)
                                                  : linearise(elements_.stiffness, elements_.bound, p, slip);
    const double spread = system_.problem->element_area() * std::sqrt(double(elements_.contact.size()));
    const double residual = std::hypot(linearisation.residual.norm(), missing(p).norm() / spread);
    return {std::move(p), std::move(slip), std::move(creepages), std::move(linearisation), residual};
  }
  Border border() const;
  bool search(const BorderedSolution& step, double before);
  void help_worst_rows();

  const TangentialSystem& system_;
  WorkBudget& work_;
  ContactElements elements_;
  NewtonMatrix matrix_;
  const PrescribedForces* forces_; ///< null: none
  MatrixXd slips_;                 ///< of a unit of each unknown creepage, mm
  VectorXd drive_;
  Point now_;
  double last_ = 0; ///< residual before the former step; 0: there was none
  int failed_searches_ = 0;
};

MatrixXd Newton::unit_slips() const {
  MatrixXd slips = MatrixXd::Zero(elements_.unknowns(), forces_ ? forces_->components.size() : 0);
  for (Eigen::Index k = 0; k < slips.cols(); ++k)
    for (std::size_t a = 0; a < elements_.contact.size(); ++a) {
      const int component = forces_->components[k];
      slips(2 * a + component, k) =
          system_.rule.length * (component == component_x ? 1.0 : forces_->share[elements_.contact[a]]);
    }
  return slips;
}

VectorXd Newton::missing(const VectorXd& p) const {
  VectorXd out = slips_.transpose() * p * (-system_.problem->element_area() / system_.rule.length);
  for (Eigen::Index k = 0; k < out.size(); ++k)
    out[k] += forces_->force[forces_->components[k]];
  return out;
}

/// The creepages are further unknowns, and that the forces are met are further equations.
Border Newton::border() const {
  Border border;
  if (slips_.cols() == 0)
    return border;
  border.columns.resize(slips_.rows(), slips_.cols());
  for (std::size_t a = 0; a < elements_.contact.size(); ++a)
    border.columns.middleRows<2>(2 * a) =
        -elements_.stiffness[a] * now_.linearisation.projection[a] * slips_.middleRows<2>(2 * a);
  for (Eigen::Index k = 0; k < slips_.cols() && elements_.layer; ++k) {
    VectorXd z = slips_.col(k), column = border.columns.col(k);
    for (std::size_t a = 0; a < elements_.contact.size(); ++a)
      z.segment<2>(2 * a) *= elements_.stiffness[a];
    now_.linearisation.carried.add(z, -1.0, column);
    border.columns.col(k) = column;
  }
  border.rows = system_.problem->element_area() / system_.rule.length * slips_;
  border.sums = missing(now_.p);
  return border;
}

VectorXd Newton::compliances(TangentialState& state) const {
  const Border border = this->border();
  MatrixXd under_unit(elements_.unknowns(), slips_.cols());
  Linearisation load = now_.linearisation;
  for (Eigen::Index k = 0; k < slips_.cols(); ++k) {
    load.residual = border.columns.col(k);
    under_unit.col(k) = matrix_.newton_step(load, {}, compliance_precision, work_, state).x;
  }
  const Eigen::FullPivLU<MatrixXd> forces(border.rows.transpose() * under_unit);
  if (!forces.isInvertible())
    return VectorXd::Constant(slips_.cols(), std::numeric_limits<double>::quiet_NaN());
  return forces.inverse().diagonal();
}

/// Halves the step until the residual decreases. If it does not, takes the shortest step.
bool Newton::search(const BorderedSolution& step, double before) {
  VectorXd step_slip;
  matrix_.step(step.x, step_slip);
  step_slip = slips_ * step.y - step_slip;
  double length = 1;
  for (int halving = 0; halving < newton_halvings; ++halving, length *= 0.5) {
    Point there =
        point(now_.p + length * step.x, now_.slip + length * step_slip, now_.creepages + length * step.y);
    const bool decreased = there.residual < (1 - newton_decrease * length) * before;
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
  if (Point there = at(std::move(trial), now_.creepages); there.residual < now_.residual)
    now_ = std::move(there);
}

bool Newton::step(double enough, TangentialState& state) {
  // Linear systems are solved only as precisely as the states are known.
  const double before = now_.residual;
  const double ratio = last_ == 0 ? 1 : before / last_;
  const double known =
      std::min(newton_forcing * ratio * ratio, known_forcing * before / elements_.bound.norm());
  const double forcing =
      std::clamp(known, std::max<double>(finest_newton_forcing, enough), coarsest_newton_forcing);
  last_ = before;
  const BorderedSolution step = matrix_.newton_step(now_.linearisation, border(), forcing, work_, state);
  if (!step.x.allFinite() || !step.y.allFinite())
    return false;
  failed_searches_ += !search(step, before);
  if (now_.residual > slow_newton_step * before && !elements_.layer) // sweeps hold the bounds
    help_worst_rows();
  return true;
}

void clear(const TangentialSystem& system, TangentialState& state) {
  state.p.setZero(2 * system.size());
  state.slip.setZero(2 * system.size());
}

/// Tells the state where the method is, and how good that is.
void take_point(const Newton& method, const TangentialTask& task, TangentialState& state) {
  method.write(state);
  state.violation = coulomb_violation(task, state.p, state.slip);
}

} // namespace

void newton(const TangentialSystem& system, const TangentialTask& task, const SolverOptions& options,
            WorkBudget& work, TangentialState& state) {
  Newton method(system, task, work, state.p);
  clear(system, state);
  int steps = 0;
  for (bool possible = true; possible;) {
    take_point(method, task, state);
    state.converged = state.violation <= options.tolerance;
    if (state.converged || steps == options.max_tangential || method.stalls())
      break;
    ++state.iterations;
    ++steps;
    possible = method.step(
        std::min(coarsest_newton_forcing, newton_end_forcing * options.tolerance / state.violation), state);
  }
  if (!state.converged)
    state.remark += "Newton: no answer in " + counted(steps, "step", "steps") + "; ";
}

void add_creepage(const TangentialSystem& system, const VectorXd& share, const Eigen::Vector2d& creepage,
                  TangentialTask& task) {
  const int n = system.size();
  const Eigen::Vector2d slip = system.rule.length * creepage;
  for (VectorXd* field : {&task.rigid, &task.drive}) {
    field->head(n).array() += slip[0];
    field->tail(n) += slip[1] * share;
  }
}

std::optional<ForcedCreepage> newton_for_forces(const TangentialSystem& system,
                                                const PrescribedForces& forces, const SolverOptions& options,
                                                WorkBudget& work, TangentialTask& task,
                                                TangentialState& state) {
  const int n = system.size();
  if (state.p.size() != 2 * n)
    state.p = VectorXd::Zero(2 * n);
  state.remark.clear();
  const TangentialTask given = task;
  ForcedCreepage found{forces.start};
  const auto set_task = [&] {
    task = given;
    add_creepage(system, forces.share, found.creepage, task);
  };
  set_task();
  Newton method(system, task, work, state.p, &forces);
  clear(system, state);
  for (int steps = 0;; ++steps) {
    take_point(method, task, state);
    const double missing = method.missing().norm() / forces.tolerance;
    const double inexact = options.forces_alone ? method.missing_in_elements() / forces.tolerance
                                                : state.violation / options.tolerance;
    state.converged = std::max(inexact, missing) <= 1;
    if (state.converged) {
      const VectorXd compliances = method.compliances(state);
      for (std::size_t k = 0; k < forces.components.size(); ++k)
        found.compliance[forces.components[k]] = compliances[static_cast<Eigen::Index>(k)];
      return found;
    }
    if (steps == most_forced_steps || method.stalls())
      return std::nullopt;
    ++state.iterations;
    const double enough = std::min(coarsest_newton_forcing, newton_end_forcing / std::max(inexact, missing));
    if (!method.step(enough, state))
      return std::nullopt;
    found.creepage = forces.start;
    for (std::size_t k = 0; k < forces.components.size(); ++k)
      found.creepage[forces.components[k]] += method.creepages()[k];
    set_task();
  }
}

} // namespace bem_contact::contact
