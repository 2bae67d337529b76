#include "bem_contact/contact/coupled/outer_iteration.hpp"

#include "bem_contact/contact/coupled/settings.hpp"
#include "bem_contact/contact/coupled/varying_friction.hpp"
#include "bem_contact/contact/eigen_fields.hpp"
#include "bem_contact/contact/normal/solve_normal.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace bem_contact::contact {
namespace {

using Eigen::VectorXd;

/// Outer iterations. Each of these finds anew which elements slip at the kinetic coefficient; later ones add
/// to those of the former one. With every element that starts or ends to slip the forces jump, and where the
/// prescribed force lies within a jump no iteration settles. Contacts that settle take 8 at most (measured on
/// 34).
constexpr int most_fresh_slips = 10;
/// 1. Slip below this share of the largest pressure times the largest self number is rounding. In a shift or
/// a transient rolling step the limit is shift_slip_floor times as high. There slip is not the difference of
/// displacements one element apart, which would have less rounding.
constexpr double slip_rounding = 1e-12;
constexpr double shift_slip_floor = 1e3;

TangentialTask make_task(const ContactProblem& problem, const Shear& shear, const VectorXd& pn,
                         double floor) {
  TangentialTask task{pn, shear.rigid, shear.rigid + shear.former, {}, floor};
  for (int i = 0; i < pn.size(); ++i) {
    task.bound[i] *= problem.friction_of(i / problem.grid.mx);
    if (pn[i] > 0)
      task.contact.push_back(i);
  }
  if (shear.coupling && problem.motion == MotionKind::steady) {
    task.drive -= step_of_pressure(shear, pn);
  } else if (shear.coupling) {
    VectorXd step(2 * pn.size());
    shear.coupling->shear_from_normal.apply(view(pn), view(step));
    task.drive -= shear.system.rule.present[0] * step;
  }
  // If everything sticks without rigid slip, slip is compared with what there would be without tractions.
  if (problem.motion != MotionKind::steady) {
    task.slip_floor *= shift_slip_floor;
    for (const int i : task.contact)
      task.slip_floor = std::max(task.slip_floor, std::hypot(task.drive[i], task.drive[pn.size() + i]));
  }
  return task;
}

/// Shear tractions to start from: they keep their ratio to the pressure, which has changed.
void follow(const VectorXd& before, const VectorXd& now, VectorXd& shear) {
  const Eigen::Index n = now.size();
  for (Eigen::Index i = 0; i < n; ++i)
    if (before[i] > 0) {
      const double factor = std::min(now[i] / before[i], largest_shear_growth);
      shear[i] *= factor;
      shear[n + i] *= factor;
    }
}

} // namespace

Shear::Shear(const ContactProblem& problem, ContactOperators& operators, WorkBudget& work)
    : system(problem, operators.tangential), rigid(2 * problem.grid.size()),
      coupling(operators.coupling(problem, work)) {
  const int n = problem.grid.size();
  for (int i = 0; i < n; ++i) {
    rigid[i] = problem.slip_x[i] * system.rule.length;
    rigid[n + i] = problem.slip_s[i] * system.rule.length;
  }
  former = former_slip(problem, *this, work);
}

CoupledSystem::CoupledSystem(const ContactProblem& the_problem, ContactOperators& operators,
                             double negligible, WorkBudget& work)
    : problem(the_problem), normal(the_problem, operators.normal), gap(vector_of(the_problem.gap)),
      sine(the_problem.grid.size()) {
  for (int is = 0; is < problem.grid.ms; ++is)
    sine.segment(is * problem.grid.mx, problem.grid.mx).setConstant(std::sin(problem.rows[is].delta));
  if (!problem.has_friction())
    return;
  shear.emplace(problem, operators, work);
  const double friction = problem.largest_friction(),
               steepest = std::max(sine.cwiseAbs().maxCoeff(), std::abs(problem.rise)),
               flattest = normal.cosine.minCoeff();
  by_numbers = shear->coupling && shear_moves_normal(problem.numbers, negligible / friction);
  if (problem.load != LoadKind::force)
    return;
  inclined = steepest > coupling_rounding && friction * steepest > negligible * flattest;
  by_force = coupled() && problem.force > 0;
}

double CoupledSystem::shear_force(const VectorXd& shear_tractions) const {
  const Eigen::Index n = sine.size();
  return (sine.dot(shear_tractions.tail(n)) + problem.rise * shear_tractions.head(n).sum()) *
         problem.element_area();
}

VectorXd former_slip(const ContactProblem& problem, const Shear& shear, WorkBudget& work) {
  const int n = problem.grid.size();
  const SlipStep& rule = shear.system.rule;
  VectorXd sum = VectorXd::Zero(2 * n), u(2 * n);
  for (std::size_t k = 1; k <= std::min<std::size_t>(problem.previous.size(), 2); ++k) {
    const Tractions& former = problem.previous[k - 1];
    const int columns = static_cast<int>(k) * rule.columns;
    sum -= rule.former[k] * shear.system.displacement(joined(former.px, former.ps), work, columns);
    if (shear.coupling) {
      shear.coupling->shear_from_normal.apply(former.pn, view(u), columns);
      sum -= rule.former[k] * u;
    }
  }
  return sum;
}

void iterate_once(const CoupledSystem& system, const SolverOptions& options, const VectorXd& v,
                  const NormalLoad& load, WorkBudget& work, Solution& solution) {
  ++solution.outer_iterations;
  solution.normal.remark.clear();
  const VectorXd before = solution.normal.p;
  solve_normal(system.normal, system.gap + v, load, options, work, solution.normal);
  if (!system.shear)
    return;
  if (before.size() == solution.normal.p.size())
    follow(before, solution.normal.p, solution.shear.p);
  solve_shear(system, options, work, solution);
}

void solve_shear(const CoupledSystem& system, const SolverOptions& options, WorkBudget& work,
                 Solution& solution) {
  if (solution.outer_iterations > most_fresh_slips)
    solution.shear.held = solution.shear.slipped;
  const double floor = slip_rounding * solution.normal.p.maxCoeff() * system.normal.self;
  solution.task = make_task(system.problem, *system.shear, solution.normal.p, floor);
  solve_varying_friction(system.shear->system, options, work, solution.task, solution.shear,
                         solution.creepage);
}

VectorXd normal_displacement(const Shear& shear, const VectorXd& pt) {
  VectorXd u = VectorXd::Zero(pt.size() / 2);
  if (shear.coupling)
    shear.coupling->normal_from_shear.apply(view(pt), view(u));
  return u;
}

VectorXd step_of_pressure(const Shear& shear, const VectorXd& pn) {
  VectorXd step = VectorXd::Zero(2 * pn.size());
  if (shear.coupling)
    shear.coupling->shear_from_normal.apply_step(view(pn), view(step));
  return step;
}

} // namespace bem_contact::contact
