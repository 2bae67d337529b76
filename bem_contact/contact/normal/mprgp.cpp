#include "bem_contact/contact/normal/mprgp.hpp"

#include "bem_contact/contact/normal/settings.hpp"
#include "bem_contact/contact/operator/norm_bound.hpp"
#include "bem_contact/contact/operator/settings.hpp"

#include <algorithm>
#include <limits>

namespace bem_contact::contact {
namespace {

using Eigen::VectorXd;

/// The iterate and its gradient A p - b, split into the free part (where p > 0) and the chopped part (where
/// p = 0 and the gradient asks for pressure, or p is at its limit and the gradient asks for less).
class Iterate {
public:
  Iterate(const NormalSystem& system, const VectorXd& b, WorkBudget& work, VectorXd& p)
      : system_(system), b_(b), work_(work), p_(p), free(b.size()), chopped(b.size()) {
    p_ = p_.cwiseMax(0.0).cwiseMin(system_.limit);
    evaluate();
  }
  /// g = A p - b anew.
  void evaluate() {
    g = system_.apply(p_, work_) - b_;
    split();
  }
  /// p -= step d, where A d = a.
  void move(double step, const VectorXd& d, const VectorXd& a) {
    p_ -= step * d;
    g -= step * a;
    split();
  }
  double largest() const { return std::max(free.cwiseAbs().maxCoeff(), chopped.cwiseAbs().maxCoeff()); }
  /// Whether the free gradient, reduced to what a step of fixed length can use, outweighs the chopped one.
  bool proportional(double fixed_step) const {
    double reduced = 0;
    for (Eigen::Index i = 0; i < p_.size(); ++i)
      if (is_free(i)) {
        const double room = (free[i] > 0 ? p_[i] : system_.limit - p_[i]) / fixed_step;
        reduced += std::abs(free[i]) * std::min(room, std::abs(free[i]));
      }
    return chopped.squaredNorm() <= reduced;
  }
  /// The longest step along -d that keeps p within its bounds.
  double feasible_step(const VectorXd& d) const {
    double feasible = std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i < p_.size(); ++i)
      if (d[i] > 0)
        feasible = std::min(feasible, p_[i] / d[i]);
      else if (d[i] < 0)
        feasible = std::min(feasible, (p_[i] - system_.limit) / d[i]);
    return feasible;
  }
  void project_step(double fixed_step) {
    p_ = (p_ - fixed_step * free).cwiseMax(0.0).cwiseMin(system_.limit);
  }

private:
  bool is_free(Eigen::Index i) const { return p_[i] > 0 && p_[i] < system_.limit; }
  void split() {
    for (Eigen::Index i = 0; i < p_.size(); ++i) {
      free[i] = is_free(i) ? g[i] : 0.0;
      chopped[i] = is_free(i) ? 0.0 : p_[i] > 0 ? std::max(g[i], 0.0) : std::min(g[i], 0.0);
    }
  }
  const NormalSystem& system_;
  const VectorXd& b_;
  WorkBudget& work_;
  VectorXd& p_;

public:
  VectorXd g, free, chopped;
};

} // namespace

MprgpOutcome solve_mprgp(const NormalSystem& system, const VectorXd& b, double tolerance, int most,
                         WorkBudget& work, VectorXd& p) {
  const double fixed_step =
      mprgp_step / norm_bound(b.size(), [&](const VectorXd& v) { return system.apply(v, work); });
  const double scale = std::max(b.cwiseAbs().maxCoeff(), std::numeric_limits<double>::min());
  Iterate at(system, b, work, p);
  MprgpOutcome outcome{power_iterations + 1};
  VectorXd d = at.free;
  while (outcome.products < most) {
    if (at.largest() <= tolerance * scale) {
      outcome.converged = true;
      break;
    }
    const bool proportional = at.proportional(fixed_step);
    const VectorXd direction = proportional ? d : at.chopped;
    const VectorXd a = system.apply(direction, work);
    ++outcome.products;
    const double curvature = direction.dot(a);
    if (!(curvature > 0))
      break;
    const double step = at.g.dot(direction) / curvature;
    const double feasible = at.feasible_step(direction);
    if (!proportional) {
      at.move(std::min(step, feasible), direction, a);
      d = at.free;
      continue;
    }
    if (step <= feasible) {
      at.move(step, direction, a);
      d = at.free - (at.free.dot(a) / curvature) * d;
      continue;
    }
    at.move(feasible, direction, a);
    at.project_step(fixed_step);
    at.evaluate();
    ++outcome.products;
    d = at.free;
  }
  return outcome;
}

} // namespace bem_contact::contact
