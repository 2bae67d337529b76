#include "bem_contact/contact/tangent.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/contact/coupled/tangent_system.hpp"
#include "bem_contact/contact/dissipation.hpp"
#include "bem_contact/contact/eigen_fields.hpp"
#include "bem_contact/contact/solve.hpp"
#include "bem_contact/contact/totals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace bem_contact {

namespace {

using contact::ContactOperators;
using contact::CoupledSystem;
using contact::joined;
using contact::LentNumbers;
using contact::TangentLoad;
using contact::TangentSystem;
using contact::TangentTractions;
using contact::vector_of;
using Eigen::Vector2d;
using Eigen::VectorXd;

/// The change of influence numbers per unit of an input, on a problem of its own.
ContactProblem change_of_numbers(const TangentInput& input) {
  ContactProblem out = input.upper;
  for (std::size_t k = 0; k < out.numbers.values.size(); ++k)
    out.numbers.values[k] = (out.numbers.values[k] - input.lower.numbers.values[k]) / (2 * input.step);
  return out;
}

/// Displacements of the tractions of a solution, by other influence numbers than it was solved with.
struct HeldDisplacements {
  VectorXd normal, step; ///< (A p)_n and B p, mm; fields

  HeldDisplacements(const ContactProblem& problem, const ContactResult& solved, const SolverOptions& options,
                    WorkBudget& work) {
    ContactOperators operators;
    const CoupledSystem system(problem, operators, options.tolerance, work);
    const VectorXd pn = vector_of(solved.pn);
    normal = system.normal.apply(pn, work);
    if (!system.shear)
      return;
    const VectorXd pt = joined(solved.px, solved.ps);
    normal += normal_displacement(*system.shear, pt);
    step = system.shear->system.step(pt, work) + step_of_pressure(*system.shear, pn);
  }
};

/// What one side of an input says where the tractions are held; a half of the difference of both sides over
/// the step is a TangentLoad.
TangentLoad side_of(const ContactProblem& side, const ContactResult& solved, bool friction,
                    bool shear_bears) {
  const int n = side.grid.size(), mx = side.grid.mx;
  TangentLoad out{VectorXd(n),       VectorXd::Zero(2 * n),
                  VectorXd::Zero(n), side.approach,
                  side.force,        {side.force_x.value_or(0), side.force_s.value_or(0)}};
  const double length = slip_step(side).length, area = side.element_area();
  for (int i = 0; i < n; ++i) {
    const double cosine = std::cos(side.rows[i / mx].delta), sine = std::sin(side.rows[i / mx].delta);
    out.distance[i] = side.gap[i] - solved.totals.approach * cosine;
    out.force -= area * (solved.pn[i] * cosine + (shear_bears ? solved.ps[i] * sine : 0.0));
    if (!friction || !(solved.pn[i] > 0))
      continue;
    const double share = side.lateral_share(i / mx);
    out.drive[i] = length * side.slip_x[i];
    out.drive[n + i] = length * (side.slip_s[i] + solved.totals.creepage_s * share);
    out.bound[i] = shear_bound(side, solved, i);
    out.shear_forces[1] -= area * solved.ps[i] * share;
  }
  return out;
}

/// The tangents of one solution.
class Tangents {
public:
  Tangents(ContactProblem& problem, const ContactResult& solved, const SolverOptions& options,
           WorkBudget& work)
      : problem_(problem), solved_(solved), options_(options), work_(work),
        system_(problem, solved, options.workspace ? options.workspace->of(problem) : only_now_, options,
                work) {
    for (const std::vector<int>& elements : patch_elements(problem, solved))
      highest_.push_back(std::size_t(std::ranges::max(elements, {}, [&](int i) { return solved.pn[i]; })));
    highest_of_all_ = std::size_t(std::ranges::max_element(solved.pn) - solved.pn.begin());
  }

  Tangent along(TangentInput& input);

private:
  TangentLoad load_of(TangentInput& input);
  void add_numbers(TangentInput& input, TangentLoad& load);
  ContactResult continued(ContactProblem& to, double by, const TangentTractions& tangent);
  void limit(Tangent& out, const TangentLoad& load, const TangentTractions& tangent) const;

