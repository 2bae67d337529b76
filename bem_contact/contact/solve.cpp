#include "bem_contact/contact/solve.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/stopwatch.hpp"
#include "bem_contact/contact/check/certificate.hpp"
#include "bem_contact/contact/check/discretisation.hpp"
#include "bem_contact/contact/check/error_estimates.hpp"
#include "bem_contact/contact/check/imbalance.hpp"
#include "bem_contact/contact/coupled/contact_operators.hpp"
#include "bem_contact/contact/coupled/settings.hpp"
#include "bem_contact/contact/coupled/solve_coupled.hpp"
#include "bem_contact/contact/dissipation.hpp"
#include "bem_contact/contact/flash_temperature.hpp"
#include "bem_contact/contact/grid/larger_elements.hpp"
#include "bem_contact/contact/plastic_slip.hpp"
#include "bem_contact/contact/settings.hpp"
#include "bem_contact/contact/totals.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace bem_contact {

Workspace::Workspace(int most, int threads)
    : most_(most), pool_(std::make_shared<contact::TransformPool>(threads)) {}

Workspace::~Workspace() = default;
Workspace::Workspace(Workspace&&) noexcept = default;
Workspace& Workspace::operator=(Workspace&&) noexcept = default;

int Workspace::threads() const {
  return pool_->threads();
}

contact::ContactOperators& Workspace::of(const ContactProblem& problem) {
  const contact::NumbersKey key = contact::key_of(problem);
  const auto found = std::ranges::find_if(sets_, [&](const auto& set) { return set->key() == key; });
  if (found != sets_.end()) {
    ++kept_;
    sets_.splice(sets_.begin(), sets_, found);
    return *sets_.front();
  }
  ++prepared_;
  sets_.push_front(std::make_unique<contact::ContactOperators>(pool_, key));
  if (sets_.size() > static_cast<std::size_t>(std::max(most_, 1)))
    sets_.pop_back();
  return *sets_.front();
}

