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

/// A_CC y = right-hand side on the active elements, starting from y; both fields. The residual falls below
/// `target` everywhere. False when it fails.
bool conjugate_gradients(const NormalSystem& system, const std::vector<int>& list, const VectorXd& rhs,
                         double target, VectorXd& y) {
  NormalBox& at = system.box_for(list);
  const std::vector<int> local = at.box.local(list, system.grid.mx);
  const auto count = static_cast<std::ptrdiff_t>(list.size());
  for (auto* v : {&at.x, &at.r, &at.z, &at.d})
    std::fill(v->begin(), v->end(), 0.0);
  for (std::ptrdiff_t a = 0; a < count; ++a)
    at.x[local[a]] = y[list[a]];
  at.nn.apply(at.x, at.q);
  double worst = 0;
  for (std::ptrdiff_t a = 0; a < count; ++a) {
    at.r[local[a]] = rhs[list[a]] - at.q[local[a]];
    worst = std::max(worst, std::abs(at.r[local[a]]));
  }
  double rho = 0;
  const int most = 50 + static_cast<int>(count);
  for (int k = 0; k < most && worst > target; ++k) {
    // z = r preconditioned, on the active elements; Polak-Ribiere's beta forgives what the FFT rounds
    at.inverse.apply(at.r, at.q, 0);
    double next = 0, overlap = 0;
    for (const int l : local) {
      next += at.r[l] * at.q[l];
      overlap += at.r[l] * at.z[l];
      at.z[l] = at.q[l];
    }
    if (!(next > 0))
      return false;
    const double beta = k == 0 ? 0 : std::max(0.0, (next - overlap) / rho);
    rho = next;
    for (const int l : local)
      at.d[l] = at.z[l] + beta * at.d[l];
    at.nn.apply(at.d, at.q);
    double curvature = 0;
    for (const int l : local)
      curvature += at.d[l] * at.q[l];
    if (!(curvature > 0))
      return false;
    const double alpha = rho / curvature;
    worst = 0;
    for (const int l : local) {
      at.x[l] += alpha * at.d[l];
      at.r[l] -= alpha * at.q[l];
      worst = std::max(worst, std::abs(at.r[l]));
    }
  }
  y.setZero();
  for (std::ptrdiff_t a = 0; a < count; ++a)
    y[list[a]] = at.x[local[a]];
  return worst <= target;
}

/// Solutions of A_CC y = q cos - gap and, where the force is given, A_CC unit = cos: what more approach adds.
struct Response {
  VectorXd p, unit;
};

/// `precision` is relative to the largest right-hand side.
bool solve_on(const NormalSystem& system, const std::vector<int>& list, const VectorXd& rhs, bool with_unit,
              double precision, Response& y) {
  if (static_cast<int>(list.size()) > dense_limit) {
    double largest = 0;
    for (const int i : list)
      largest = std::max(largest, std::abs(rhs[i]));
    // the unit response corrects a force that is nearly right, and need not be precise at first
    return conjugate_gradients(system, list, rhs, precision * largest, y.p) &&
           (!with_unit || conjugate_gradients(system, list, system.cosine, std::sqrt(precision), y.unit));
  }
  Eigen::MatrixXd right(list.size(), 2);
  for (std::size_t a = 0; a < list.size(); ++a)
    right.row(a) << rhs[list[a]], system.cosine[list[a]];
  Eigen::MatrixXd matrix = dense_block(system, list);
  if (!solve_cholesky(matrix, right))
    return false;
  y.p.setZero();
  y.unit.setZero();
  for (std::size_t a = 0; a < list.size(); ++a) {
    y.p[list[a]] = right(a, 0);
    y.unit[list[a]] = right(a, 1);
  }
  return true;
}

/// The elements that overlap at the approach at which they, uniformly loaded, would carry the force.
std::vector<char> first_guess(const NormalSystem& system, const VectorXd& gap, const NormalLoad& load,
                              double& approach) {
  const int n = static_cast<int>(gap.size());
  const auto overlapping = [&](double q) {
    std::vector<char> active(n);
    for (int i = 0; i < n; ++i)
      active[i] = gap[i] - q * system.cosine[i] < 0;
    return active;
  };
  if (load.kind == LoadKind::approach)
    return overlapping(load.approach);
  double low = std::numeric_limits<double>::infinity(), cosine = 1;
  for (int i = 0; i < n; ++i)
    if (system.cosine[i] > 1e-6 && gap[i] / system.cosine[i] < low) {
      low = gap[i] / system.cosine[i];
      cosine = system.cosine[i];
    }
  // The energy is convex in the force and at most that of this element alone: twice its approach lies beyond
  // every answer, however high the walls are.
  double high = low + 2 * load.force / (system.element_area * cosine * cosine) * system.self;
  high += 1e-12 * std::abs(low);
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
  approach = high;
  return overlapping(high);
}

} // namespace

