#include "bem_contact/contact/coupled/varying_friction.hpp"

#include "bem_contact/contact/coupled/anderson.hpp"
#include "bem_contact/contact/flash_temperature.hpp"
#include "bem_contact/contact/friction_memory.hpp"
#include "bem_contact/contact/tangential/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace bem_contact::contact {
namespace {

using Eigen::VectorXd;

/// Most iterations between mu and slip. A locomotive at 10 m/s (theory/contact.md, section 4) takes 13 Newton
/// steps in place of 4 where mu falls over 1250 mm/s, 80 over 10 mm/s, and may not settle over 5 mm/s and
/// less.
constexpr int most_friction_changes = 100;
/// 1. Anderson's method takes no mu below this share of mu(0). Chosen: real laws stay above a tenth.
constexpr double least_friction_factor = 1e-3;

/// mu over mu(0) at a slip velocity; `slip` in mm a step.
double factor_of_slip(const TangentialSystem& system, int element, double slip) {
  const ContactProblem& problem = *system.problem;
  return problem.falling_factor(element / problem.grid.mx, slip / system.rule.length * problem.speed);
}

double length_at(const VectorXd& v, Eigen::Index i) {
  return std::hypot(v[i], v[v.size() / 2 + i]);
}

/// Of state.factor: a second component for a layer that softens by heat.
Eigen::Index components(const ContactProblem& problem) {
  return problem.layer_softens_by_heat() ? 2 : 1;
}

/// With all sliding: a layer that softens by heat is as hot as its table goes.
VectorXd factors_of_sliding(const TangentialSystem& system, const TangentialTask& task) {
  const ContactProblem& problem = *system.problem;
  const Eigen::Index n = system.size();
  VectorXd factor = VectorXd::Ones(components(problem) * n);
  for (const int i : task.contact)
    factor[i] = factor_of_slip(system, i, length_at(task.rigid, i));
  if (problem.layer_softens_by_heat())
    factor.tail(n).setConstant(problem.yield->least() / problem.yield->shear);
  return factor;
}

/// mu over mu(0), and tau_0 over its largest, at the temperature that this solution's friction makes; 1
/// everywhere if it does not matter.
VectorXd factors_of_heat(const TangentialSystem& system, const TangentialTask& task,
                         const TangentialState& state) {
  const ContactProblem& problem = *system.problem;
  const int n = system.size();
  VectorXd factor = VectorXd::Ones(components(problem) * n);
  if (!problem.heat_acts())
    return factor;
  std::vector<double> heat(n, 0.0);
  std::vector<char> in_contact(n, 0);
  for (const int i : task.contact) {
    heat[i] = (state.p[i] * state.slip[i] + state.p[n + i] * state.slip[n + i]) / system.rule.length *
              problem.speed;
    in_contact[i] = 1;
  }
  const SurfaceTemperatures at =
      flash_temperatures(problem.grid, *problem.heating, problem.speed, heat, in_contact);
  for (const int i : task.contact) {
    if (problem.friction_falls_with_heat())
      factor[i] = problem.heating->friction->factor(at.mean(i));
    if (problem.layer_softens_by_heat())
      factor[n + i] = problem.yield->at(at.mean(i)) / problem.yield->shear;
  }
  return factor;
}

/// tau_0 of an element, MPa
double limit_of(const ContactProblem& problem, const TangentialTask& task, int element) {
  return task.limits.size() > 0 ? task.limits[element] : problem.yield->shear;
}

/// A layer that does not harden bears the same however far it has yielded.
void limit_by_layer(const TangentialSystem& system, TangentialTask& task) {
  const ContactProblem& problem = *system.problem;
  if (system.hardening)
    task.layer = system.hardening->may_yield(task.bound.maxCoeff()) ? &*system.hardening : nullptr;
  else if (problem.yield)
    for (const int i : task.contact)
      task.bound[i] = std::min(task.bound[i], limit_of(problem, task, i));
}

/// What bounds shear under state.factor, from what `given` has without.
TangentialTask bounded_by(const TangentialSystem& system, const TangentialTask& given,
                          const TangentialState& state) {
  TangentialTask task = given;
  const Eigen::Index n = system.size();
  task.bound.array() *= state.factor.head(n).array();
  if (system.problem->layer_softens_by_heat())
    task.limits = system.problem->yield->shear * state.factor.tail(n);
  limit_by_layer(system, task);
  return task;
}

/// Sets state.by_slip where friction remembers the slip ahead.
void remember(const TangentialSystem& system, const TangentialTask& task, TangentialState& state) {
  std::vector<double> velocity(system.size(), 0.0);
  std::vector<char> in_contact(system.size(), 0);
  for (const int i : task.contact) {
    velocity[i] = length_at(state.slip, i) / system.rule.length * system.problem->speed;
    in_contact[i] = 1;
  }
  const std::vector<double> factors = remembered_factors(*system.problem, velocity, in_contact);
  for (const int i : task.contact)
    state.by_slip[i] = factors[i];
}

/// Sets state.by_slip where the surfaces slip. What slips within a layer that yields is no sliding.
void learn_slip(const TangentialSystem& system, const TangentialTask& task, TangentialState& state) {
  if (system.problem->memory)
    return remember(system, task, state);
  const double scale = largest_slip(task.rigid, task.contact, state.slip, task.slip_floor);
  for (const int i : task.contact)
    if (const double slip = length_at(state.slip, i);
        slip > at_the_bound * scale && length_at(state.p, i) > (1 - at_the_bound) * task.bound[i])
      state.by_slip[i] = system.problem->yield && task.bound[i] >= limit_of(*system.problem, task, i)
                             ? 1.0
                             : factor_of_slip(system, i, slip);
}

/// The largest change of a bound, over the largest bound: of a layer that softens by heat the hottest one.
double largest_change(const ContactProblem& problem, const TangentialTask& given, const VectorXd& change) {
  double largest = 0, scale = given.bound.maxCoeff();
  if (problem.layer_softens_by_heat())
    scale = std::min(scale, problem.yield->least());
  const Eigen::Index n = given.bound.size();
  for (const int i : given.contact) {
    largest = std::max(largest, std::abs(change[i]) * given.bound[i]);
    if (problem.layer_softens_by_heat())
      largest = std::max(largest, std::abs(change[n + i]) * problem.yield->shear);
  }
  return largest / scale;
}

} // namespace

