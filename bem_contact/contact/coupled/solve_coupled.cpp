#include "bem_contact/contact/coupled/solve_coupled.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/contact/coupled/force_balance.hpp"
#include "bem_contact/contact/coupled/outer_iteration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace bem_contact::contact {
namespace {

using Eigen::VectorXd;

/// Numbers below this fraction of the self number are rounding.
constexpr double rounding = 1e-13;

bool numbers_couple(const InfluenceNumbers& a, double self) {
  const auto rows = a.stored_rows();
  for (int m = 0; m < a.offsets; ++m)
    for (const auto& [row_i, row_j] : rows)
      for (const int c : {component_x, component_s})
        if (std::max(std::abs(a.at(m, row_i, c, row_j, component_n)),
                     std::abs(a.at(m, row_i, component_n, row_j, c))) > rounding * self)
          return true;
  return false;
}

/// Throws where the shear forces prescribed cannot be carried.
void require_capacity(const ContactProblem& problem, const Creepage& creepage) {
  const double wanted = std::hypot(problem.force_x.value_or(0), problem.force_s.value_or(0));
  if (creepage.beyond)
    throw InputError("the shear force prescribed cannot be carried",
                     fmt::format("|F| = {:g} N where friction carries less than sum mu p_n dS = {:g} N",
                                 wanted, creepage.capacity),
                     "prescribe less, or give a creepage (full slip leaves it undetermined)");
  const double slipping = problem.kinetic * creepage.capacity;
  if (!creepage.reached && problem.kinetic < 1 && wanted >= slipping)
    throw InputError(
        "the shear force prescribed was not reached",
        fmt::format("|F| = {:g} N where full slip carries {:g} N, and at no creepage tried does what "
                    "sticks carry the rest",
                    wanted, slipping),
        "prescribe less, or give a creepage");
}

/// False, and nothing is set, where the guess is of another grid or has no pressure.
bool set_start(const StartingPoint& start, const ContactProblem& problem, Solution& solution) {
  const Eigen::Index n = problem.grid.size();
  if (start.pn.size() != static_cast<std::size_t>(n) ||
      std::ranges::none_of(start.pn, [](double p) { return p > 0; }))
    return false;
  solution.normal.p = Eigen::Map<const VectorXd>(start.pn.data(), n).cwiseMax(0.0);
  solution.normal.approach = start.approach;
  solution.normal.active.resize(start.pn.size());
  for (Eigen::Index i = 0; i < n; ++i)
    solution.normal.active[i] = solution.normal.p[i] > 0;
  if (problem.has_friction())
    solution.shear.p << Eigen::Map<const VectorXd>(start.px.data(), n),
        Eigen::Map<const VectorXd>(start.ps.data(), n);
  return true;
}

/// Where shear bears much of a vertical force and also shifts the pressure about, one thing after the other:
/// for each pressure that ForceBalance looks at the displacements settle first. Slow and sure.
bool balance_apart(const ContactProblem& problem, const SolverOptions& options, const NormalSystem& system,
                   const Shear& shear, const VectorXd& gap, const VectorXd& sine, Solution& solution) {
  constexpr int most_looks = 60;
  ForceBalance balance(problem.force);
  solution.pressed = problem.force;
  for (int look = 0; look < most_looks; ++look) {
    Anderson anderson;
    VectorXd v = solution.from_shear;
    bool settled = false;
    for (int turn = 0; turn < options.max_outer && !settled; ++turn) {
      turn_once(problem, options, system, &shear, gap, v, {LoadKind::force, 0, solution.pressed}, solution);
      solution.from_shear = normal_displacement(shear, solution);
      const VectorXd residual = solution.from_shear - v;
      settled =
          residual.cwiseAbs().maxCoeff() <= 10 * options.tolerance * solution.normal.u.cwiseAbs().maxCoeff();
      v = anderson.next(v, residual);
    }
    if (!settled)
      return false;
    solution.borne = solution.pressed + sine.dot(solution.shear.p.tail(sine.size())) * problem.element_area();
    if (std::abs(solution.borne - problem.force) <= 10 * options.tolerance * problem.force)
      return true;
    solution.unbalanced = balance.at_the_most(solution.pressed, solution.borne);
    if (solution.unbalanced)
      return false;
    solution.pressed = balance.next(solution.pressed, solution.borne);
  }
  return false;
}

} // namespace

