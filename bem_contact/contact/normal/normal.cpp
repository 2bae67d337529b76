#include "bem_contact/contact/normal/normal.hpp"

#include "bem_contact/contact/prepared.hpp"
#include "bem_contact/influence/dense.hpp"

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

/// Solutions of A_CC y = q cos - gap and, where the force is given, A_CC unit = cos: what more approach adds.
struct Response {
  VectorXd p, unit, u, u_unit; ///< u = A p, where it is known
  Parts known;                 ///< nothing where it is not known at all
};

/// `precision` is relative to the largest right-hand side.
bool solve_on(const NormalSystem& system, const std::vector<int>& list, const VectorXd& rhs, bool with_unit,
              double precision, Response& y, int& products) {
  if (static_cast<int>(list.size()) > dense_limit) {
    double largest = 0;
    for (const int i : list)
      largest = std::max(largest, std::abs(rhs[i]));
    const Parts* box = conjugate_gradients(system, list, rhs, precision * largest, y.p, y.u, products);
    // the unit response corrects a force that is nearly right, and need not be precise at first
    if (box && with_unit)
      box =
          conjugate_gradients(system, list, system.cosine, std::sqrt(precision), y.unit, y.u_unit, products);
    if (box)
      y.known = *box;
    return box != nullptr;
  }
  y.known = {};
  Eigen::MatrixXd right(list.size(), 2);
  for (std::size_t a = 0; a < list.size(); ++a)
    right.row(a) << rhs[list[a]], system.cosine[list[a]];
  if (!system.solve_dense(list, right))
    return false;
  y.p.setZero();
  y.unit.setZero();
  for (std::size_t a = 0; a < list.size(); ++a) {
    y.p[list[a]] = right(a, 0);
    y.unit[list[a]] = right(a, 1);
  }
  return true;
}

/// What contradicts the law changes sides: pressure below `least_p`, penetration below `least_e`. Returns how
/// many elements did.
int change_sides(const NormalSystem& system, const VectorXd& gap, const VectorXd& u, const Parts& known,
                 double least_p, double least_e, NormalState& state) {
  int changes = 0;
  for (const Box& box : known.boxes)
    for (int is = box.first_s; is < box.first_s + box.ms; ++is)
      for (int ix = box.first_x; ix < box.first_x + box.mx; ++ix) {
        const int i = is * system.grid.mx + ix;
        const bool wrong = state.active[i] ? state.p[i] < least_p
                                           : gap[i] - state.approach * system.cosine[i] + u[i] < least_e;
        if (wrong) {
          state.active[i] = !state.active[i];
          ++changes;
        }
      }
  return changes;
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

NormalSystem::NormalSystem(const ContactGrid& the_grid, const InfluenceNumbers& the_numbers,
                           std::span<const ContactRow> rows, double area, Prepared* kept)
    : grid(the_grid), numbers(&the_numbers), cosine(the_grid.size()), element_area(area),
      own_(kept ? nullptr : std::make_unique<Prepared>()), kept_(kept ? kept : own_.get()) {
  for (int is = 0; is < grid.ms; ++is) {
    cosine.segment(is * grid.mx, grid.mx).setConstant(std::cos(rows[is].delta));
    self = std::max(self, numbers->at(0, is, component_n, is, component_n));
  }
}

NormalSystem::~NormalSystem() = default;

VectorXd NormalSystem::apply(const VectorXd& p) const {
  kept_->spend(0.5 * product_work(numbers->translational, grid.ms) * grid.size());
  VectorXd u(p.size());
  if (!kept_->nn) {
    spend(spectra_work(numbers->translational, 1, grid.ms, grid.mx));
    kept_->nn.emplace(*numbers, grid.mx, std::vector<int>{component_n}, std::vector<int>{component_n},
                      RowRange{}, kept_->pool.get());
  }
  kept_->nn->apply({p.data(), static_cast<std::size_t>(p.size())},
                   {u.data(), static_cast<std::size_t>(u.size())});
  return u;
}

const NormalLines& NormalSystem::lines() const {
  if (!kept_->normal_lines)
    kept_->normal_lines.emplace(*numbers, grid.mx);
  return *kept_->normal_lines;
}

VectorXd NormalSystem::apply_directly(const VectorXd& p) const {
  kept_->spend(grid.size());
  return lines().apply(p);
}

bool NormalSystem::solve_dense(const std::vector<int>& list, Eigen::MatrixXd& right) const {
  NormalFactor& kept = kept_->normal_factor;
  if (kept.list == list) {
    solve_factored(kept.factor, right);
    return true;
  }
  kept.list.clear();
  kept.factor = lines().block(list);
  const bool positive = solve_cholesky(kept.factor, right);
  if (positive)
    kept.list = list;
  return positive;
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
    state.u.setZero(n);
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

  const Parts whole{{{0, 0, system.grid.mx, system.grid.ms}}};
  Response y{state.p, VectorXd::Zero(n), VectorXd::Zero(n), VectorXd::Zero(n), {}};
  int fewest = n + 1, without_progress = 0;
  for (int step = 0; step < options.max_normal; ++step) {
    const std::vector<int> list = indices_of(state.active);
    ++state.iterations;
    if (list.empty() && by_force)
      break;
    const bool direct = static_cast<int>(list.size()) <= dense_limit;
    if (direct)
      precision = wanted;
    if (!solve_on(system, list, state.approach * system.cosine - gap, by_force, precision, y,
                  state.products)) {
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
      if (!direct)
        y.u += more * y.u_unit;
      moved = direct ? 0 : std::abs(more) * std::sqrt(precision);
    }
    y.p = state.p;
    if (direct) {
      y.u = system.apply_directly(state.p);
      y.known = whole;
    }
    // the residual of the conjugate gradients and rounding must not change a set
    double largest_u = 0;
    for (const int i : list)
      largest_u = std::max(largest_u, std::abs(y.u[i]));
    const double least_p = -std::max(precision, 1e-11) * state.p.cwiseAbs().maxCoeff();
    const double least_e = -std::max(precision, 1e-11) * largest_u;
    int changes = change_sides(system, gap, y.u, y.known, least_p, least_e, state);
    const bool precise = precision <= wanted && moved <= precision * largest_u;
    if (changes == 0 && precise && !direct) { // all is well in the box; and outside?
      y.u = system.apply(state.p);
      changes = change_sides(system, gap, y.u, whole, least_p, least_e, state);
    }
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
    y.u = system.apply(state.p);
  }
  state.u = y.u;
  state.p = state.p.cwiseMax(0.0);
  for (int i = 0; i < n; ++i)
    state.active[i] = state.p[i] > 0;
}

} // namespace bem_contact::contact