namespace {

using Eigen::VectorXd;

/// 1. What a rough creepage of free rolling may be off by, over its stated error.
constexpr double free_creepage_share = 0.1;

/// Adhesion or slip: the state whose equation the element fulfils better.
ElementState friction_state(double slip, double slip_scale, double deviation, double traction_scale) {
  return slip / slip_scale <= deviation / traction_scale ? ElementState::adhesion : ElementState::slip;
}

void fill_fields(const ContactProblem& problem, const contact::Solution& solution, ContactResult& result) {
  const int n = problem.grid.size();
  const bool friction = problem.has_friction() && solution.task.bound.size() > 0;
  const auto field = [n](const VectorXd& v, int component) {
    return std::vector<double>(v.data() + component * n, v.data() + (component + 1) * n);
  };
  result.pn = field(solution.normal.p, 0);
  result.px = field(solution.shear.p, 0);
  result.ps = field(solution.shear.p, 1);
  result.deformed_distance = field(solution.distance, 0);
  result.slip_x.assign(n, 0.0);
  result.slip_s.assign(n, 0.0);
  result.state.assign(n, ElementState::exterior);
  const contact::TangentialTask& task = solution.task;
  const double slip_scale =
      friction ? contact::largest_slip(task.rigid, task.contact, solution.shear.slip, task.slip_floor) : 1.0;
  const double traction_scale = friction ? task.bound.maxCoeff() : 1.0;
  const double length = slip_step(problem).length;
  for (int i = 0; i < n; ++i) {
    if (!(result.pn[i] > 0))
      continue;
    result.state[i] = ElementState::slip; // without friction surfaces slip freely
    if (!friction)
      continue;
    const double sx = solution.shear.slip[i], ss = solution.shear.slip[n + i], slip = std::hypot(sx, ss);
    result.slip_x[i] = sx / length;
    result.slip_s[i] = ss / length;
    const double bound = task.bound[i];
    const double deviation =
        slip > 0 ? std::hypot(result.px[i] - bound * sx / slip, result.ps[i] - bound * ss / slip) : bound;
    result.state[i] = friction_state(slip, slip_scale, deviation, traction_scale);
  }
}

/// The plastic slip of a layer that yields, after this solution; field.
std::vector<double> plastic_slip(const ContactProblem& problem, const contact::Solution& solution) {
  const std::size_t n = problem.grid.size();
  const VectorXd &p = solution.shear.p, &slip = solution.shear.slip, &bound = solution.task.bound;
  const VectorXd& limits = solution.task.limits;
  std::vector<double> friction(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double limit = limits.size() > 0 ? limits[i] : problem.yield->shear;
    const bool slides = !problem.hardens() && bound[i] < limit; // friction may vary
    friction[i] = slides ? bound[i] : problem.friction_of(int(i) / problem.grid.mx) * solution.normal.p[i];
  }
  return contact::plastic_of(
      contact::PlasticSlip(problem).answers({.px = {p.data(), n},
                                             .ps = {p.data() + n, n},
                                             .slip_x = {slip.data(), n},
                                             .slip_s = {slip.data() + n, n},
                                             .friction = friction,
                                             .limits = {limits.data(), std::size_t(limits.size())}}));
}

/// Throws where friction leaves no equilibrium.
void require_balance(const ContactProblem& problem, const contact::Solution& solution) {
  if (!solution.unbalanced)
    return;
  throw InputError(
      "No pressure balances the vertical force",
      fmt::format(
          "on surfaces so steep friction of {:g} pulls down what the pressure bears: pressure that "
          "bears {:.4g} N, {:g} times the force, leaves {:.4g} N with the shear tractions, and {:g} N "
          "are prescribed; more was not tried",
          problem.largest_friction(), solution.pressed, solution.pressed / problem.force, solution.borne,
          problem.force),
      "Give less friction or yaw, another lateral position, or an approach in place of the force.");
}

int threads_of(const SolverOptions& options) {
  return options.workspace ? options.workspace->threads() : 1;
}

/// Without a certificate.
ContactResult result_of(const ContactProblem& problem, const contact::Solution& solution) {
  ContactResult result;
  fill_fields(problem, solution, result);
  if (problem.yield && problem.has_friction())
    result.plastic = plastic_slip(problem, solution);
  ContactTotals& totals = result.totals;
  totals.approach = {solution.normal.approach};
  totals.creepage_x = {solution.creepage.x};
  totals.creepage_s = {solution.creepage.s};
  totals.compliance_x = solution.creepage.compliance_x;
  totals.compliance_s = solution.creepage.compliance_s;
  if (problem.has_friction())
    result.dissipated = contact::dissipated(problem, result);
  if (problem.heating && problem.has_friction())
    result.temperatures = flash_temperatures(problem, result);
  set_totals(problem, result);
  result.effort.normal_solver = solution.normal.solver;
  result.effort.tangential_solver = solution.shear.solver;
  result.effort.outer_iterations = solution.outer_iterations;
  result.effort.normal_iterations = solution.normal.iterations;
  result.effort.tangential_iterations = solution.shear.iterations;
  result.effort.creepage_iterations = solution.creepage.iterations;
  result.effort.outer_rate = solution.rate;
  result.trust.solver_note = solution.remark;
  return result;
}

ContactResult certified_result(const ContactProblem& problem, const contact::Solution& solution,
                               const SolverOptions& options) {
  require_balance(problem, solution);
  ContactResult result = result_of(problem, solution);
  const Stopwatch checking;
  result.trust.certificate =
      certify(problem, result, options.displacements ? &result.displacements : nullptr, threads_of(options));
  result.effort.check_seconds = checking.seconds();
  if (!result.certified() && result.trust.solver_note.empty())
    result.trust.solver_note = contact::violated_condition(result.trust.certificate, options.tolerance);
  return result;
}

/// The errors of the results of one problem, from its companion. A rough result and the precise one share it
/// where both join the same elements.
class Estimate {
public:
  Estimate(const ContactProblem& problem, const SolverOptions& options, contact::ContactOperators& operators,
           WorkBudget& work)
      : problem_(problem), options_(options), operators_(operators), work_(work) {
    options_.tolerance = std::max(options.tolerance, contact::companion_tolerance);
    options_.displacements = false;
  }

  /// Estimates the errors of the discretisation, or says why they cannot be told.
  void add_to(ContactResult& result);
  double seconds() const { return seconds_; }

private:
  struct Solved {
    contact::LargerElements larger;
    ContactProblem problem; ///< without influence numbers
    ContactResult result;
  };
  void solve(const contact::LargerElements& larger, const ContactResult& fine,
             contact::CompanionOperators& prepared);