Solution solve_coupled(const ContactProblem& problem, const SolverOptions& options, Prepared& kept) {
  const int n = problem.grid.size();
  const NormalSystem system(problem.grid, problem.numbers, problem.rows, problem.element_area(), &kept);
  const VectorXd gap = Eigen::Map<const VectorXd>(problem.gap.data(), n);
  Solution solution;
  solution.from_shear = VectorXd::Zero(n);
  solution.shear.p = VectorXd::Zero(2 * n);
  solution.shear.slip = VectorXd::Zero(2 * n);
  solution.shear.solver = "none";
  solution.shear.converged = true;
  if (!options.start || !set_start(*options.start, problem, solution))
    if (options.coarse_start)
      start_from_coarse(problem, options, kept, solution);

  VectorXd sine(n);
  for (int i = 0; i < n; ++i)
    sine[i] = std::sin(problem.rows[i / problem.grid.mx].delta);
  std::optional<Shear> shear;
  bool coupled = false, numbers_do = false;
  if (problem.has_friction()) {
    shear.emplace(Shear{TangentialSystem(problem, &kept), VectorXd(2 * n), {}});
    for (int i = 0; i < n; ++i) {
      shear->rigid[i] = problem.slip_x[i] * shear->system.rule.length;
      shear->rigid[n + i] = problem.slip_s[i] * shear->system.rule.length;
    }
    if (!kept.coupled)
      kept.coupled = numbers_couple(problem.numbers, system.self);
    numbers_do = *kept.coupled;
    if (numbers_do) {
      const std::vector<int> tangential{component_x, component_s}, normal{component_n};
      if (!kept.normal_from_shear) {
        kept.normal_from_shear.emplace(problem.numbers, problem.grid.mx, normal, tangential, RowRange{},
                                       kept.pool.get());
        kept.spend(spectra_work(problem.numbers.translational, 4, problem.grid.ms, problem.grid.mx));
        kept.shear_from_normal.emplace(problem.numbers, problem.grid.mx, tangential, normal, RowRange{},
                                       kept.pool.get());
      }
      shear->normal_from_shear = &*kept.normal_from_shear;
      shear->shear_from_normal = &*kept.shear_from_normal;
    }
    shear->former = former_slip(problem, *shear);
    coupled = numbers_do || (problem.load == LoadKind::force && sine.cwiseAbs().maxCoeff() > rounding);
  }

  // v: the displacement (A p_t)_n of each element, and the vertical force of the pressure as a displacement
  const bool by_force = coupled && problem.load == LoadKind::force && problem.force > 0;
  VectorXd v = VectorXd::Zero(n + 1);
  const auto shear_force = [&] { return sine.dot(solution.shear.p.tail(n)) * problem.element_area(); };
  solution.pressed = problem.force;
  if (by_force && solution.normal.p.size() == n) { // what shear bears of the start
    const double borne = system.cosine.dot(solution.normal.p) * problem.element_area();
    solution.pressed /= std::clamp(1 + shear_force() / borne, 2 / ForceBalance::most, 4.0);
  }
  if (numbers_do && solution.shear.p.any())
    v.head(n) = normal_displacement(*shear, solution);
  ForceBalance balance(problem.force);
  Anderson anderson;
  bool settled = false;
  double first_residual = 0, last_residual = 0, force_to_length = 0;
  // no turn is solved more precisely than what it is solved for is known
  constexpr double loose = 1e-4;
  SolverOptions turn_options = options;
  if (coupled)
    turn_options.tolerance = std::max(options.tolerance, loose);
  for (int turn = 0; turn < options.max_outer && !settled; ++turn) {
    turn_once(problem, turn_options, system, shear ? &*shear : nullptr, gap, v.head(n),
              {problem.load, problem.approach, solution.pressed}, solution);
    if (!coupled)
      break;
    VectorXd next = VectorXd::Zero(n + 1);
    solution.from_shear = next.head(n) = normal_displacement(*shear, solution);
    const double scale = solution.normal.u.cwiseAbs().maxCoeff();
    if (by_force) {
      if (turn == 0)
        force_to_length = scale / problem.force;
      solution.borne = solution.pressed + shear_force();
      // where shear keeps its share
      const double ratio = std::clamp(problem.force / solution.borne, 0.25, 4.0);
      v[n] = solution.pressed * force_to_length;
      next[n] = solution.borne > 0 ? v[n] * ratio : 4 * v[n];
    }
    const VectorXd residual = next - v;
    first_residual = turn == 0 ? residual.norm() : first_residual;
    last_residual = residual.norm();
    double off = residual.head(n).cwiseAbs().maxCoeff() / scale;
    if (by_force)
      off = std::max(off, std::abs(solution.borne - problem.force) / problem.force);
    // what hardly bears is a small difference of large forces
    const double precise = by_force
                               ? options.tolerance * std::clamp(problem.force / solution.pressed, 0.03, 1.0)
                               : options.tolerance;
    settled = off <= 10 * options.tolerance && turn_options.tolerance <= options.tolerance;
    turn_options.tolerance = std::max(precise, std::min(loose, 0.01 * off));
    if (settled)
      break;
    if (off <= 10 * options.tolerance) // the same again, precisely
      continue;
    const double most = ForceBalance::most * problem.force;
    solution.unbalanced = by_force && balance.at_the_most(solution.pressed, solution.borne);
    if (solution.unbalanced)
      break;
    if (by_force && !numbers_do) {
      solution.pressed = balance.next(solution.pressed, solution.borne);
      continue;
    }
    v = anderson.next(v, residual);
    if (by_force) {
      solution.pressed =
          std::clamp(v[n] / force_to_length, 0.25 * solution.pressed, std::min(4 * solution.pressed, most));
      v[n] = solution.pressed * force_to_length;
    }
  }
  if (by_force && numbers_do && !settled && !solution.unbalanced)
    settled = balance_apart(problem, options, system, *shear, gap, sine, solution);
  require_capacity(problem, solution.creepage);
  if (solution.outer_iterations > 1 && first_residual > 0)
    solution.rate = std::pow(last_residual / first_residual, 1.0 / (solution.outer_iterations - 1));
  solution.distance =
      gap + solution.from_shear - solution.normal.approach * system.cosine + solution.normal.u;
  solution.remark =
      solution.normal.remark + (solution.normal.remark.empty() ? "" : "; ") + solution.shear.remark;
  if (coupled && !settled)
    solution.remark +=
        fmt::format("normal and tangential problem did not settle in {} turns; ", solution.outer_iterations);
  return solution;
}

} // namespace bem_contact::contact