  ContactProblem& problem_; ///< lends its numbers
  const ContactResult& solved_;
  const SolverOptions& options_;
  WorkBudget& work_;
  ContactOperators only_now_;
  TangentSystem system_;
  VectorXd distance_, slip_; ///< of the tangent at hand, per unit; fields
  /// Elements with the largest pressure, of each patch and of all: on the tangent another may pass them.
  std::vector<std::size_t> highest_;
  std::size_t highest_of_all_ = 0;
};

void Tangents::add_numbers(TangentInput& input, TangentLoad& load) {
  const HeldDisplacements change(change_of_numbers(input), solved_, options_, work_);
  load.distance += change.normal;
  if (change.step.size() > 0)
    load.drive -= change.step;
}

TangentLoad Tangents::load_of(TangentInput& input) {
  const TangentLoad lower = side_of(input.lower, solved_, system_.has_shear(), system_.shear_bears()),
                    upper = side_of(input.upper, solved_, system_.has_shear(), system_.shear_bears());
  const double per = 1 / (2 * input.step);
  TangentLoad out{per * (upper.distance - lower.distance), per * (upper.drive - lower.drive),
                  per * (upper.bound - lower.bound),       per * (upper.approach - lower.approach),
                  per * (upper.force - lower.force),       per * (upper.shear_forces - lower.shear_forces)};
  if (!input.lower.numbers.values.empty())
    add_numbers(input, out);
  return out;
}

/// Patches in the order of `wanted`: those of equal forces may have changed places.
void order_like(const std::vector<PatchSummary>& wanted, std::vector<PatchSummary>& patches) {
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const auto distance = [&](const PatchSummary& p) {
      return std::hypot(p.x - wanted[k].x, p.s - wanted[k].s);
    };
    std::iter_swap(patches.begin() + std::ptrdiff_t(k),
                   std::min_element(patches.begin() + std::ptrdiff_t(k), patches.end(),
                                    [&](const auto& a, const auto& b) { return distance(a) < distance(b); }));
  }
}

ContactResult Tangents::continued(ContactProblem& to, double by, const TangentTractions& tangent) {
  const int n = problem_.grid.size();
  const double length = slip_step(problem_).length;
  ContactResult out;
  const auto moved = [&](const std::vector<double>& from, const double* change, double factor) {
    std::vector<double> all = from;
    for (int i = 0; i < n; ++i)
      all[i] += factor * change[i];
    return all;
  };
  out.pn = moved(solved_.pn, tangent.pn.data(), by);
  out.px = moved(solved_.px, tangent.pt.data(), by);
  out.ps = moved(solved_.ps, tangent.pt.data() + n, by);
  out.slip_x = moved(solved_.slip_x, slip_.data(), by / length);
  out.slip_s = moved(solved_.slip_s, slip_.data() + n, by / length);
  out.deformed_distance = moved(solved_.deformed_distance, distance_.data(), by);
  out.state = solved_.state;
  out.totals.approach = {solved_.totals.approach + by * tangent.approach};
  out.totals.creepage_x = {solved_.totals.creepage_x + by * tangent.creepage[0]};
  out.totals.creepage_s = {solved_.totals.creepage_s + by * tangent.creepage[1]};
  if (to.has_friction()) { // which looks into the numbers
    std::optional<LentNumbers> lent;
    if (to.numbers.values.empty())
      lent.emplace(problem_.numbers, to);
    out.dissipated = contact::dissipated(to, out);
  }
  set_totals(to, out);
  order_like(solved_.patches, out.patches);
  for (std::size_t k = 0; k < out.patches.size(); ++k)
    out.patches[k].pmax = {out.pn[highest_[k]]};
  out.totals.pmax = {out.pn[highest_of_all_]};
  return out;
}

/// How far to both sides an input may go; keeps the nearest change of a state.
class Range {
public:
  explicit Range(Tangent& tangent) : tangent_(tangent) {}

