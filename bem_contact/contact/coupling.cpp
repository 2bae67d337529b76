#include "bem_contact/contact/coupling.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/contact/force_balance.hpp"

#include <Eigen/QR>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>

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

/// Fixed-point iteration v = G(v) by Anderson's method, with a short memory.
class Anderson {
public:
  VectorXd next(const VectorXd& v, const VectorXd& residual) {
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

private:
  struct Turn {
    VectorXd v, residual;
  };
  std::deque<Turn> history_;
  std::optional<double> best_;
};

struct Shear {
  TangentialSystem system;
  VectorXd rigid;  ///< w of the step, mm
  VectorXd former; ///< what the tractions of former steps add to the slip, mm
  const StripOperator *normal_from_shear = nullptr, *shear_from_normal = nullptr; ///< null: no coupling
};

/// sum_k former[k] u_k(x + k columns dx), u = -A p.
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
        kept.normal_from_shear.emplace(problem.numbers, problem.grid.mx, normal, tangential);
        kept.shear_from_normal.emplace(problem.numbers, problem.grid.mx, tangential, normal);
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
    solution.pressed /= std::clamp(1 + shear_force() / borne, 0.25, 4.0);
  }
  if (numbers_do && solution.shear.p.any()) {
    VectorXd u(n);
    shear->normal_from_shear->apply(view(solution.shear.p), view(u));
    v.head(n) = u;
  }
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
    ++solution.outer_iterations;
    solution.normal.remark.clear();
    const VectorXd before = solution.normal.p;
    solve_normal(system, gap + v.head(n), {problem.load, problem.approach, solution.pressed}, turn_options,
                 solution.normal);
    if (!shear)
      break;
    if (before.size() == n)
      follow(before, solution.normal.p, solution.shear.p);
    solution.task =
        make_task(problem, *shear, solution.normal.p, 1e-12 * solution.normal.p.maxCoeff() * system.self);
    solve_friction(shear->system, turn_options, solution.task, solution.shear, solution.creepage);
    if (!coupled)
      break;
    VectorXd next = VectorXd::Zero(n + 1);
    if (numbers_do) {
      VectorXd u(n);
      shear->normal_from_shear->apply(view(solution.shear.p), view(u));
      next.head(n) = u;
    }
    solution.from_shear = next.head(n);
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
    solution.unbalanced = by_force && solution.pressed >= most && solution.borne < problem.force;
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
