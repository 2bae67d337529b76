#include "bem_contact/contact/tangential/creepage_search.hpp"

#include "bem_contact/contact/settings.hpp"
#include "bem_contact/contact/tangential/creepage_forces.hpp"
#include "bem_contact/contact/tangential/kinetic_friction.hpp"
#include "bem_contact/contact/tangential/settings.hpp"

#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace bem_contact::contact {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

/// 1. A force this close to the capacity is full slip: rounding.
constexpr double rounding_of_capacity = 1e-9;
/// Tangential problems that the search for one creepage may solve. Chosen.
constexpr int most_creepage_calls = 120;
/// 1 (shift: mm). Where everything slips no force depends on the creepage. Chosen: the search ends here.
constexpr double farthest_creepage = 1e12;
/// 1. A bracket narrower than this share of the creepage holds a jump of the force: far below what tells
/// adhesion from slip.
constexpr double creepage_jump = 1e-11;
/// Newton steps for two creepages, and how many of them may fail. Chosen.
constexpr int most_creepage_newton = 40;
constexpr int most_creepage_stops = 4;
/// 1. Difference of the finite differences, relative to the creepage. Chosen.
constexpr double creepage_difference = 1e-3;
/// 1. The longest of these steps, relative to the creepage. Chosen.
constexpr double longest_creepage_step = 2;
/// Lengths that the line search tries, and by how much the missing force has to decrease. Chosen.
constexpr int creepage_halvings = 10;
constexpr double creepage_decrease = 1e-3;

/// One unknown: secants until the force is bracketed, then Illinois' rule, with bisection where that is slow.
/// When friction is almost zero, the force jumps at some creepage and no creepage gives the prescribed force.
/// Then the tractions are interpolated between both sides of the jump. The last call of `missing_at` is the
/// one at the result.
template <class Function>
bool find_root(CreepageForces& forces, const Function& missing_at, double start, double step,
               double tolerance) {
  int calls = 1;
  double a = start, at_a = missing_at(a), b = a, at_b = at_a;
  CreepageForces::Solved solved_a = forces.solved(), solved_b = solved_a;
  while (std::abs(at_b) > tolerance && at_a * at_b > 0) {
    if (++calls > most_creepage_calls || std::abs(b) > farthest_creepage)
      return false;
    if (b != a) {
      const double secant = (b - a) * at_b / (at_a - at_b); // infinite where everything slips
      a = b;
      at_a = at_b;
      step =
          std::clamp(std::isfinite(secant) ? creepage_overshoot * std::abs(secant) : creepage_growth * step,
                     step, creepage_growth * step);
    }
    solved_a = std::move(solved_b);
    b = a + (at_a > 0 ? step : -step);
    at_b = missing_at(b);
    solved_b = forces.solved();
  }
  double weight_a = 1;
  for (int side = 0, slow = 0; std::abs(at_b) > tolerance; ++slow) {
    if (++calls > most_creepage_calls)
      return false;
    const double width = std::abs(b - a);
    if (width <= creepage_jump * std::max(std::abs(a), std::abs(b)) && forces.may_blend()) {
      forces.blend(solved_a, solved_b, at_a / (at_a - at_b));
      return true;
    }
    double c = (weight_a * at_a * b - at_b * a) / (weight_a * at_a - at_b);
    if (slow >= most_slow_steps || !(std::min(a, b) < c && c < std::max(a, b)))
      c = 0.5 * (a + b);
    const double at_c = missing_at(c);
    if (at_c * at_b < 0) {
      a = b;
      at_a = at_b;
      solved_a = std::move(solved_b);
      weight_a = 1;
      side = 0;
    } else if (++side > 0)
      weight_a *= 0.5;
    b = c;
    at_b = at_c;
    solved_b = forces.solved();
    if (std::abs(b - a) < 0.5 * width)
      slow = -1;
  }
  return true;
}

double first_step(const CreepageForces& forces, bool near, double creepage) {
  return near ? near_creepage_step * std::max(std::abs(creepage), forces.unit())
              : first_creepage_step * forces.unit();
}

bool find_one(CreepageForces& forces, int unknown, double wanted, double tolerance, bool near, Vector2d& w) {
  const auto missing_at = [&](double v) {
    w[unknown] = v;
    return wanted - forces.at(w)[unknown];
  };
  return find_root(forces, missing_at, w[unknown], first_step(forces, near, w[unknown]), tolerance);
}

