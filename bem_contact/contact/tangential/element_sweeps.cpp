#include "bem_contact/contact/tangential/element_sweeps.hpp"

#include "bem_contact/contact/tangential/settings.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace bem_contact::contact {

using Eigen::Map;
using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::VectorXd;

/// If it slips: (B + lambda) p = c, lambda > 0 by the iteration of More and Sorensen 1983.
Vector2d solve_element(const Matrix2d& b, const Vector2d& c, double bound) {
  Vector2d p = b.inverse() * c;
  if (!(bound > 0))
    return Vector2d::Zero();
  if (p.norm() <= bound)
    return p;
  double lambda = 0, low = 0, high = c.norm() / bound;
  for (int k = 0; k < most_element_steps; ++k) {
    const Matrix2d inverse = (b + lambda * Matrix2d::Identity()).inverse();
    p = inverse * c;
    const double length = p.norm();
    if (std::abs(length - bound) <= element_precision * bound)
      break;
    (length > bound ? low : high) = lambda;
    lambda += (length - bound) / bound * length * length / p.dot(inverse * p);
    if (!(lambda > low && lambda < high))
      lambda = 0.5 * (low + high);
  }
  return bound / p.norm() * p;
}

namespace {

/// 1 / stiffness. Damping of the first sweep over all elements, and where it has become too slow to go on.
/// Undamped sweeps diverge; more is needed on finer grids. Chosen.
constexpr double first_element_damping = 3;
constexpr double largest_element_damping = 200;
/// Sweeps after which the damping is doubled unless this share or less of the violation is left. Chosen.
constexpr int sweeps_per_damping = 40;
constexpr double sweeps_enough = 0.3;

/// The tractions during the sweeps; only the elements in contact carry.
class Sweeps {
public:
  Sweeps(const TangentialSystem& system, const TangentialTask& task, const VectorXd& start)
      : system_(system), task_(task), numbers_(system.step_numbers()), order_(task.contact),
        first_(system.problem->grid.ms, system.columns()), last_(first_.size(), -1),
        p_(VectorXd::Zero(2 * system.size())) {
    const int mx = system.columns(), n = system.size();
    // From the leading edge, at +x: what has rolled in first is solved first.
    std::stable_sort(order_.begin(), order_.end(), [mx](int a, int b) { return a % mx > b % mx; });
    for (const int i : task.contact) {
      first_[i / mx] = std::min(first_[i / mx], i % mx);
      last_[i / mx] = std::max(last_[i / mx], i % mx);
      p_[i] = start[i];
      p_[n + i] = start[n + i];
    }
  }

  /// One sweep over all elements; `damping` is added to the self number, in units of 1 / stiffness.
  void sweep(double damping) {
    const int mx = system_.columns(), n = system_.size();
    for (const int i : order_) {
      const int ix = i % mx, is = i / mx;
      Matrix2d self;
      for (int c = 0; c < 2; ++c)
        for (int d = 0; d < 2; ++d)
          self(c, d) = numbers_.line(ix, is, c, is, d)[ix];
      self += damping / system_.stiffness[i] * Matrix2d::Identity();
      const Vector2d next =
          solve_element(self, slip_of(i) + self * Vector2d(p_[i], p_[n + i]), task_.bound[i]);
      p_[i] = next[0];
      p_[n + i] = next[1];
    }
  }
  const VectorXd& tractions() const { return p_; }

private:
  Vector2d slip_of(int i) const {
    const int mx = system_.columns(), n = system_.size(), ix = i % mx, is = i / mx;
    Vector2d slip(task_.drive[i], task_.drive[n + i]);
    for (int js = 0; js < static_cast<int>(first_.size()); ++js) {
      const int from = first_[js], count = last_[js] - from + 1;
      if (count <= 0)
        continue;
      for (int c = 0; c < 2; ++c)
        for (int d = 0; d < 2; ++d)
          slip[c] -= Map<const VectorXd>(numbers_.line(ix, is, c, js, d) + from, count)
                         .dot(p_.segment(d * n + js * mx + from, count));
    }
    return slip;
  }

  const TangentialSystem& system_;
  const TangentialTask& task_;
  const StepNumbers& numbers_;
  std::vector<int> order_, first_, last_; ///< first and last column in contact of each row
  VectorXd p_;
};

} // namespace

void sweep_elements(const TangentialSystem& system, const TangentialTask& task, double tolerance, int most,
                    WorkBudget& work, TangentialState& state) {
  Sweeps sweeps(system, task, state.p);
  state.converged = false;
  state.solver = "sweeps";
  // The elements of a column drive each other, so that undamped sweeps diverge. How much damping is enough
  // grows with the grid.
  double damping = first_element_damping, before = 1;
  for (int sweep = 0; sweep < most && !state.converged && damping < largest_element_damping; ++sweep) {
    ++state.iterations;
    work.spend(sweep_work(static_cast<double>(task.contact.size())));
    sweeps.sweep(damping);
    if (!sweeps.tractions().allFinite())
      break;
    state.p = sweeps.tractions();
    judge(system, task, tolerance, work, state);
    if (sweep % sweeps_per_damping == sweeps_per_damping - 1) {
      if (!(state.violation < sweeps_enough * before))
        damping *= 2;
      before = state.violation;
    }
  }
}

} // namespace bem_contact::contact
