#include "bem_contact/contact/coupled/solve_coupled.hpp"

#include "bem_contact/base/counted.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/contact/coupled/anderson.hpp"
#include "bem_contact/contact/coupled/force_balance.hpp"
#include "bem_contact/contact/coupled/outer_iteration.hpp"
#include "bem_contact/contact/coupled/settings.hpp"
#include "bem_contact/contact/coupled/settling_rate.hpp"
#include "bem_contact/contact/coupled/start.hpp"
#include "bem_contact/contact/coupled/tolerance_schedule.hpp"
#include "bem_contact/contact/eigen_fields.hpp"
#include "bem_contact/contact/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace bem_contact::contact {
namespace {

using Eigen::VectorXd;

/// Pressure forces that are tried one by one where the accelerated iteration did not settle. Chosen.
constexpr int most_force_trials = 60;

/// Between the parts of a remark.
constexpr std::string_view separator = "; ";

void set_distance(const CoupledSystem& system, Solution& solution) {
  solution.distance =
      system.gap + solution.from_shear - solution.normal.approach * system.normal.cosine + solution.normal.u;
}

/// The outer iterations of one problem. The unknown v holds the normal displacement (A p_t)_n of each element
/// and, as its last entry, the vertical force of the pressure in units of length, so that both can be
/// accelerated together. One outer iteration gives G(v); the solution has v = G(v).
class OuterLoop {
public:
  OuterLoop(const CoupledSystem& system, const SolverOptions& options, WorkBudget& work, Solution& solution);

  /// True if the iterations settled, if one is enough, or if `look` (may be null) ends them. Sets rate and
  /// unbalanced of the solution.
  bool run(const RoughLook* look);

private:
  void iterate_under_held_pressure();
  VectorXd image(); ///< G(v) after an outer iteration; sets the last entry of v
  double relative_change(const VectorXd& residual) const;
  void tighten(double change); ///< the tolerance of the next outer iteration
  void advance(const VectorXd& residual);

