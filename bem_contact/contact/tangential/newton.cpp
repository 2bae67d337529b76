#include "bem_contact/contact/tangential/linearise.hpp"
#include "bem_contact/influence/dense.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace bem_contact::contact {
namespace {

using Eigen::Matrix2d;
using Eigen::Matrix2f;
using Eigen::MatrixXd;
using Eigen::Vector2f;
using Eigen::VectorXd;
using Eigen::VectorXf;

/// Up to this many elements in contact the dense factorization is faster than GMRES.
constexpr int dense_limit = 120;
/// Above this many the dense matrix is not even a fall-back.
constexpr int dense_memory_limit = 3000;

/// The eigenvalue of M along the boundary of the friction disc above which slip counts as sticking there.
constexpr double directed = 0.7;
/// A step that leaves more of the residual is helped on in its worst rows.
constexpr double slow = 0.3;
/// GMRES: the most products.
constexpr int most_products = 250;

/// Unknowns in the order of the contact list: [x, s] of the first element, of the second, ...
struct Compressed {
  const TangentialSystem& system;
  const TangentialTask& task;
  const MatrixXd* matrix = nullptr; ///< B of a contact of few elements; else
  StepBox* box = nullptr;
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
  /// B v
  void step(const VectorXd& v, VectorXd& result) const {
    if (matrix) {
      result.noalias() = *matrix * v;
      return;
    }
    const int n = box->box.size();
    std::fill(box->in.begin(), box->in.end(), 0.0);
    for (int a = 0; a < unknowns() / 2; ++a) {
      box->in[local[a]] = v[2 * a];
      box->in[n + local[a]] = v[2 * a + 1];
    }
    box->step();
    result.resize(unknowns());
    for (int a = 0; a < unknowns() / 2; ++a) {
      result[2 * a] = box->out[local[a]];
      result[2 * a + 1] = box->out[n + local[a]];
    }
  }
  /// work.hpp; a turn of GMRES is a product and the preconditioner, which is translational.
  double product_work() const {
    return matrix ? task.contact.size() : system.product_work(box->box.rows()) * box->box.size();
  }
  double gmres_work() const { return box ? product_work() + 2.0 * box->box.size() : 0; }
};

/// The Newton matrix of one linearisation and about its inverse, in single precision, for GMRES. An element's
/// M is the identity where it sticks and m t t' where it slips, t along its bound. What sticks nearly (m
/// above `directed`) counts as sticking along t.
class FastJacobian {
public:
  FastJacobian(const Compressed& c, const Linearisation& at) : c_(c), box_(*c.box), n_(box_.box.size()) {
    double slipping = 0, sum = 0, stiffness = 0;
    box_.elements.clear();
    for (std::size_t a = 0; a < c.local.size(); ++a) {
      const double m = std::min(at.projection[a].trace(), 2.0);
      const auto r = static_cast<float>(c.stiffness[a]);
      box_.sticks[c.local[a]] = m > directed;
      sticking_ = sticking_ || m > directed;
      box_.elements.push_back({at.projection[a].cast<float>(), r, static_cast<float>(m), 0});
      stiffness += r;
      if (m <= directed) {
        slipping += 1;
        sum += m;
      }
    }
    if (!(sum > 0))
      return;
    // (1 - m)/m + r B, scaled from both sides to the mean of the first
    const double mean = std::max(sum / slipping, 1e-3), shift = (1 - mean) / mean;
    for (StepBox::Element& e : box_.elements)
      if (e.m <= directed)
        e.scale = static_cast<float>(std::sqrt(shift * e.m / (1 - e.m)));
    damped_ = true;
    box_.set_damping(shift, stiffness / c.local.size());
  }

  /// J v = v - M (v - r B v)
  void apply(const VectorXf& v, VectorXf& result) const {
    clear();
    for (std::size_t a = 0; a < c_.local.size(); ++a)
      put(a, v.segment<2>(2 * a));
    box_.fast_step();
    for (std::size_t a = 0; a < c_.local.size(); ++a) {
      const Vector2f here = v.segment<2>(2 * a);
      const StepBox::Element& e = box_.elements[a];
      result.segment<2>(2 * a) = here - e.projection * (here - e.stiffness * get(a));
    }
  }

