#include "bem_contact/contact/dense.hpp"
#include "bem_contact/contact/friction.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <functional>

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

/// Unknowns in the order of the contact list: [x, s] of the first element, of the second, ...
struct Compressed {
  const TangentialSystem& system;
  const TangentialTask& task;

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
};

/// F = p - Proj(p + r S) and the derivative M of the projection, element by element.
struct Linearisation {
  VectorXd residual;
  std::vector<Matrix2d> projection;
};

Linearisation linearise(const Compressed& c, const VectorXd& p, const VectorXd& slip) {
  const int n = c.unknowns() / 2;
  Linearisation result{VectorXd(2 * n), std::vector<Matrix2d>(n)};
  for (int a = 0; a < n; ++a) {
    const int i = c.task.contact[a];
    const double bound = c.task.bound[i];
    const Vector2d z = p.segment<2>(2 * a) + c.system.stiffness[i] * slip.segment<2>(2 * a);
    const double length = z.norm();
    if (length <= bound) {
      result.residual.segment<2>(2 * a) = p.segment<2>(2 * a) - z;
      result.projection[a] = Matrix2d::Identity();
    } else {
      const Vector2d direction = z / length;
      result.residual.segment<2>(2 * a) = p.segment<2>(2 * a) - bound * direction;
      result.projection[a] = bound / length * (Matrix2d::Identity() - direction * direction.transpose());
    }
  }
  return result;
}

/// J v = v - M (v - r B v)
VectorXd apply_jacobian(const Compressed& c, const Linearisation& at, const VectorXd& v) {
  const VectorXd step = c.gather(c.system.step(c.scatter(v)));
  VectorXd result = v;
  for (int a = 0; a < c.unknowns() / 2; ++a)
    result.segment<2>(2 * a) -=
        at.projection[a] *
        (v.segment<2>(2 * a) - c.system.stiffness[c.task.contact[a]] * step.segment<2>(2 * a));
  return result;
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

/// Restarted GMRES (Saad, Schultz 1986). True when the residual fell to tolerance * |rhs|.
bool gmres(const std::function<VectorXd(const VectorXd&)>& apply, const VectorXd& rhs, double tolerance,
           int restart, int most, VectorXd& x) {
  x = VectorXd::Zero(rhs.size());
  const double target = tolerance * rhs.norm();
  VectorXd r = rhs;
  for (int done = 0; done < most;) {
    const double beta = r.norm();
    if (beta <= target)
      return true;
    MatrixXd basis(rhs.size(), restart + 1), h = MatrixXd::Zero(restart + 1, restart);
    VectorXd g = VectorXd::Zero(restart + 1), cosine(restart), sine(restart);
    basis.col(0) = r / beta;
    g[0] = beta;
    int k = 0;
    while (k < restart && done < most && std::abs(g[k]) > target) {
      VectorXd w = apply(basis.col(k));
      ++done;
      for (int pass = 0; pass < 2; ++pass) {
        const VectorXd overlap = basis.leftCols(k + 1).transpose() * w;
        h.col(k).head(k + 1) += overlap;
        w -= basis.leftCols(k + 1) * overlap;
      }
      const double length = w.norm();
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
      basis.col(k) = w / length;
    }
    if (k == 0)
      return false;
    x += basis.leftCols(k) * h.topLeftCorner(k, k).triangularView<Eigen::Upper>().solve(g.head(k));
    r = rhs - apply(x);
  }
  return r.norm() <= target;
}

VectorXd newton_step(const Compressed& c, const Linearisation& at, std::string& solver) {
  const int elements = c.unknowns() / 2;
  if (elements > dense_limit) {
    VectorXd step;
    const auto apply = [&](const VectorXd& v) { return apply_jacobian(c, at, v); };
    if (gmres(apply, -at.residual, 1e-4, 150, 450, step) || elements > dense_memory_limit) {
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
  const Compressed c{system, task};
  const VectorXd drive = c.gather(task.drive);
  const auto slip_of = [&](const VectorXd& p) {
    return VectorXd(drive - c.gather(system.step(c.scatter(p))));
  };
  VectorXd p = c.gather(state.p), slip = slip_of(p);
  Linearisation at = linearise(c, p, slip);
  int failed_searches = 0, steps = 0;
  state.converged = false;
  for (int k = 0; k <= options.max_tangential; ++k) {
    state.violation = coulomb_violation(system, task, c.scatter(p), c.scatter(slip));
    state.converged = state.violation <= options.tolerance;
    if (state.converged || k == options.max_tangential || failed_searches >= 6)
      break;
    ++state.iterations;
    ++steps;
    const VectorXd step = newton_step(c, at, state.solver);
    if (!step.allFinite())
      break;
    const VectorXd step_slip = -c.gather(system.step(c.scatter(step)));
    double length = 1;
    const double before = at.residual.norm();
    bool decreased = false;
    for (int halving = 0; halving < 6 && !decreased; ++halving, length *= 0.5) {
      const VectorXd trial = p + length * step, trial_slip = slip + length * step_slip;
      Linearisation there = linearise(c, trial, trial_slip);
      decreased = there.residual.norm() < (1 - 1e-4 * length) * before;
      if (decreased || halving == 5) {
        p = trial;
        slip = trial_slip;
        at = std::move(there);
      }
    }
    failed_searches += !decreased;
  }
  state.p = c.scatter(p);
  state.slip = task.drive - system.step(state.p);
  if (!state.converged)
    state.remark += "Newton: no answer in " + std::to_string(steps) + " steps; ";
}

} // namespace bem_contact::contact