/// Two unknowns, one within the other: for each creepage along s the one along x that gives its force. This
/// is slow, but each force grows with its creepage, so that it ends where Newton's method does not.
bool find_nested(CreepageForces& forces, const Vector2d& wanted, double tolerance, Vector2d& w) {
  bool inner = true, near = false;
  const auto missing_at = [&](double v) {
    w[1] = v;
    inner = find_one(forces, 0, wanted[0], 0.5 * tolerance, near, w) && inner;
    near = true;
    return inner ? wanted[1] - forces.last()[1] : std::numeric_limits<double>::quiet_NaN(); // ends the search
  };
  return find_root(forces, missing_at, w[1], first_step(forces, false, w[1]), 0.5 * tolerance) && inner;
}

/// Two unknowns: Newton with finite differences; if it stops, the slow but sure find_nested().
bool find_both(CreepageForces& forces, const Vector2d& wanted, double tolerance, Vector2d& w) {
  const Vector2d start = w;
  Vector2d missing = wanted - forces.at(w);
  for (int k = 0, stops = 0;
       k < most_creepage_newton && stops < most_creepage_stops && missing.norm() > tolerance; ++k) {
    const double reach = std::max(w.norm(), first_creepage_step * forces.unit());
    Matrix2d jacobian;
    for (int c = 0; c < 2; ++c) {
      Vector2d moved = w;
      const double h = (missing[c] < 0 ? -creepage_difference : creepage_difference) * reach;
      moved[c] += h;
      jacobian.col(c) = (missing - wanted + forces.at(moved)) / h;
    }
    Vector2d step = jacobian.fullPivLu().solve(missing);
    if (!step.allFinite() || step.dot(missing) <= 0)
      step = reach * missing.normalized();
    if (step.norm() > longest_creepage_step * reach)
      step *= longest_creepage_step * reach / step.norm();
    double length = 1;
    Vector2d best = missing, best_w = w;
    for (int halving = 0; halving < creepage_halvings; ++halving, length *= 0.5) {
      const Vector2d trial = w + length * step, there = wanted - forces.at(trial);
      if (there.norm() < best.norm()) {
        best = there;
        best_w = trial;
      }
      if (there.norm() < (1 - creepage_decrease * length) * missing.norm())
        break;
    }
    if (best_w == w) { // deep in full slip the forces hardly depend on the creepages
      best_w *= 0.5;
      ++stops;
    }
    w = best_w;
    missing = wanted - forces.at(w);
  }
  if (missing.norm() <= tolerance)
    return true;
  w = start;
  return find_nested(forces, wanted, tolerance, w);
}

/// A start that is the solution already takes no step and tells no compliance.
void keep_known(double value, double& kept) {
  if (std::isfinite(value))
    kept = value;
}

} // namespace

void solve_friction(const TangentialSystem& system, const SolverOptions& options, WorkBudget& work,
                    TangentialTask& task, TangentialState& state, FoundCreepage& creepage) {
  const ContactProblem& problem = *system.problem;
  std::vector<int> unknown;
  Vector2d wanted = Vector2d::Zero(), w(creepage.x, creepage.s);
  if (problem.force_x) {
    unknown.push_back(0);
    wanted[0] = *problem.force_x;
  }
  if (problem.force_s) {
    unknown.push_back(1);
    wanted[1] = *problem.force_s;
  }
  if (unknown.empty()) {
    solve_with_kinetic_friction(system, options, work, task, state);
    return;
  }
  CreepageForces forces(system, options, work, task, state);
  creepage.capacity = forces.capacity();
  creepage.beyond = forces.demand(wanted) >= 1 - rounding_of_capacity;
  if (creepage.beyond) {
    if (!task.contact.empty())
      forces.slip_along(wanted);
    creepage.reached = false;
    return;
  }
  if (!creepage.near && !task.contact.empty()) {
    const Vector2d near = forces.of_no_mean_slip();
    for (const int k : unknown)
      w[k] = near[k];
  }
  const double tolerance = settling_factor * options.tolerance * forces.capacity();
  if (const auto found = forces.find(unknown, wanted, tolerance, w)) {
    creepage.reached = true;
    w = found->creepage;
    keep_known(found->compliance[0], creepage.compliance_x);
    keep_known(found->compliance[1], creepage.compliance_s);
  } else
    creepage.reached = unknown.size() == 1
                           ? find_one(forces, unknown[0], wanted[unknown[0]], tolerance, creepage.near, w)
                           : find_both(forces, wanted, tolerance, w);
  if (creepage.reached) {
    creepage.x = w[0];
    creepage.s = w[1];
  }
  creepage.near = true;
  creepage.iterations += forces.solves();
  if (!creepage.reached)
    state.remark +=
        fmt::format("creepages: the forces prescribed were not reached in {} trials; ", forces.solves());
}

} // namespace bem_contact::contact
