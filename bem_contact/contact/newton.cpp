#include "bem_contact/contact/dense.hpp"
#include "bem_contact/contact/linearise.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace bem_contact::contact {
namespace {

using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

/// Up to this many elements in contact the dense factorization is faster than GMRES.
constexpr int dense_limit = 120;
/// Above this many the dense matrix is not even a fall-back.
constexpr int dense_memory_limit = 3000;

/// The eigenvalue of M along the boundary of the friction disc above which slip counts as sticking there.
constexpr double directed = 0.7;
/// GMRES: the most products.
constexpr int most_products = 250;

/// Unknowns in the order of the contact list: [x, s] of the first element, of the second, ...
struct Compressed {
  const TangentialSystem& system;
  const TangentialTask& task;
  StepBox& box;
  std::vector<int> local; ///< numbers of the elements in the box
  VectorXd stiffness, bound;

  int unknowns() const { return 2 * static_cast<int>(task.contact.size()); }
  VectorXd gather(const VectorXd& field) const {
    VectorXd v(unknowns());
    for (int a = 0; a < unknowns() / 2; ++a) {
      v[2 * a] = field[task.contact[a]];
      v[2 * a + 1] = field[system.size() + task.contact[a]];
    }
    return v;
  }
  VectorXd scatter(const VectorXd& v) const {
    VectorXd field = VectorXd::Zero(2 * system.size());
    for (int a = 0; a < unknowns() / 2; ++a) {
      field[task.contact[a]] = v[2 * a];
      field[system.size() + task.contact[a]] = v[2 * a + 1];
    }
    return field;
  }
  /// B v, or about B^-1 v on box.sticks
  template <class Apply> void in_box(Apply apply, const VectorXd& v, VectorXd& result) const {
    const int n = box.box.size();
    std::fill(box.in.begin(), box.in.end(), 0.0);
    for (int a = 0; a < unknowns() / 2; ++a) {
      box.in[local[a]] = v[2 * a];
      box.in[n + local[a]] = v[2 * a + 1];
    }
    apply();
    result.resize(unknowns());
    for (int a = 0; a < unknowns() / 2; ++a) {
      result[2 * a] = box.out[local[a]];
      result[2 * a + 1] = box.out[n + local[a]];
    }
  }
  void step(const VectorXd& v, VectorXd& result) const {
    in_box([this] { box.step(); }, v, result);
  }
  void inverse(const VectorXd& v, VectorXd& result) const {
    in_box([this] { box.invert(); }, v, result);
  }
};

/// J v = v - M (v - r B v)
void apply_jacobian(const Compressed& c, const Linearisation& at, const VectorXd& v, VectorXd& result) {
  c.step(v, result);
  for (int a = 0; a < c.unknowns() / 2; ++a)
    result.segment<2>(2 * a) =
        v.segment<2>(2 * a) -
        at.projection[a] * (v.segment<2>(2 * a) - c.stiffness[a] * result.segment<2>(2 * a));
}

/// About J^-1 v. Where M is (nearly) the identity, in one direction or both, J is r B. In the other
/// directions J is diagonal.
void precondition(const Compressed& c, const Linearisation& at, const VectorXd& v, VectorXd& result) {
  VectorXd kept(v.size());
  const int n = c.unknowns() / 2;
  for (int a = 0; a < n; ++a) {
    const double m = at.projection[a].trace();
    c.box.sticks[c.local[a]] = m > directed;
    if (m >= 2)
      kept.segment<2>(2 * a) = v.segment<2>(2 * a) / c.stiffness[a];
    else if (m > directed)
      kept.segment<2>(2 * a) = at.projection[a] * v.segment<2>(2 * a) / (m * m * c.stiffness[a]);
    else
      kept.segment<2>(2 * a).setZero();
  }
  c.inverse(kept, result);
  for (int a = 0; a < n; ++a) {
    const double m = at.projection[a].trace();
    if (m >= 2)
      continue;
    const Vector2d w = v.segment<2>(2 * a), tangential = at.projection[a] * w / m;
    if (m > directed)
      result.segment<2>(2 * a) = w - tangential + at.projection[a] * result.segment<2>(2 * a) / m;
    else
      result.segment<2>(2 * a) = w - tangential + tangential / (1 - m + m * 0.3);
  }
}

MatrixXd dense_jacobian(const Compressed& c, const Linearisation& at) {
  const int n = c.unknowns() / 2, mx = c.system.problem->grid.mx;
  const StepNumbers& numbers = c.system.step_numbers();
  MatrixXd jacobian(2 * n, 2 * n);
  for (int b = 0; b < n; ++b) {
    const int load_x = c.task.contact[b] % mx, load_row = c.task.contact[b] / mx;
    for (int a = 0; a < n; ++a) {
      const int i = c.task.contact[a];
      Matrix2d block;
      for (int k = 0; k < 2; ++k)
        for (int l = 0; l < 2; ++l)
          block(k, l) = numbers.line(i % mx, i / mx, k, load_row, l)[load_x];
      block = at.projection[a] * (c.system.stiffness[i] * block);
      if (a == b)
        block += Matrix2d::Identity() - at.projection[a];
      jacobian.block<2, 2>(2 * a, 2 * b) = block;
    }
  }
  return jacobian;
}

/// GMRES (Saad, Schultz 1986), preconditioned from the right. True when the residual fell to
/// tolerance * |rhs|; x is the best there is in any case.
class Gmres {
public:
  template <class Apply, class Precondition>
  bool solve(const Apply& apply, const Precondition& precondition, const VectorXd& rhs, double tolerance,
             int most, VectorXd& x) {
    const double beta = rhs.norm(), target = tolerance * beta;
    x.setZero(rhs.size());
    if (beta == 0)
      return true;
    basis_.clear();
    basis_.push_back(rhs / beta);
    MatrixXd h = MatrixXd::Zero(most + 1, most);
    VectorXd g = VectorXd::Zero(most + 1), cosine(most), sine(most);
    g[0] = beta;
    int k = 0;
    while (k < most && std::abs(g[k]) > target) {
      precondition(basis_[k], z_);
      apply(z_, w_);
      for (int i = 0; i <= k; ++i) {
        h(i, k) = basis_[i].dot(w_);
        w_ -= h(i, k) * basis_[i];
      }
      const double length = w_.norm();
      for (int i = 0; i < k; ++i) {
        const double upper = h(i, k), lower = h(i + 1, k);
        h(i, k) = cosine[i] * upper + sine[i] * lower;
        h(i + 1, k) = cosine[i] * lower - sine[i] * upper;
      }
      const double diagonal = std::hypot(h(k, k), length);
      if (!(diagonal > 0))
        break;
      cosine[k] = h(k, k) / diagonal;
      sine[k] = length / diagonal;
      h(k, k) = diagonal;
      g[k + 1] = -sine[k] * g[k];
      g[k] *= cosine[k];
      ++k;
      if (!(length > 1e-14 * diagonal))
        break;
      basis_.push_back(w_ / length);
    }
    if (k == 0)
      return false;
    const VectorXd y = h.topLeftCorner(k, k).triangularView<Eigen::Upper>().solve(g.head(k));
    w_.setZero(rhs.size());
    for (int i = 0; i < k; ++i)
      w_ += y[i] * basis_[i];
    precondition(w_, x);
    return std::abs(g[k]) <= target;
  }

private:
  std::vector<VectorXd> basis_;
  VectorXd z_, w_;
};

VectorXd newton_step(const Compressed& c, const Linearisation& at, Gmres& gmres, double tolerance,
                     std::string& solver) {
  const int elements = c.unknowns() / 2;
  if (elements > dense_limit) {
    VectorXd step;
    const auto apply = [&](const VectorXd& v, VectorXd& result) { apply_jacobian(c, at, v, result); };
    const auto inverse = [&](const VectorXd& v, VectorXd& result) { precondition(c, at, v, result); };
    if (gmres.solve(apply, inverse, -at.residual, tolerance, most_products, step) ||
        elements > dense_memory_limit) {
      solver = "Newton, GMRES";
      return step;
    }
  }
  solver = "Newton, LU";
  MatrixXd jacobian = dense_jacobian(c, at), step = -at.residual;
  if (!solve_lu(jacobian, step))
    step.setConstant(std::nan(""));
  return step.col(0);
}

} // namespace