  const ContactProblem& problem_;
  SolverOptions options_; ///< of the companion
  contact::ContactOperators& operators_;
  WorkBudget& work_;
  std::optional<Solved> companion_;
  double seconds_ = 0;
};

void Estimate::solve(const contact::LargerElements& larger, const ContactResult& fine,
                     contact::CompanionOperators& prepared) {
  contact::Companion coarse = contact::companion_of(problem_, fine, larger);
  options_.start = &coarse.start;
  std::optional<ContactResult> result;
  {
    const contact::LentNumbers lent(prepared.numbers, coarse.problem);
    result = certified_result(coarse.problem,
                              contact::solve_coupled(coarse.problem, options_, prepared.operators, work_),
                              options_);
  }
  companion_.emplace(Solved{larger, std::move(coarse.problem), std::move(*result)});
}

void Estimate::add_to(ContactResult& result) {
  result.trust.why_no_errors = options_.estimate_discretisation ? contact::why_no_companion(problem_, result)
                                                                : "they are not asked for";
  if (!result.trust.why_no_errors.empty())
    return;
  const Stopwatch clock;
  const contact::LargerElements larger(problem_.grid, result.pn);
  contact::CompanionOperators& prepared =
      operators_.companion(problem_.numbers, larger, !problem_.has_friction());
  try {
    if (!companion_ || !companion_->larger.joins_like(larger))
      solve(larger, result, prepared);
    auto& [joined, problem, coarse] = *companion_;
    const contact::LentNumbers lent(prepared.numbers, problem);
    contact::compare(problem_, problem, coarse, result);
  } catch (const Error&) { // larger elements cannot carry the forces, or no work is left
    result.trust.why_no_errors = "elements twice as large have no solution. Give smaller elements";
  }
  seconds_ += clock.seconds();
}

/// Of the longitudinal force that larger elements say of a solution, over what friction carries.
double known_share(const ContactProblem& problem, const ContactResult& solved) {
  if (!solved.trust.discretisation)
    return unknown_error;
  const ContactTotals& totals = solved.totals;
  const double force = totals.Fx.error > 0 ? totals.Fx.error : totals.creepage_x.error / totals.compliance_x;
  return force / friction_bound(problem, solved);
}

/// The solution without longitudinal force is looked for from here.
NearSolution near_solution(Tractions tractions, double approach, double creepage_x, double creepage_s) {
  NearSolution near{{std::move(tractions), approach}, {}};
  near.shear_guess.px = near.px;
  near.shear_guess.ps = near.ps;
  near.creepage_x = creepage_x;
  near.creepage_s = creepage_s;
  return near;
}

/// A rough solution from `near`. Nothing where it did not settle at once.
std::optional<ContactResult> rough_result(const ContactProblem& problem, const NearSolution& near,
                                          SolverOptions options, contact::ContactOperators& operators,
                                          WorkBudget& work) {
  options.near = &near;
  options.start = nullptr;
  options.early_end = nullptr;
  const contact::Solution solution = contact::solve_coupled(problem, options, operators, work);
  if (!solution.settled || !solution.shear.converged || !solution.creepage.reached)
    return std::nullopt;
  return result_of(problem, solution);
}

/// The same problem on the larger elements of the estimate, from the companion of `near`.
class FreeOnLarger {
public:
  FreeOnLarger(const ContactProblem& problem, const ContactResult& near, double creepage,
               const SolverOptions& options, contact::ContactOperators& operators, WorkBudget& work)
      : larger_(problem.grid, near.pn), prepared_(operators.companion(problem.numbers, larger_, false)),
        coarse_(contact::companion_of(problem, near, larger_).problem),
        companion_(near.trust.discretisation->tractions) {
    const contact::LentNumbers lent(prepared_.numbers, coarse_);
    try {
      result_ = rough_result(coarse_,
                             near_solution(companion_, near.trust.discretisation->coarse.approach, creepage,
                                           near.totals.creepage_s),
                             options, prepared_.operators, work);
    } catch (const Error&) { // larger elements cannot carry the forces, or no work is left
    }
  }

