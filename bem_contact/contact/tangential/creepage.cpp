#include "bem_contact/contact/tangential/creepage.hpp"

#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace bem_contact::contact {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::VectorXd;

/// Static and kinetic friction: all at the static bound first; what slips, slips at the kinetic one from
/// then on. The set of those only grows, so this ends.
void solve_bounds(const TangentialSystem& system, const SolverOptions& options, TangentialTask& task,
                  TangentialState& state) {
  const double kinetic = system.problem->kinetic;
  if (kinetic == 1) {
    solve_tangential(system, task, options, state);
    return;
  }
  const int n = system.size();
  std::vector<char> slipped(n, 0);
  for (bool grown = true; grown;) {
    solve_tangential(system, task, options, state);
    const double scale = largest_slip(task.rigid, task.contact, state.slip, task.slip_floor);
    grown = false;
    for (const int i : task.contact)
      if (!slipped[i] && std::hypot(state.p[i], state.p[n + i]) > (1 - 1e-7) * task.bound[i] &&
          std::hypot(state.slip[i], state.slip[n + i]) > 1e-7 * scale) {
        slipped[i] = 1;
        task.bound[i] *= kinetic;
        grown = true;
      }
  }
}

/// The forces as a function of the creepages, each with the tangential problem solved.
class Forces {
public:
  Forces(const TangentialSystem& system, const SolverOptions& options, TangentialTask& task,
         TangentialState& state)
      : system_(system), options_(options), task_(task), state_(state), given_(task) {
    const ContactProblem& problem = *system.problem;
    const int n = system.size(), mx = problem.grid.mx;
    share_.resize(n);
    for (int i = 0; i < n; ++i)
      share_[i] = problem.lateral_share(i / mx);
    for (const int i : task.contact)
      capacity_ += task.bound[i] * problem.element_area();
  }

  /// Leaves task and state as solved for these creepages. N
  Vector2d at(const Vector2d& creepage) {
    const int n = system_.size();
    task_ = given_;
    const double length = system_.rule.length;
    for (int i = 0; i < n; ++i) {
      task_.rigid[i] += creepage[0] * length;
      task_.rigid[n + i] += creepage[1] * length * share_[i];
      task_.drive[i] += creepage[0] * length;
      task_.drive[n + i] += creepage[1] * length * share_[i];
    }
    solve_bounds(system_, options_, task_, state_);
    ++solves_;
    last_ = system_.problem->element_area() * Vector2d(state_.p.head(n).sum(), state_.p.tail(n).dot(share_));
    return last_;
  }
  const Vector2d& last() const { return last_; } ///< as found by the last at()

  /// What the last at() left behind.
  struct Solved {
    VectorXd p, slip;
    Vector2d force;
  };
  Solved solved() const { return {state_.p, state_.slip, last_}; }

  /// Between the solutions at two creepages that are as good as one: (1 - share) of the one and `share` of
  /// the other. Where they differ all but sticks, so that this is a solution too.
  void blend(const Solved& one, const Solved& other, double share) {
    state_.p = (1 - share) * one.p + share * other.p;
    state_.slip = (1 - share) * one.slip + share * other.slip;
    last_ = (1 - share) * one.force + share * other.force;
  }
  bool may_blend() const { return system_.problem->kinetic == 1; }

  /// The largest of F d over the unit vectors d, where F is a force prescribed and friction carries at most
  /// sum mu p_n |(d_x, d_s share)| dS along d. Over 1: it cannot be carried.
  double demand(const Vector2d& force) const {
    constexpr int directions = 720;
    const double area = system_.problem->element_area();
    double largest = 0;
    for (int k = 0; k <= directions; ++k) {
      Vector2d d = force.normalized();
      if (k < directions)
        d = {std::cos(2 * std::numbers::pi * k / directions),
             std::sin(2 * std::numbers::pi * k / directions)};
      double carried = 0;
      for (const int i : given_.contact)
        carried += given_.bound[i] * area * std::hypot(d[0], d[1] * share_[i]);
      largest = std::max(largest, force.dot(d) / carried);
    }
    return largest;
  }

  /// Everything slips along the force.
  void slip_along(const Vector2d& force) {
    const int n = system_.size();
    const Vector2d d = force.normalized();
    for (const int i : given_.contact) {
      state_.p[i] = given_.bound[i] * d[0];
      state_.p[n + i] = given_.bound[i] * d[1];
    }
  }

  double capacity() const { return capacity_; }
  int solves() const { return solves_; }
  /// The creepage whose slip over one step is what an element alone needs to reach its bound.
  double unit() const {
    double slip = 0;
    for (const int i : given_.contact)
      slip = std::max(slip, given_.bound[i] / system_.stiffness[i]);
    return slip / system_.rule.length;
  }

private:
  const TangentialSystem& system_;
  const SolverOptions& options_;
  TangentialTask& task_;
  TangentialState& state_;
  TangentialTask given_;
  VectorXd share_;
  Vector2d last_ = Vector2d::Zero();
  double capacity_ = 0;
  int solves_ = 0;
};