  /// About J^-1 v: r B inverted where it sticks, the damped matrix where it slips; across the bound J is the
  /// identity.
  void precondition(const VectorXf& v, VectorXf& result) const {
    result = v;
    for (std::size_t a = 0; a < c_.local.size(); ++a)
      if (const StepBox::Element& e = box_.elements[a]; e.m >= 2)
        result.segment<2>(2 * a).setZero();
      else if (e.m > 0)
        result.segment<2>(2 * a) -= e.projection * v.segment<2>(2 * a) / e.m;
    if (sticking_) {
      clear();
      for (std::size_t a = 0; a < c_.local.size(); ++a)
        if (const StepBox::Element& e = box_.elements[a]; e.m > directed)
          put(a, e.m >= 2 ? Vector2f(v.segment<2>(2 * a) / e.stiffness)
                          : Vector2f(e.projection * v.segment<2>(2 * a) / (e.m * e.m * e.stiffness)));
      box_.invert();
      for (std::size_t a = 0; a < c_.local.size(); ++a)
        if (const StepBox::Element& e = box_.elements[a]; e.m >= 2)
          result.segment<2>(2 * a) = get(a);
        else if (e.m > directed)
          result.segment<2>(2 * a) += e.projection * get(a) / e.m;
    }
    if (!damped_)
      return;
    clear();
    for (std::size_t a = 0; a < c_.local.size(); ++a)
      if (const StepBox::Element& e = box_.elements[a]; e.scale > 0)
        put(a, e.scale / (e.m * e.m) * (e.projection * v.segment<2>(2 * a)));
    box_.invert_damped();
    for (std::size_t a = 0; a < c_.local.size(); ++a)
      if (const StepBox::Element& e = box_.elements[a]; e.scale > 0)
        result.segment<2>(2 * a) += e.scale / e.m * (e.projection * get(a));
  }

private:
  void clear() const { std::fill(box_.fast_in.begin(), box_.fast_in.end(), 0.0f); }
  void put(std::size_t a, const Vector2f& v) const {
    box_.fast_in[c_.local[a]] = v[0];
    box_.fast_in[n_ + c_.local[a]] = v[1];
  }
  Vector2f get(std::size_t a) const { return {box_.fast_out[c_.local[a]], box_.fast_out[n_ + c_.local[a]]}; }

  const Compressed& c_;
  StepBox& box_;
  std::size_t n_;
  bool sticking_ = false, damped_ = false;
};

MatrixXd dense_jacobian(const Compressed& c, const Linearisation& at) {
  MatrixXd jacobian = c.matrix ? *c.matrix : step_matrix(c.system, c.task.contact);
  for (int a = 0; a < c.unknowns() / 2; ++a) {
    auto rows = jacobian.middleRows<2>(2 * a);
    rows = (c.stiffness[a] * at.projection[a] * rows).eval();
    jacobian.block<2, 2>(2 * a, 2 * a) += Matrix2d::Identity() - at.projection[a];
  }
  return jacobian;
}

VectorXd newton_step(const Compressed& c, const Linearisation& at, double tolerance, TangentialState& state) {
  const int elements = c.unknowns() / 2;
  if (!c.matrix) {
    VectorXd step;
    const FastJacobian jacobian(c, at);
    const auto apply = [&](const VectorXf& v, VectorXf& result) { jacobian.apply(v, result); };
    const auto inverse = [&](const VectorXf& v, VectorXf& result) { jacobian.precondition(v, result); };
    const bool enough = c.box->gmres.solve(apply, inverse, -at.residual, tolerance, most_products, step);
    state.products += c.box->gmres.products();
    if (enough || elements > dense_memory_limit) {
      state.solver = "Newton, GMRES";
      return step;
    }
  }
  state.solver = "Newton, LU";
  MatrixXd jacobian = dense_jacobian(c, at), step = -at.residual;
  if (!solve_lu(jacobian, step))
    step.setConstant(std::nan(""));
  return step.col(0);
}

} // namespace

void newton(const TangentialSystem& system, const TangentialTask& task, const SolverOptions& options,
            TangentialState& state) {
  Compressed c{system, task, nullptr, nullptr, {}, {}, {}};
  if (static_cast<int>(task.contact.size()) <= dense_limit) {
    c.matrix = &system.matrix_for(task.contact);
  } else {
    c.box = &system.box_for(task.contact);
    c.local = c.box->box.local(task.contact, system.problem->grid.mx);
    std::fill(c.box->sticks.begin(), c.box->sticks.end(), 0);
  }
  c.stiffness.resize(c.unknowns() / 2);
  c.bound.resize(c.unknowns() / 2);
  for (std::size_t a = 0; a < task.contact.size(); ++a) {
    c.stiffness[a] = system.stiffness[task.contact[a]];
    c.bound[a] = task.bound[task.contact[a]];
  }
  const VectorXd drive = c.gather(task.drive);
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
    const int before_step = state.products;
    const VectorXd step = newton_step(c, at, forcing, state);
    system.spend(2.0 * c.product_work() + (state.products - before_step) * c.gmres_work());
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
    if (at.residual.norm() > slow * before &&
        sweep_rows(system, task.contact, c.stiffness, c.bound, slip, at, trial)) {
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
  state.slip = c.scatter(slip);
  if (!state.converged)
    state.remark += "Newton: no answer in " + std::to_string(steps) + " steps; ";
}

} // namespace bem_contact::contact