void newton(const TangentialSystem& system, const TangentialTask& task, const SolverOptions& options,
            TangentialState& state) {
  StepBox& box = system.box_for(task.contact);
  std::fill(box.sticks.begin(), box.sticks.end(), 0);
  Compressed c{system, task, box, box.box.local(task.contact, system.problem->grid.mx), {}, {}};
  c.stiffness.resize(c.unknowns() / 2);
  c.bound.resize(c.unknowns() / 2);
  for (std::size_t a = 0; a < task.contact.size(); ++a) {
    c.stiffness[a] = system.stiffness[task.contact[a]];
    c.bound[a] = task.bound[task.contact[a]];
  }
  const VectorXd drive = c.gather(task.drive);
  Gmres gmres;
  VectorXd p = c.gather(state.p), slip, step_slip;
  c.step(p, slip);
  slip = drive - slip;
  Linearisation at = linearise(c.stiffness, c.bound, p, slip);
  int failed_searches = 0, steps = 0;
  double last = 1;
  state.converged = false;
  for (int k = 0; k <= options.max_tangential; ++k) {
    state.violation = coulomb_violation(system, task, c.scatter(p), c.scatter(slip));
    state.converged = state.violation <= options.tolerance;
    if (state.converged || k == options.max_tangential || failed_searches >= 6)
      break;
    ++state.iterations;
    ++steps;
    // no more precise than the states are known: quadratic convergence shows when they are
    const double before = at.residual.norm();
    const double ratio = k == 0 ? 1 : before / last;
    const double enough = std::min(0.1, 0.2 * options.tolerance / state.violation);
    const double forcing = std::clamp(0.3 * ratio * ratio, std::max(1e-4, enough), 1e-1);
    last = before;
    const VectorXd step = newton_step(c, at, gmres, forcing, state.solver);
    if (!step.allFinite())
      break;
    c.step(step, step_slip);
    step_slip = -step_slip;
    double length = 1;
    bool decreased = false;
    for (int halving = 0; halving < 6 && !decreased; ++halving, length *= 0.5) {
      const VectorXd trial = p + length * step, trial_slip = slip + length * step_slip;
      Linearisation there = linearise(c.stiffness, c.bound, trial, trial_slip);
      decreased = there.residual.norm() < (1 - 1e-4 * length) * before;
      if (decreased || halving == 5) {
        p = trial;
        slip = trial_slip;
        at = std::move(there);
      }
    }
    failed_searches += !decreased;
    VectorXd trial = p;
    if (newton_on_rows(system, task.contact, c.stiffness, c.bound, slip, at, trial)) {
      c.step(trial, step_slip);
      step_slip = drive - step_slip;
      Linearisation there = linearise(c.stiffness, c.bound, trial, step_slip);
      if (there.residual.norm() < at.residual.norm()) {
        p = trial;
        slip = step_slip;
        at = std::move(there);
      }
    }
  }
  state.p = c.scatter(p);
  c.step(p, slip);
  state.slip = c.scatter(drive - slip);
  if (!state.converged)
    state.remark += "Newton: no answer in " + std::to_string(steps) + " steps; ";
}

} // namespace bem_contact::contact