  /// The fine elements begin with what the larger ones found.
  void improve(NearSolution& near) const {
    if (!result_)
      return;
    near.creepage_x = result_->totals.creepage_x;
    near.creepage_s = result_->totals.creepage_s;
    const auto add_change = [&](std::vector<double> Tractions::*component, const std::vector<double>& found) {
      std::vector<double> change = found;
      for (std::size_t i = 0; i < change.size(); ++i)
        change[i] -= (companion_.*component)[i];
      change = larger_.between(change);
      for (std::size_t i = 0; i < change.size(); ++i)
        if (near.pn[i] > 0)
          (near.shear_guess.*component)[i] += change[i];
    };
    add_change(&Tractions::px, result_->px);
    add_change(&Tractions::ps, result_->ps);
  }

  /// Of the creepage that `found` has.
  double error_of(const ContactProblem& problem, const ContactResult& found) {
    if (!result_ || !contact::why_no_companion(problem, found).empty())
      return unknown_error;
    const contact::LentNumbers lent(prepared_.numbers, coarse_);
    return contact::creepage_x_error(problem, found, coarse_, *result_);
  }

private:
  contact::LargerElements larger_;
  contact::CompanionOperators& prepared_;
  ContactProblem coarse_; ///< without influence numbers
  Tractions companion_;
  std::optional<ContactResult> result_;
};

} // namespace

std::optional<Measured> free_creepage(const ContactProblem& problem, const ContactResult& near,
                                      double creepage, const SolverOptions& given, WorkBudget& work) {
  validate(problem);
  contact::ContactOperators only_now;
  contact::ContactOperators& operators = given.workspace ? given.workspace->of(problem) : only_now;
  // What is missing of the forces may be settling_factor times the tolerance; so may be what the tractions'
  // equations miss, and what a change of the pressure is worth.
  const double known = known_share(problem, near) * free_creepage_share / (3 * contact::settling_factor);
  SolverOptions options = given;
  options.tolerance = std::isfinite(known) ? std::clamp(known, given.tolerance, contact::loose_tolerance)
                                           : std::max(given.tolerance, contact::companion_tolerance);
  NearSolution start =
      near_solution(tractions_of(near), near.totals.approach, creepage, near.totals.creepage_s);
  std::optional<FreeOnLarger> on_larger;
  if (given.estimate_discretisation && near.trust.discretisation) {
    on_larger.emplace(problem, near, creepage, options, operators, work);
    on_larger->improve(start);
  }
  // On larger elements tractions count too, for the error is estimated from both.
  options.forces_alone = std::isfinite(known);
  const auto rough = rough_result(problem, start, options, operators, work);
  if (!rough)
    return std::nullopt;
  const double left =
      std::isfinite(rough->totals.compliance_x) ? -rough->totals.compliance_x * rough->totals.Fx : 0;
  return Measured{rough->totals.creepage_x + left,
                  on_larger ? on_larger->error_of(problem, *rough) : unknown_error};
}

ContactResult solve(const ContactProblem& problem, const SolverOptions& options) {
  WorkBudget work;
  return solve(problem, options, work);
}

ContactResult solve(const ContactProblem& problem, const SolverOptions& options, WorkBudget& work) {
  validate(problem);
  contact::ContactOperators only_now;
  contact::ContactOperators& operators = options.workspace ? options.workspace->of(problem) : only_now;
  if (!options.start && !options.continues)
    operators.forget_solutions();
  Estimate estimate(problem, options, operators, work);
  ContactResult result;
  std::optional<contact::RoughLook> look;
  if (options.early_end)
    look = contact::RoughLook{options.early_end->change, [&](const contact::Solution& rough) {
                                result = result_of(problem, rough);
                                result.trust.ended_early = true;
                                estimate.add_to(result);
                                return options.early_end->ends(problem, result);
                              }};
  const contact::Solution solution =
      contact::solve_coupled(problem, options, operators, work, look ? &*look : nullptr);
  if (!solution.ended_early) {
    result = certified_result(problem, solution, options);
    if (result.certified())
      estimate.add_to(result);
    else
      result.trust.why_no_errors = "the result is not certified";
  }
  result.effort.estimate_seconds = estimate.seconds();
  result.effort.work = work.used();
  return result;
}

int first_joined_row(int rows, int lowest, int highest) {
  return contact::LargerElements::first_joined(rows, lowest, highest);
}

} // namespace bem_contact