/// One unknown: secants until the force is bracketed, then Illinois' rule, with bisection where that is slow.
/// Where little sticks the force is nearly a staircase; steps that are too steep to stand on, as friction
/// vanishes, are met by tractions between those of their two ends. The last call of `missing_at` is the one
/// at the result.
template <class Function>
bool find_root(Forces& forces, const Function& missing_at, double start, double step, double tolerance) {
  constexpr int most = 120;
  constexpr double farthest = 1e12; // where all slips no force depends on the creepage
  constexpr double steep = 1e-11;   // of the creepage: far below what tells adhesion from slip
  int calls = 1;
  double a = start, at_a = missing_at(a), b = a, at_b = at_a;
  Forces::Solved solved_a = forces.solved(), solved_b = solved_a;
  while (std::abs(at_b) > tolerance && at_a * at_b > 0) {
    if (++calls > most || std::abs(b) > farthest)
      return false;
    if (b != a) {
      const double secant = (b - a) * at_b / (at_a - at_b); // infinite where everything slips
      a = b;
      at_a = at_b;
      step = std::clamp(std::isfinite(secant) ? 1.2 * std::abs(secant) : 10 * step, step, 10 * step);
    }
    solved_a = std::move(solved_b);
    b = a + (at_a > 0 ? step : -step);
    at_b = missing_at(b);
    solved_b = forces.solved();
  }
  double weight_a = 1;
  for (int side = 0, slow = 0; std::abs(at_b) > tolerance; ++slow) {
    if (++calls > most)
      return false;
    const double width = std::abs(b - a);
    if (width <= steep * std::max(std::abs(a), std::abs(b)) && forces.may_blend()) {
      forces.blend(solved_a, solved_b, at_a / (at_a - at_b));
      return true;
    }
    double c = (weight_a * at_a * b - at_b * a) / (weight_a * at_a - at_b);
    if (slow >= 3 || !(std::min(a, b) < c && c < std::max(a, b)))
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

double first_step(const Forces& forces, bool near, double creepage) {
  return near ? 1e-3 * std::max(std::abs(creepage), forces.unit()) : 10 * forces.unit();
}

bool find_one(Forces& forces, int unknown, double wanted, double tolerance, bool near, Vector2d& w) {
  const auto missing_at = [&](double v) {
    w[unknown] = v;
    return wanted - forces.at(w)[unknown];
  };
  return find_root(forces, missing_at, w[unknown], first_step(forces, near, w[unknown]), tolerance);
}

/// Two unknowns, one within the other: for each creepage along s the one along x that gives its force. Slow,
/// but the forces grow with their creepages, so it ends where Newton's method does not.
bool find_nested(Forces& forces, const Vector2d& wanted, double tolerance, Vector2d& w) {
  bool inner = true, near = false;
  const auto missing_at = [&](double v) {
    w[1] = v;
    inner = find_one(forces, 0, wanted[0], 0.5 * tolerance, near, w) && inner;
    near = true;
    return inner ? wanted[1] - forces.last()[1] : std::numeric_limits<double>::quiet_NaN(); // ends the search
  };
  return find_root(forces, missing_at, w[1], first_step(forces, false, w[1]), 0.5 * tolerance) && inner;
}

/// Two unknowns: Newton with finite differences, and what is slow but sure where it stops.
bool find_both(Forces& forces, const Vector2d& wanted, double tolerance, Vector2d& w) {
  constexpr int most = 40, most_stops = 4;
  const Vector2d start = w;
  Vector2d missing = wanted - forces.at(w);
  for (int k = 0, stops = 0; k < most && stops < most_stops && missing.norm() > tolerance; ++k) {
    const double reach = std::max(w.norm(), 10 * forces.unit());
    Matrix2d jacobian;
    for (int c = 0; c < 2; ++c) {
      Vector2d moved = w;
      const double h = (missing[c] < 0 ? -1e-3 : 1e-3) * reach;
      moved[c] += h;
      jacobian.col(c) = (missing - wanted + forces.at(moved)) / h;
    }
    Vector2d step = jacobian.fullPivLu().solve(missing);
    if (!step.allFinite() || step.dot(missing) <= 0)
      step = reach * missing.normalized();
    if (step.norm() > 2 * reach)
      step *= 2 * reach / step.norm();
    double length = 1;
    Vector2d best = missing, best_w = w;
    for (int halving = 0; halving < 10; ++halving, length *= 0.5) {
      const Vector2d trial = w + length * step, there = wanted - forces.at(trial);
      if (there.norm() < best.norm()) {
        best = there;
        best_w = trial;
      }
      if (there.norm() < (1 - 1e-3 * length) * missing.norm())
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

} // namespace

void solve_friction(const TangentialSystem& system, const SolverOptions& options, TangentialTask& task,
                    TangentialState& state, Creepage& creepage) {
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
    solve_bounds(system, options, task, state);
    return;
  }
  Forces forces(system, options, task, state);
  creepage.capacity = forces.capacity();
  creepage.beyond = forces.demand(wanted) >= 1 - 1e-9;
  if (creepage.beyond) {
    if (!task.contact.empty())
      forces.slip_along(wanted);
    creepage.reached = false;
    return;
  }
  const double tolerance = 10 * options.tolerance * forces.capacity();
  creepage.reached = unknown.size() == 1 ? find_one(forces, unknown[0], wanted[unknown[0]], tolerance,
                                                    creepage.iterations > 0, w)
                                         : find_both(forces, wanted, tolerance, w);
  if (creepage.reached) {
    creepage.x = w[0];
    creepage.s = w[1];
  }
  creepage.iterations += forces.solves();
  if (!creepage.reached)
    state.remark +=
        fmt::format("creepages: the forces prescribed were not reached in {} trials; ", forces.solves());
}

} // namespace bem_contact::contact
