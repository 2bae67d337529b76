#include "bem_contact/contact/normal.hpp"

#include "bem_contact/contact/dense.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bem_contact::contact {
namespace {

using Eigen::VectorXd;

/// Up to this many elements a Cholesky factorization is faster than two runs of conjugate gradients.
constexpr int dense_limit = 250;

std::vector<int> indices_of(const std::vector<char>& active) {
  std::vector<int> list;
  for (std::size_t i = 0; i < active.size(); ++i)
    if (active[i])
      list.push_back(static_cast<int>(i));
  return list;
}

Eigen::MatrixXd dense_block(const NormalSystem& system, const std::vector<int>& list) {
  const int n = static_cast<int>(list.size()), mx = system.grid.mx;
  Eigen::MatrixXd matrix(n, n);
  for (int b = 0; b < n; ++b)
    for (int a = b; a < n; ++a)
      matrix(a, b) = system.numbers->at(std::abs(list[a] % mx - list[b] % mx), list[a] / mx, component_n,
                                        list[b] / mx, component_n);
  return matrix;
}

/// A_CC y = right-hand side on the active elements (zero elsewhere), starting from y. False when it fails.
bool conjugate_gradients(const NormalSystem& system, const std::vector<int>& list, const VectorXd& rhs,
                         VectorXd& y, double tolerance) {
  const auto restricted = [&list](const VectorXd& v) {
    VectorXd r = VectorXd::Zero(v.size());
    for (const int i : list)
      r[i] = v[i];
    return r;
  };
  const VectorXd b = restricted(rhs);
  y = restricted(y);
  VectorXd r = b - restricted(system.apply(y)), d = r;
  double rho = r.squaredNorm();
  const double target = tolerance * tolerance * b.squaredNorm();
  const int most = 50 + 4 * static_cast<int>(list.size());
  for (int k = 0; k < most && rho > target; ++k) {
    const VectorXd q = restricted(system.apply(d));
    const double curvature = d.dot(q);
    if (!(curvature > 0))
      return false;
    const double alpha = rho / curvature;
    y += alpha * d;
    r -= alpha * q;
    const double next = r.squaredNorm();
    d = r + (next / rho) * d;
    rho = next;
  }
  return rho <= target;
}

/// Solutions of A_CC y = cos and A_CC y = -gap, whence p = q y_cos + y_gap for every approach q.
struct TwoSolutions {
  VectorXd cosine, gap;
};

bool solve_on(const NormalSystem& system, const std::vector<int>& list, const VectorXd& gap,
              TwoSolutions& y) {
  if (static_cast<int>(list.size()) > dense_limit)
    return conjugate_gradients(system, list, system.cosine, y.cosine, 1e-12) &&
           conjugate_gradients(system, list, -gap, y.gap, 1e-12);
  Eigen::MatrixXd rhs(list.size(), 2);
  for (std::size_t a = 0; a < list.size(); ++a)
    rhs.row(a) << system.cosine[list[a]], -gap[list[a]];
  Eigen::MatrixXd matrix = dense_block(system, list);
  if (!solve_cholesky(matrix, rhs))
    return false;
  y.cosine.setZero();
  y.gap.setZero();
  for (std::size_t a = 0; a < list.size(); ++a) {
    y.cosine[list[a]] = rhs(a, 0);
    y.gap[list[a]] = rhs(a, 1);
  }
  return true;
}

/// The elements that overlap at the approach at which they, uniformly loaded, would carry the force.
std::vector<char> first_guess(const NormalSystem& system, const VectorXd& gap, const NormalLoad& load) {
  const int n = static_cast<int>(gap.size());
  const auto overlapping = [&](double q) {
    std::vector<char> active(n);
    for (int i = 0; i < n; ++i)
      active[i] = gap[i] - q * system.cosine[i] < 0;
    return active;
  };
  if (load.kind == LoadKind::approach)
    return overlapping(load.approach);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (int i = 0; i < n; ++i)
    if (system.cosine[i] > 1e-6) {
      low = std::min(low, gap[i] / system.cosine[i]);
      high = std::max(high, gap[i] / system.cosine[i]);
    }
  // an element alone under the whole force lies beyond every answer
  high = std::max(high, low + load.force / system.element_area * system.self) + 1e-12 * std::abs(low);
  for (int step = 0; step < 30; ++step) {
    const double q = 0.5 * (low + high);
    const std::vector<char> active = overlapping(q);
    VectorXd one = VectorXd::Zero(n);
    double overlap = 0, cosines = 0;
    for (int i = 0; i < n; ++i)
      if (active[i]) {
        one[i] = 1;
        overlap += q * system.cosine[i] - gap[i];
        cosines += system.cosine[i];
      }
    const double compliance = one.dot(system.apply(one));
    const double carried = compliance > 0 ? overlap / compliance * cosines * system.element_area : 0;
    (carried < load.force ? low : high) = q;
  }
  return overlapping(high);
}

} // namespace

