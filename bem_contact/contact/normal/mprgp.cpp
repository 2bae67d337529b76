#include "bem_contact/contact/normal/normal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bem_contact::contact {
namespace {

using Eigen::VectorXd;

/// Upper bound of A's largest eigenvalue (power iteration with a margin; the start has no zero component).
double norm_of(const NormalSystem& system) {
  VectorXd v = VectorXd::LinSpaced(system.cosine.size(), 1.0, 1.5);
  double norm = 0;
  for (int k = 0; k < 20; ++k) {
    v.normalize();
    v = system.apply(v);
    norm = v.norm();
  }
  return 1.2 * norm;
}

} // namespace

int solve_mprgp(const NormalSystem& system, const VectorXd& b, double tolerance, int most, VectorXd& p,
                bool& converged) {
  const Eigen::Index n = b.size();
  const double fixed_step = 1.9 / norm_of(system);
  const double scale = std::max(b.cwiseAbs().maxCoeff(), std::numeric_limits<double>::min());
  p = p.cwiseMax(0.0);
  VectorXd g = system.apply(p) - b, free(n), chopped(n);
  int products = 21;
  const auto split = [&] {
    for (Eigen::Index i = 0; i < n; ++i) {
      free[i] = p[i] > 0 ? g[i] : 0.0;
      chopped[i] = p[i] > 0 ? 0.0 : std::min(g[i], 0.0);
    }
  };
  split();
  VectorXd d = free;
  converged = false;
  while (products < most) {
    if (std::max(free.cwiseAbs().maxCoeff(), chopped.cwiseAbs().maxCoeff()) <= tolerance * scale) {
      converged = true;
      break;
    }
    // the free gradient reduced to what a step of fixed length can use
    double reduced = 0;
    for (Eigen::Index i = 0; i < n; ++i)
      if (p[i] > 0)
        reduced += free[i] * std::min(p[i] / fixed_step, free[i]);
    const bool proportional = chopped.squaredNorm() <= reduced;
    const VectorXd direction = proportional ? d : chopped;
    const VectorXd a = system.apply(direction);
    ++products;
    const double curvature = direction.dot(a);
    if (!(curvature > 0))
      break;
    const double step = g.dot(direction) / curvature;
    if (!proportional) {
      p -= step * direction;
      g -= step * a;
      split();
      d = free;
      continue;
    }
    double feasible = std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i < n; ++i)
      if (direction[i] > 0)
        feasible = std::min(feasible, p[i] / direction[i]);
    if (step <= feasible) {
      p -= step * direction;
      g -= step * a;
      split();
      d = free - (free.dot(a) / curvature) * d;
    } else {
      p -= feasible * direction;
      g -= feasible * a;
      split();
      p = (p - fixed_step * free).cwiseMax(0.0);
      g = system.apply(p) - b;
      ++products;
      split();
      d = free;
    }
  }
  return products;
}

void solve_normal_safely(const NormalSystem& system, const VectorXd& gap, const NormalLoad& load,
                         const SolverOptions& options, NormalState& state) {
  const int most = 2000 + 20 * static_cast<int>(gap.size());
  const double tolerance = std::max(1e-3 * options.tolerance, 1e-12);
  state.solver = "MPRGP";
  state.p = VectorXd::Zero(gap.size());
  const auto force_at = [&](double q) {
    state.iterations +=
        solve_mprgp(system, q * system.cosine - gap, tolerance, most, state.p, state.converged);
    state.approach = q;
    return system.cosine.dot(state.p) * system.element_area;
  };
  if (load.kind == LoadKind::approach) {
    force_at(load.approach);
    return;
  }
  // The force grows with the approach. Bracket it, then the Illinois variant of regula falsi.
  double low = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < gap.size(); ++i)
    if (system.cosine[i] > 1e-6)
      low = std::min(low, gap[i] / system.cosine[i]);
  double step = load.force / system.element_area * system.self, high = low + 0.01 * step;
  double at_low = -load.force, at_high = force_at(high) - load.force;
  for (int k = 0; k < 60 && at_high < 0; ++k) {
    low = high;
    at_low = at_high;
    high += step *= 2;
    at_high = force_at(high) - load.force;
  }
  bool close = false;
  int last_side = 0; // the end kept twice running counts half
  for (int k = 0; k < 100 && !close; ++k) {
    const double q = high - at_high * (high - low) / (at_high - at_low);
    const double at_q = force_at(q) - load.force;
    close = std::abs(at_q) <= 0.1 * options.tolerance * load.force;
    if (at_q < 0) {
      low = q;
      at_low = at_q;
      at_high *= last_side < 0 ? 0.5 : 1.0;
      last_side = -1;
    } else {
      high = q;
      at_high = at_q;
      at_low *= last_side > 0 ? 0.5 : 1.0;
      last_side = 1;
    }
  }
  state.converged = state.converged && close;
}

} // namespace bem_contact::contact
