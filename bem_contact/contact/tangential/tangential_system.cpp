#include "bem_contact/contact/tangential/tangential_system.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact::contact {

using Eigen::VectorXd;

TangentialSystem::TangentialSystem(const ContactProblem& the_problem, TangentialOperators& operators)
    : problem(&the_problem), rule(slip_step(the_problem)), stiffness(the_problem.grid.size()),
      operators_(&operators) {
  const std::vector<double> of_rows = element_stiffness(*problem);
  for (int is = 0; is < problem->grid.ms; ++is)
    stiffness.segment(is * columns(), columns()).setConstant(of_rows[is]);
  if (problem->yield && problem->yield->hardening != 0)
    hardening.emplace(*problem);
}

VectorXd TangentialSystem::displacement(const VectorXd& p, WorkBudget& work, int columns) const {
  work.spend(product_work(problem->grid.ms) * size());
  VectorXd u(p.size());
  operators_->whole(*problem, work)
      .apply({p.data(), static_cast<std::size_t>(p.size())}, {u.data(), static_cast<std::size_t>(u.size())},
             columns);
  return u;
}

VectorXd TangentialSystem::step(const VectorXd& p, WorkBudget& work) const {
  if (problem->motion != MotionKind::steady)
    return rule.present[0] * displacement(p, work);
  work.spend(product_work(problem->grid.ms) * size());
  VectorXd u(p.size());
  operators_->whole(*problem, work)
      .apply_step({p.data(), static_cast<std::size_t>(p.size())},
                  {u.data(), static_cast<std::size_t>(u.size())});
  return u;
}

const StepNumbers& TangentialSystem::step_numbers() const {
  return operators_->use(rule.present).step_numbers(*problem);
}

double TangentialSystem::product_work(int rows) const {
  return bem_contact::product_work(problem->numbers.translational, rows);
}

TangentialOperators::BoxWithScratch TangentialSystem::box_around(const std::vector<int>& contact,
                                                                 WorkBudget& work) const {
  return operators_->use(rule.present).box_around(contact, *problem, work);
}

TangentialOperators::FewElements& TangentialSystem::few_elements(const std::vector<int>& contact) const {
  return operators_->use(rule.present).few_elements(contact, *problem);
}

namespace {

/// std::hypot takes five times as long. It is needed where the square is no normal number: slips that cancel
/// to almost nothing, and trial creepages that run away.
double length(double x, double s) {
  const double square = x * x + s * s;
  return std::isnormal(square) ? std::sqrt(square) : std::hypot(x, s);
}

} // namespace

double largest_slip(const VectorXd& rigid, const std::vector<int>& contact, const VectorXd& slip,
                    double floor) {
  const Eigen::Index n = rigid.size() / 2;
  double largest = floor;
  for (const int i : contact)
    largest = std::max(
        {largest, length(rigid[i], rigid[n + i]), length(slip[i] - rigid[i], slip[n + i] - rigid[n + i])});
  return largest;
}

std::vector<LayerAnswer> layer_answers(const TangentialTask& task, const VectorXd& p, const VectorXd& slip) {
  const std::size_t n = task.bound.size();
  return task.layer->answers({.px = {p.data(), n},
                              .ps = {p.data() + n, n},
                              .slip_x = {slip.data(), n},
                              .slip_s = {slip.data() + n, n},
                              .friction = {task.bound.data(), n},
                              .limits = {task.limits.data(), std::size_t(task.limits.size())}});
}

VectorXd bounds_of(const TangentialTask& task, const VectorXd& p, const VectorXd& slip) {
  if (!task.layer)
    return task.bound;
  VectorXd out = VectorXd::Zero(task.bound.size());
  const std::vector<LayerAnswer> answers = layer_answers(task, p, slip);
  for (const int i : task.contact)
    out[i] = answers[i].bound;
  return out;
}

double coulomb_violation(const TangentialTask& task, const VectorXd& p, const VectorXd& slip) {
  const Eigen::Index n = task.bound.size();
  const VectorXd bound = bounds_of(task, p, slip);
  const double slip_scale = largest_slip(task.rigid, task.contact, slip, task.slip_floor);
  const double largest_bound = traction_scale(bound.maxCoeff(), task.bound.maxCoeff());
  double worst = 0;
  for (const int i : task.contact) {
    const double s = length(slip[i], slip[n + i]);
    const double cone = length(p[i], p[n + i]) - bound[i];
    worst = std::max(worst, cone / largest_bound);
    if (s <= 0)
      continue;
    const double direction = length(p[i] - bound[i] * slip[i] / s, p[n + i] - bound[i] * slip[n + i] / s);
    worst = std::max(worst, std::min(s / slip_scale, direction / largest_bound));
  }
  return worst;
}

void judge(const TangentialSystem& system, const TangentialTask& task, double tolerance, WorkBudget& work,
           TangentialState& state) {
  state.slip = task.drive - system.step(state.p, work);
  state.violation = coulomb_violation(task, state.p, state.slip);
  state.converged = state.violation <= tolerance;
}

} // namespace bem_contact::contact