NormalSystem::NormalSystem(const ContactGrid& the_grid, const InfluenceNumbers& the_numbers,
                           std::span<const ContactRow> rows, double area)
    : grid(the_grid), numbers(&the_numbers), nn(the_numbers, the_grid.mx, {component_n}, {component_n}),
      cosine(the_grid.size()), element_area(area) {
  for (int is = 0; is < grid.ms; ++is) {
    cosine.segment(is * grid.mx, grid.mx).setConstant(std::cos(rows[is].delta));
    self = std::max(self, numbers->at(0, is, component_n, is, component_n));
  }
}

VectorXd NormalSystem::apply(const VectorXd& p) const {
  VectorXd u(p.size());
  nn.apply({p.data(), static_cast<std::size_t>(p.size())}, {u.data(), static_cast<std::size_t>(u.size())});
  return u;
}

void solve_normal(const NormalSystem& system, const VectorXd& gap, const NormalLoad& load,
                  const SolverOptions& options, NormalState& state) {
  const int n = static_cast<int>(gap.size());
  state.converged = false;
  state.p = VectorXd::Zero(n);
  state.approach = load.approach;
  state.solver = "active set";
  if (load.kind == LoadKind::force && load.force <= 0) {
    state.active.assign(n, 0);
    state.solver = "none";
    state.converged = load.force == 0;
    state.approach = 0;
    if (load.force < 0)
      state.remark = "the shear tractions alone carry more than the force prescribed";
    return;
  }
  if (state.active.size() != static_cast<std::size_t>(n) ||
      std::none_of(state.active.begin(), state.active.end(), [](char a) { return a != 0; }))
    state.active = first_guess(system, gap, load);

  TwoSolutions y{VectorXd::Zero(n), VectorXd::Zero(n)};
  int fewest = n + 1, without_progress = 0;
  for (int step = 0; step < options.max_normal; ++step) {
    const std::vector<int> list = indices_of(state.active);
    ++state.iterations;
    if (list.empty() && load.kind == LoadKind::force)
      break;
    if (!solve_on(system, list, gap, y)) {
      state.remark = "active set: a linear system was not positive definite";
      break;
    }
    const double q =
        load.kind == LoadKind::approach
            ? load.approach
            : (load.force / system.element_area - system.cosine.dot(y.gap)) / system.cosine.dot(y.cosine);
    state.p = q * y.cosine + y.gap;
    state.approach = q;
    const VectorXd u = system.apply(state.p);
    const VectorXd e = gap - q * system.cosine + u;
    // rounding and the residual of the conjugate gradients must not change a set
    const double least_p = -1e-11 * state.p.cwiseAbs().maxCoeff();
    const double least_e = -1e-11 * u.cwiseAbs().maxCoeff();
    int changes = 0;
    for (int i = 0; i < n; ++i) {
      const bool wrong = state.active[i] ? state.p[i] < least_p : e[i] < least_e;
      if (wrong) {
        state.active[i] = !state.active[i];
        ++changes;
      }
    }
    if (changes == 0) {
      state.converged = true;
      break;
    }
    without_progress = changes < fewest ? 0 : without_progress + 1;
    fewest = std::min(fewest, changes);
    if (without_progress >= 12) {
      state.remark = "active set: the sets cycled";
      break;
    }
  }
  if (!state.converged) {
    if (state.remark.empty())
      state.remark = "active set: no answer in " + std::to_string(options.max_normal) + " steps";
    solve_normal_safely(system, gap, load, options, state);
  }
  state.p = state.p.cwiseMax(0.0);
  for (int i = 0; i < n; ++i)
    state.active[i] = state.p[i] > 0;
}

} // namespace bem_contact::contact
