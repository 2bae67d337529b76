#include "bem_contact/contact/coupled/outer_iteration.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace bem_contact::contact {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

std::span<const double> view(const VectorXd& v) {
  return {v.data(), static_cast<std::size_t>(v.size())};
}
std::span<double> view(VectorXd& v) {
  return {v.data(), static_cast<std::size_t>(v.size())};
}

TangentialTask make_task(const ContactProblem& problem, const Shear& shear, const VectorXd& pn,
                         double floor) {
  TangentialTask task{pn, shear.rigid, shear.rigid + shear.former, {}, floor};
  for (int i = 0; i < pn.size(); ++i) {
    task.bound[i] *= problem.friction_of(i / problem.grid.mx);
    if (pn[i] > 0)
      task.contact.push_back(i);
  }
  if (shear.shear_from_normal) {
    VectorXd step(2 * pn.size());
    if (problem.motion == MotionKind::steady)
      shear.shear_from_normal->apply_step(view(pn), view(step));
    else {
      shear.shear_from_normal->apply(view(pn), view(step));
      step *= shear.system.rule.present[0];
    }
    task.drive -= step;
  }
  // where all sticks without rigid slip there is no slip to compare with but what tractions would cause
  if (problem.motion != MotionKind::steady) {
    task.slip_floor *= 1e3;
    for (const int i : task.contact)
      task.slip_floor = std::max(task.slip_floor, std::hypot(task.drive[i], task.drive[pn.size() + i]));
  }
  return task;
}

/// Shear keeps its share of the pressure, which has changed: where to start from.
void follow(const VectorXd& before, const VectorXd& now, VectorXd& shear) {
  const Eigen::Index n = now.size();
  for (Eigen::Index i = 0; i < n; ++i)
    if (before[i] > 0) {
      const double factor = std::min(now[i] / before[i], 10.0);
      shear[i] *= factor;
      shear[n + i] *= factor;
    }
}

} // namespace

VectorXd former_slip(const ContactProblem& problem, const Shear& shear) {
  const int n = problem.grid.size();
  const SlipStep& rule = shear.system.rule;
  VectorXd sum = VectorXd::Zero(2 * n), pt(2 * n), u(2 * n);
  for (std::size_t k = 1; k <= std::min<std::size_t>(problem.previous.size(), 2); ++k) {
    const Tractions& former = problem.previous[k - 1];
    const int columns = static_cast<int>(k) * rule.columns;
    pt << Eigen::Map<const VectorXd>(former.px.data(), n), Eigen::Map<const VectorXd>(former.ps.data(), n);
    sum -= rule.former[k] * shear.system.displacement(pt, columns);
    if (shear.shear_from_normal) {
      shear.shear_from_normal->apply(former.pn, view(u), columns);
      sum -= rule.former[k] * u;
    }
  }
  return sum;
}

void turn_once(const ContactProblem& problem, const SolverOptions& options, const NormalSystem& system,
               const Shear* shear, const VectorXd& gap, const VectorXd& v, const NormalLoad& load,
               Solution& solution) {
  ++solution.outer_iterations;
  solution.normal.remark.clear();
  const VectorXd before = solution.normal.p;
  solve_normal(system, gap + v, load, options, solution.normal);
  if (!shear)
    return;
  if (before.size() == solution.normal.p.size())
    follow(before, solution.normal.p, solution.shear.p);
  solution.task =
      make_task(problem, *shear, solution.normal.p, 1e-12 * solution.normal.p.maxCoeff() * system.self);
  solve_friction(shear->system, options, solution.task, solution.shear, solution.creepage);
}

VectorXd normal_displacement(const Shear& shear, const Solution& solution) {
  VectorXd u = VectorXd::Zero(solution.shear.p.size() / 2);
  if (shear.normal_from_shear)
    shear.normal_from_shear->apply(view(solution.shear.p), view(u));
  return u;
}

VectorXd Anderson::next(const VectorXd& v, const VectorXd& residual) {
  if (!best_ || residual.norm() < *best_)
    best_ = residual.norm();
  else if (residual.norm() > 5 * *best_) { // leave the memory behind, and walk slowly
    history_.clear();
    return v + 0.3 * residual;
  }
  history_.push_back({v, residual});
  if (history_.size() > 5)
    history_.pop_front();
  const Eigen::Index columns = static_cast<Eigen::Index>(history_.size()) - 1;
  if (columns == 0)
    return v + residual;
  MatrixXd dv(v.size(), columns), dr(v.size(), columns);
  for (Eigen::Index k = 0; k < columns; ++k) {
    dv.col(k) = history_[k + 1].v - history_[k].v;
    dr.col(k) = history_[k + 1].residual - history_[k].residual;
  }
  const VectorXd weights = dr.colPivHouseholderQr().solve(residual);
  return v + residual - (dv + dr) * weights;
}

} // namespace bem_contact::contact