void solve_varying_friction(const TangentialSystem& system, const SolverOptions& options, WorkBudget& work,
                            TangentialTask& task, TangentialState& state, FoundCreepage& creepage) {
  const ContactProblem& problem = *system.problem;
  if (!problem.bounds_vary() || task.contact.empty()) {
    limit_by_layer(system, task);
    solve_friction(system, options, work, task, state, creepage);
    task.bound = bounds_of(task, state.p, state.slip);
    return;
  }
  const TangentialTask given = task;
  if (state.factor.size() == 0) {
    state.factor = options.from_sliding ? factors_of_sliding(system, given)
                                        : VectorXd::Ones(components(problem) * system.size());
    state.by_slip = state.factor.head(system.size());
  }
  std::optional<Anderson> anderson(std::in_place);
  VectorXd plain; // the step without acceleration
  double change = 0;
  for (int k = 0; k < most_friction_changes; ++k) {
    task = bounded_by(system, given, state);
    solve_friction(system, options, work, task, state, creepage);
    if (creepage.beyond && plain.size() > 0 && state.factor != plain) { // the acceleration went too far
      state.factor = plain;
      anderson.emplace();
      continue;
    }
    if (!state.converged || !creepage.reached)
      return;
    learn_slip(system, task, state);
    plain = factors_of_heat(system, task, state);
    plain.head(system.size()).array() *= state.by_slip.array();
    const VectorXd residual = plain - state.factor;
    change = largest_change(problem, given, residual);
    if (change <= options.tolerance) {
      task.bound = bounds_of(task, state.p, state.slip);
      return;
    }
    state.factor = anderson->next(state.factor, residual).cwiseMax(least_friction_factor).cwiseMin(1.0);
  }
  state.converged = false;
  state.remark +=
      fmt::format("{} did not settle in {} iterations (it still changes by {:.1e} of the largest "
                  "mu p_n{}): let it fall less steeply, or give a smaller speed or larger "
                  "elements; ",
                  problem.layer_softens_by_heat() ? "a layer that softens by heat"
                                                  : "friction that falls with slip velocity or temperature",
                  int(most_friction_changes), change,
                  problem.layer_softens_by_heat() ? "; there may be more than one solution" : "");
}

} // namespace bem_contact::contact
