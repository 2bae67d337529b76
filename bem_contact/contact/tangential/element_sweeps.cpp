#include "bem_contact/contact/tangential/linearise.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bem_contact::contact {

using Eigen::Map;
using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::VectorXd;

/// Where it slips (B + lambda) p = c, lambda > 0 by the iteration of More and Sorensen 1983.
Vector2d solve_element(const Matrix2d& b, const Vector2d& c, double bound) {
  Vector2d p = b.inverse() * c;
  if (!(bound > 0))
    return Vector2d::Zero();
  if (p.norm() <= bound)
    return p;
  double lambda = 0, low = 0, high = c.norm() / bound;
  for (int k = 0; k < 60; ++k) {
    const Matrix2d inverse = (b + lambda * Matrix2d::Identity()).inverse();
    p = inverse * c;
    const double length = p.norm();
    if (std::abs(length - bound) <= 1e-13 * bound)
      break;
    (length > bound ? low : high) = lambda;
    lambda += (length - bound) / bound * length * length / p.dot(inverse * p);
    if (!(lambda > low && lambda < high))
      lambda = 0.5 * (low + high);
  }
  return bound / p.norm() * p;
}

void sweeps(const TangentialSystem& system, const TangentialTask& task, double tolerance, int most,
            TangentialState& state) {
  const int mx = system.problem->grid.mx, ms = system.problem->grid.ms, n = system.size();
  const StepNumbers& numbers = system.step_numbers();
  // what has rolled in first: the leading edge is at +x
  std::vector<int> order = task.contact;
  std::stable_sort(order.begin(), order.end(), [mx](int a, int b) { return a % mx > b % mx; });
  std::vector<int> first(ms, mx), last(ms, -1);
  VectorXd p = VectorXd::Zero(2 * n);
  for (const int i : task.contact) {
    first[i / mx] = std::min(first[i / mx], i % mx);
    last[i / mx] = std::max(last[i / mx], i % mx);
    p[i] = state.p[i];
    p[n + i] = state.p[n + i];
  }
  state.converged = false;
  state.solver = "sweeps";
  // The elements of a column drive each other; undamped sweeps diverge. What is enough grows with the grid.
  constexpr int patience = 40;
  double damping = 3, before = 1;
  for (int sweep = 0; sweep < most && !state.converged && damping < 200; ++sweep) {
    ++state.iterations;
    system.spend(sweep_work(static_cast<double>(order.size())));
    for (const int i : order) {
      const int ix = i % mx, is = i / mx;
      Vector2d slip(task.drive[i], task.drive[n + i]);
      for (int js = 0; js < ms; ++js) {
        const int from = first[js], count = last[js] - from + 1;
        if (count <= 0)
          continue;
        for (int c = 0; c < 2; ++c)
          for (int d = 0; d < 2; ++d)
            slip[c] -= Map<const VectorXd>(numbers.line(ix, is, c, js, d) + from, count)
                           .dot(p.segment(d * n + js * mx + from, count));
      }
      Matrix2d self;
      for (int c = 0; c < 2; ++c)
        for (int d = 0; d < 2; ++d)
          self(c, d) = numbers.line(ix, is, c, is, d)[ix];
      self += damping / system.stiffness[i] * Matrix2d::Identity();
      const Vector2d next = solve_element(self, slip + self * Vector2d(p[i], p[n + i]), task.bound[i]);
      p[i] = next[0];
      p[n + i] = next[1];
    }
    if (!p.allFinite())
      break;
    state.p = p;
    state.slip = task.drive - system.step(p);
    state.violation = coulomb_violation(system, task, state.p, state.slip);
    state.converged = state.violation <= tolerance;
    if (sweep % patience == patience - 1) {
      if (!(state.violation < 0.3 * before))
        damping *= 2;
      before = state.violation;
    }
  }
}

} // namespace bem_contact::contact