  const CoupledSystem& system_;
  const SolverOptions& options_;
  WorkBudget& work_;
  Solution& solution_;
  const Eigen::Index n_; ///< elements
  ToleranceSchedule tolerance_;
  ForceBalance balance_;
  Anderson anderson_;
  VectorXd v_;
  double force_to_length_ = 0; ///< mm/N; 0: not known before the first outer iteration
};

OuterLoop::OuterLoop(const CoupledSystem& system, const SolverOptions& options, WorkBudget& work,
                     Solution& solution)
    : system_(system), options_(options), work_(work), solution_(solution), n_(system.gap.size()),
      tolerance_(options.tolerance, system.coupled() && !options.near), balance_(system.problem.force),
      v_(VectorXd::Zero(n_ + 1)) {
  if (system.by_force &&
      solution.normal.p.size() == n_) { // guess the share that shear carries from the start
    const double pressed = system.normal.cosine.dot(solution.normal.p) * system.problem.element_area();
    solution.pressed = balance_.start(pressed, pressed + system.shear_force(solution.shear.p));
  }
  if (system.by_numbers && solution.shear.p.any())
    v_.head(n_) = normal_displacement(*system.shear, solution.shear.p);
}

/// The pressure of options.near solves the normal problem under v_ as it is.
void OuterLoop::iterate_under_held_pressure() {
  NormalState& normal = solution_.normal;
  normal.u = system_.normal.apply(normal.p, work_);
  normal.converged = true;
  const Tractions& guess = options_.near->shear_guess;
  solution_.shear.p = joined(guess.px, guess.ps);
  ++solution_.outer_iterations;
  solve_shear(system_, options_, work_, solution_);
}

VectorXd OuterLoop::image() {
  VectorXd next = VectorXd::Zero(n_ + 1);
  solution_.from_shear = next.head(n_) = normal_displacement(*system_.shear, solution_.shear.p);
  if (!system_.by_force)
    return next;
  const double force = system_.problem.force;
  if (force_to_length_ == 0)
    force_to_length_ = solution_.normal.u.cwiseAbs().maxCoeff() / force;
  solution_.borne = solution_.pressed + system_.shear_force(solution_.shear.p);
  // the guess: shear keeps its share
  const double ratio = std::clamp(force / solution_.borne, 1 / largest_force_step, largest_force_step);
  v_[n_] = solution_.pressed * force_to_length_;
  next[n_] = solution_.borne > 0 ? v_[n_] * ratio : largest_force_step * v_[n_];
  return next;
}

double OuterLoop::relative_change(const VectorXd& residual) const {
  const double change = residual.head(n_).cwiseAbs().maxCoeff() / solution_.normal.u.cwiseAbs().maxCoeff();
  if (!system_.by_force)
    return change;
  return std::max(change, std::abs(solution_.borne - system_.problem.force) / system_.problem.force);
}

void OuterLoop::tighten(double change) {
  const double share = system_.by_force ? system_.problem.force / solution_.pressed : 1.0;
  // If shear acts on the pressure by its force alone, it answers a change of the pressure by about its own
  // share of the force.
  const double left = system_.by_numbers ? 1.0 : std::min(std::abs(1 - share), 1.0);
  tolerance_.tighten(change, left, share);
}

/// Sets what the next outer iteration solves for.
void OuterLoop::advance(const VectorXd& residual) {
  if (system_.by_force && !system_.by_numbers) {
    solution_.pressed = balance_.next(solution_.pressed, solution_.borne);
    return;
  }
  v_ = anderson_.next(v_, residual);
  if (system_.by_force) {
    solution_.pressed = std::clamp(
        v_[n_] / force_to_length_, solution_.pressed / largest_force_step,
        std::min(largest_force_step * solution_.pressed, largest_force_ratio * system_.problem.force));
    v_[n_] = solution_.pressed * force_to_length_;
  }
}

bool OuterLoop::run(const RoughLook* look) {
  const ContactProblem& problem = system_.problem;
  double first_residual = 0;
  SettlingRate rate;
  SolverOptions options = options_;
  for (int outer = 0; outer < options_.max_outer; ++outer) {
    const int left = options_.max_outer - outer - 1;
    options.tolerance = tolerance_.now();
    if (outer == 0 && options.near)
      iterate_under_held_pressure();
    else
      iterate_once(system_, options, v_.head(n_), {problem.load, problem.approach, solution_.pressed}, work_,
                   solution_);
    if (!system_.coupled()) {
      if (system_.shear)
        solution_.from_shear = normal_displacement(*system_.shear, solution_.shear.p);
      return true;
    }
    const VectorXd next = image(), residual = next - v_;
    if (outer == 0)
      first_residual = residual.norm();
    else if (first_residual > 0)
      solution_.rate = std::pow(residual.norm() / first_residual, 1.0 / outer);
    const double change = relative_change(residual);
    if (tolerance_.is_settled(change))
      return true;
    if (look && change <= look->change) {
      set_distance(system_, solution_);
      solution_.ended_early = std::exchange(look, nullptr)->ends(solution_);
      if (solution_.ended_early)
        return true;
    }
    tighten(change);
    if (tolerance_.is_close(change)) // the same again, precisely
      continue;
    solution_.unbalanced = system_.by_force && balance_.at_the_most(solution_.pressed, solution_.borne);
    if (solution_.unbalanced || rate.is_hopeless(change, settling_factor * options_.tolerance, left))
      return false;
    advance(residual);
  }
  return !system_.coupled();
}

/// For one pressure force, iterates until the normal displacements no longer change.
bool settle_displacements(const CoupledSystem& system, const SolverOptions& options, WorkBudget& work,
                          Solution& solution) {
  Anderson anderson;
  SettlingRate rate;
  const double enough = settling_factor * options.tolerance;
  VectorXd v = solution.from_shear;
  for (int outer = 0; outer < options.max_outer; ++outer) {
    iterate_once(system, options, v, {LoadKind::force, 0, solution.pressed}, work, solution);
    solution.from_shear = normal_displacement(*system.shear, solution.shear.p);
    const VectorXd residual = solution.from_shear - v;
    const double change = residual.cwiseAbs().maxCoeff() / solution.normal.u.cwiseAbs().maxCoeff();
    if (change <= enough)
      return true;
    if (rate.is_hopeless(change, enough, options.max_outer - outer - 1))
      return false;
    v = anderson.next(v, residual);
  }
  return false;
}

/// Where shear carries much of a vertical force and also redistributes the pressure: for each pressure force
/// that ForceBalance tries, the displacements settle first. Slow and sure.
bool balance_apart(const CoupledSystem& system, const SolverOptions& options, WorkBudget& work,
                   Solution& solution) {
  const double force = system.problem.force;
  ForceBalance balance(force);
  solution.pressed = force;
  for (int trial = 0; trial < most_force_trials; ++trial) {
    if (!settle_displacements(system, options, work, solution))
      return false;
    solution.borne = solution.pressed + system.shear_force(solution.shear.p);
    if (std::abs(solution.borne - force) <= settling_factor * options.tolerance * force)
      return true;
    solution.unbalanced = balance.at_the_most(solution.pressed, solution.borne);
    if (solution.unbalanced)
      return false;
    solution.pressed = balance.next(solution.pressed, solution.borne);
  }
  return false;
}

/// What the solvers say of it. `first`: outer iterations before balance_apart().
std::string remark_of(const Solution& solution, bool settled, int first) {
  std::string remark = solution.normal.remark;
  if (!remark.empty())
    remark += separator;
  remark += solution.shear.remark;
  if (!settled) {
    remark += "normal and tangential problem did not settle in " +
              counted(first, "outer iteration", "outer iterations");
    if (const int apart = solution.outer_iterations - first; apart > 0)
      remark += fmt::format(", nor in {} more with the force of the pressure held", apart);
  }
  if (remark.ends_with(separator))
    remark.resize(remark.size() - separator.size());
  return remark;
}

} // namespace