  /// `left`: what is left of a condition, at least 0 but for rounding; `rate`: what it becomes less by.
  void take(double left, double rate, StateChange what) {
    if (rate != 0)
      take_step(std::max(left, 0.0) / rate, what);
  }
  /// |p + a change| reaches bound + a rate, a > 0 or a < 0.
  void take_cone(const Vector2d& p, const Vector2d& change, double bound, double rate) {
    const double square = change.squaredNorm() - rate * rate, half = p.dot(change) - bound * rate,
                 rest = std::min(p.squaredNorm() - bound * bound, 0.0);
    const double root = half * half - square * rest;
    if (root < 0 || (square == 0 && half == 0))
      return;
    const double q = -(half + std::copysign(std::sqrt(root), half)); // no digits cancel
    if (square != 0)
      take_step(q / square, StateChange::slips);
    if (q != 0)
      take_step(rest / q, StateChange::slips);
  }

private:
  void take_step(double step, StateChange what) {
    const bool down = std::signbit(step);
    double& nearest = down ? tangent_.below : tangent_.above;
    if (std::abs(step) < nearest) {
      nearest = std::abs(step);
      (down ? tangent_.at_below : tangent_.at_above) = what;
    }
  }
  Tangent& tangent_;
};

void Tangents::limit(Tangent& out, const TangentLoad& load, const TangentTractions& tangent) const {
  const int n = problem_.grid.size();
  const double limit = problem_.limit_pressure.value_or(std::numeric_limits<double>::infinity()),
               length = slip_step(problem_).length;
  Range range(out);
  for (int i = 0; i < n; ++i) {
    const double pn = solved_.pn[i], e = solved_.deformed_distance[i];
    if (!(pn > 0)) {
      range.take(e, -distance_[i], StateChange::touches);
      continue;
    }
    if (pn >= limit) {
      range.take(-e, distance_[i], StateChange::recovers);
    } else {
      range.take(pn, -tangent.pn[i], StateChange::leaves);
      if (std::isfinite(limit))
        range.take(limit - pn, tangent.pn[i], StateChange::yields);
    }
    if (!system_.has_shear())
      continue;
    const Vector2d p(solved_.px[i], solved_.ps[i]), change(tangent.pt[i], tangent.pt[n + i]);
    if (!system_.slips(i)) {
      range.take_cone(p, change, system_.bound()[i], load.bound[i] + system_.bound_rate(i) * tangent.pn[i]);
    } else if (const double size = p.norm(); size > 0) {
      const Vector2d slip(solved_.slip_x[i], solved_.slip_s[i]), faster(slip_[i], slip_[n + i]);
      range.take(length * slip.dot(p) / size, -faster.dot(p) / size, StateChange::sticks);
    }
  }
}

Tangent Tangents::along(TangentInput& input) {
  const TangentLoad load = load_of(input);
  const TangentTractions tangent = system_.solve(load);
  distance_ = load.distance + system_.distance(tangent);
  slip_ = system_.has_shear() ? VectorXd(load.drive + system_.slip(tangent))
                              : VectorXd::Zero(2 * problem_.grid.size());
  Tangent out;
  out.lower = continued(input.lower, -input.step, tangent);
  out.upper = continued(input.upper, input.step, tangent);
  limit(out, load, tangent);
  return out;
}

} // namespace

std::string tangent_obstacle(const ContactProblem& problem) {
  if (problem.motion != MotionKind::steady)
    return "a history has no derivatives: they would be those of every step before";
  if (problem.kinetic != 1)
    return "motion.kinetic_friction makes the friction jump where an element begins to slip";
  if (problem.friction_falls() || problem.memory)
    return "friction falls with the slip velocity";
  if (problem.heat_acts())
    return "friction or layer depend on the temperature";
  if (problem.hardens())
    return "the layer hardens or softens";
  return "";
}

std::vector<Tangent> tangents(ContactProblem& problem, const ContactResult& solved, int count,
                              const std::function<TangentInput(int)>& input, const SolverOptions& options,
                              WorkBudget& work) {
  if (const std::string why = tangent_obstacle(problem); !why.empty())
    throw InputError("This contact has no derivatives", why, "Leave out derivatives.");
  if (solved.patches.empty())
    throw InputError("This contact has no derivatives", "nothing touches", "Leave out derivatives.");
  Tangents all(problem, solved, options, work);
  std::vector<Tangent> out;
  for (int k = 0; k < count; ++k) {
    TangentInput both_sides = input(k);
    out.push_back(all.along(both_sides));
  }
  return out;
}

} // namespace bem_contact