NormalBox::NormalBox(const InfluenceNumbers& numbers, const Box& the_box)
    : box(the_box), nn(numbers, box.mx, {component_n}, {component_n}, {box.first_s, box.ms}),
      inverse(numbers, box.mx, box.ms, {component_n}, {component_n}, PlaneOperator::Form::periodic,
              box.first_s + box.ms / 2) {
  inverse.invert();
  for (auto* v : {&x, &r, &z, &d, &q})
    v->assign(box.size(), 0.0);
}

NormalBox& NormalSystem::box_for(const std::vector<int>& elements) const {
  if (!box_ || !box_->box.contains(box_around(elements, grid)))
    box_.emplace(*numbers, box_around(elements, grid, 1 + std::min(grid.mx, grid.ms) / 60));
  return *box_;
}

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
  const double start = state.approach;
  state.converged = false;
  state.approach = load.approach;
  state.solver = "active set";
  if (load.kind == LoadKind::force && load.force <= 0) {
    state.active.assign(n, 0);
    state.p.setZero(n);
    state.solver = "none";
    state.converged = load.force == 0;
    state.approach = 0;
    if (load.force < 0)
      state.remark = "the shear tractions alone carry more than the force prescribed";
    return;
  }
  const bool by_force = load.kind == LoadKind::force;
  double precision = std::clamp(1e-2 * options.tolerance, 1e-13, 1e-6);
  const double wanted = precision;
  if (state.active.size() != static_cast<std::size_t>(n) ||
      std::none_of(state.active.begin(), state.active.end(), [](char a) { return a != 0; })) {
    state.active = first_guess(system, gap, load, state.approach);
    state.p.setZero(n);
    precision = 1e-3;
  } else {
    precision = std::max(wanted, 1e-4);
    if (by_force)
      state.approach = start;
  }
  if (state.p.size() != n)
    state.p.setZero(n);

  Response y{state.p, VectorXd::Zero(n)};
  int fewest = n + 1, without_progress = 0;
  for (int step = 0; step < options.max_normal; ++step) {
    const std::vector<int> list = indices_of(state.active);
    ++state.iterations;
    if (list.empty() && by_force)
      break;
    const bool direct = static_cast<int>(list.size()) <= dense_limit;
    if (direct)
      precision = wanted;
    if (!solve_on(system, list, state.approach * system.cosine - gap, by_force, precision, y)) {
      state.remark = "active set: a linear system was not positive definite";
      break;
    }
    state.p = y.p;
    double moved = 0; // what more approach adds, of its own imprecise response
    if (by_force) {
      const double more =
          (load.force / system.element_area - system.cosine.dot(y.p)) / system.cosine.dot(y.unit);
      state.approach += more;
      state.p += more * y.unit;
      moved = direct ? 0 : std::abs(more) * std::sqrt(precision);
    }
    y.p = state.p;
    const VectorXd u = system.apply(state.p);
    const VectorXd e = gap - state.approach * system.cosine + u;
    // the residual of the conjugate gradients and rounding must not change a set
    const double largest_u = u.cwiseAbs().maxCoeff();
    const double least_p = -std::max(precision, 1e-11) * state.p.cwiseAbs().maxCoeff();
    const double least_e = -std::max(precision, 1e-11) * largest_u;
    int changes = 0;
    for (int i = 0; i < n; ++i) {
      const bool wrong = state.active[i] ? state.p[i] < least_p : e[i] < least_e;
      if (wrong) {
        state.active[i] = !state.active[i];
        ++changes;
      }
    }
    const bool precise = precision <= wanted && moved <= precision * largest_u;
    if (changes == 0 && precise) {
      state.converged = true;
      break;
    }
    // sets that hardly change are worth knowing better
    precision = changes == 0 ? wanted : std::max(wanted, std::min(precision, 1e-2 * changes / double(n)));
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