void require_capacity(const ContactProblem& problem, const FoundCreepage& creepage) {
  const double wanted = std::hypot(problem.force_x.value_or(0), problem.force_s.value_or(0));
  if (creepage.beyond)
    throw InputError(
        "The shear force prescribed cannot be carried",
        fmt::format("|F| = {:g} N where friction carries less than sum mu p_n dS = {:g} N", wanted,
                    creepage.capacity),
        problem.bounds_vary()
            ? fmt::format(
                  "Prescribe less, or give a creepage ({} in sliding: over the creepage the force has "
                  "a maximum).",
                  problem.friction_varies() ? "mu falls" : "the layer softens by heat")
            : "Prescribe less, or give a creepage (full slip leaves it undetermined).");
  const double slipping = problem.kinetic * creepage.capacity;
  if (!creepage.reached && problem.kinetic < 1 && wanted >= slipping)
    throw InputError(
        "The shear force prescribed was not reached",
        fmt::format("|F| = {:g} N where full slip carries {:g} N, and at no creepage tried does what "
                    "sticks carry the rest",
                    wanted, slipping),
        "Prescribe less, or give a creepage.");
}

Solution solve_coupled(const ContactProblem& problem, const SolverOptions& options,
                       ContactOperators& operators, WorkBudget& work, const RoughLook* look) {
  Solution solution = start(problem, options, operators, work);
  const CoupledSystem system(problem, operators, settling_factor * options.tolerance, work);
  bool settled = OuterLoop(system, options, work, solution).run(look);
  const int first = solution.outer_iterations;
  if (!settled && system.by_force && system.by_numbers && !solution.unbalanced)
    settled = balance_apart(system, options, work, solution);
  require_capacity(problem, solution.creepage);
  set_distance(system, solution);
  solution.settled = settled;
  solution.remark = remark_of(solution, settled, first);
  return solution;
}

} // namespace bem_contact::contact
