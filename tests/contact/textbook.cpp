#include "tests/contact/textbook.hpp"

#include <Eigen/LU>

#include <cmath>
#include <vector>

namespace bem_contact::textbook {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd matrix(const ContactProblem& problem, std::vector<int> outputs, std::vector<int> inputs, bool step) {
  const int n = problem.grid.size();
  MatrixXd a(outputs.size() * n, inputs.size() * n);
  for (std::size_t c = 0; c < outputs.size(); ++c)
    for (std::size_t d = 0; d < inputs.size(); ++d)
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
          a(c * n + i, d * n + j) = step ? step_number(problem, i, outputs[c], j, inputs[d])
                                         : number(problem, i, outputs[c], j, inputs[d]);
  return a;
}

/// p and, where the force is given, q, for the elements of the set in contact: the others out one by one,
/// then the ones that penetrate in.
bool norm(const MatrixXd& a, const VectorXd& gap, const VectorXd& cosine, double force, bool by_force,
          std::vector<char>& set, VectorXd& p, double& q) {
  const int n = static_cast<int>(gap.size());
  for (int turn = 0; turn < 40 * n; ++turn) {
    std::vector<int> list;
    for (int i = 0; i < n; ++i)
      if (set[i])
        list.push_back(i);
    const int m = static_cast<int>(list.size());
    p.setZero(n);
    if (m > 0) {
      MatrixXd k = MatrixXd::Zero(m + by_force, m + by_force);
      VectorXd right(m + by_force);
      for (int r = 0; r < m; ++r) {
        for (int c = 0; c < m; ++c)
          k(r, c) = a(list[r], list[c]);
        right[r] = (by_force ? 0 : q * cosine[list[r]]) - gap[list[r]];
        if (by_force) {
          k(r, m) = -cosine[list[r]];
          k(m, r) = cosine[list[r]];
        }
      }
      if (by_force)
        right[m] = force;
      const VectorXd y = k.fullPivLu().solve(right);
      for (int r = 0; r < m; ++r)
        p[list[r]] = y[r];
      if (by_force)
        q = y[m];
    }
    int lowest = 0, deepest = 0;
    p.minCoeff(&lowest);
    if (p[lowest] < 0) {
      set[lowest] = 0;
      continue;
    }
    const VectorXd e = gap - q * cosine + a * p;
    for (int i = 1; i < n; ++i)
      if (!set[i] && (set[deepest] || e[i] < e[deepest]))
        deepest = i;
    if (set[deepest] || !(e[deepest] < -1e-13 * (a * p).cwiseAbs().maxCoeff()))
      return true;
    set[deepest] = 1;
  }
  return false;
}

/// Newton for given sets: S = 0 where it sticks; |p| = g and p parallel to S where it slips.
bool newton(const MatrixXd& b, const VectorXd& drive, const VectorXd& bound, const std::vector<int>& contact,
            const std::vector<char>& slips, VectorXd& p) {
  const int n = static_cast<int>(bound.size()), m = static_cast<int>(contact.size());
  const double scale = bound.maxCoeff(), slip_scale = drive.cwiseAbs().maxCoeff();
  for (int k = 0; k < 60; ++k) {
    const VectorXd s = drive - b * p;
    MatrixXd j = MatrixXd::Zero(2 * m, 2 * m);
    VectorXd f(2 * m);
    double wrong = 0;
    for (int r = 0; r < m; ++r) {
      const int i = contact[r];
      const double px = p[i] / scale, ps = p[n + i] / scale, g = bound[i] / scale;
      const double sx = s[i] / slip_scale, ss = s[n + i] / slip_scale;
      f[2 * r] = slips[i] ? px * px + ps * ps - g * g : sx;
      f[2 * r + 1] = slips[i] ? px * ss - ps * sx : ss;
      wrong = std::max({wrong, std::abs(f[2 * r]), std::abs(f[2 * r + 1])});
      for (int c = 0; c < m; ++c)
        for (int d = 0; d < 2; ++d) {
          const int l = d * n + contact[c];
          const double dsx = -b(i, l) * scale / slip_scale, dss = -b(n + i, l) * scale / slip_scale;
          j(2 * r, 2 * c + d) = slips[i] ? 0 : dsx;
          j(2 * r + 1, 2 * c + d) = slips[i] ? px * dss - ps * dsx : dss;
        }
      if (slips[i]) {
        j(2 * r, 2 * r) += 2 * px;
        j(2 * r, 2 * r + 1) += 2 * ps;
        j(2 * r + 1, 2 * r) += ss;
        j(2 * r + 1, 2 * r + 1) -= sx;
      }
    }
    if (wrong < 1e-13)
      return true;
    const VectorXd step = j.partialPivLu().solve(-f);
    if (!step.allFinite())
      return false;
    for (int r = 0; r < m; ++r) {
      p[contact[r]] += scale * step[2 * r];
      p[n + contact[r]] += scale * step[2 * r + 1];
    }
    if (step.norm() < 1e-13 * std::sqrt(2.0 * m))
      return true;
  }
  return false;
}

bool tang(const MatrixXd& b, const VectorXd& drive, const VectorXd& bound, std::vector<char>& slips,
          VectorXd& p) {
  const int n = static_cast<int>(bound.size());
  std::vector<int> contact;
  for (int i = 0; i < n; ++i)
    if (bound[i] > 0)
      contact.push_back(i);
    else
      p[i] = p[n + i] = 0;
  if (contact.empty())
    return true;
  for (int turn = 0; turn < 200; ++turn) {
    for (const int i : contact) {
      const double length = std::hypot(p[i], p[n + i]);
      if (slips[i] && length > 0) {
        p[i] *= bound[i] / length;
        p[n + i] *= bound[i] / length;
      }
    }
    if (!newton(b, drive, bound, contact, slips, p))
      return false;
    const VectorXd s = drive - b * p;
    bool changed = false;
    for (const int i : contact)
      if (!slips[i] && std::hypot(p[i], p[n + i]) > bound[i] * (1 + 1e-12)) {
        slips[i] = 1;
        changed = true;
      }
    if (changed)
      continue;
    for (const int i : contact)
      if (slips[i] && p[i] * s[i] + p[n + i] * s[n + i] < 0) {
        slips[i] = 0;
        changed = true;
      }
    if (!changed)
      return true;
  }
  return false;
}

/// NORM and TANG in turn.
Solution norm_and_tang(const Dense& d) {
  Solution out{VectorXd::Zero(d.n), VectorXd::Zero(2 * d.n), d.approach, false};
  std::vector<char> in_contact(d.n, 1), slips(d.n, 0);
  for (int turn = 0; turn < 200; ++turn) {
    const VectorXd before_n = out.pn, before_t = out.pt;
    const double force = d.force - d.sine.dot(out.pt.tail(d.n));
    if (!norm(d.nn, d.gap + d.nt * out.pt, d.cosine, force, d.by_force, in_contact, out.pn, out.approach))
      return out;
    const VectorXd bound = d.mu.cwiseProduct(out.pn);
    slips.assign(d.n, 0);
    if (!tang(d.tt, d.rigid - d.tn * out.pn, bound, slips, out.pt))
      return out;
    const double largest = out.pn.maxCoeff();
    if ((out.pn - before_n).cwiseAbs().maxCoeff() <= 1e-12 * largest &&
        (out.pt - before_t).cwiseAbs().maxCoeff() <= 1e-12 * largest) {
      out.found = true;
      return out;
    }
  }
  return out;
}

} // namespace

double number(const ContactProblem& problem, int target, int i, int load, int j, int ahead) {
  const int mx = problem.grid.mx, m = target % mx + ahead - load % mx;
  return (m < 0 ? parity(i, j) : 1) * problem.numbers.at(std::abs(m), target / mx, i, load / mx, j);
}

double step_number(const ContactProblem& problem, int target, int i, int load, int j) {
  if (problem.motion == MotionKind::shift)
    return number(problem, target, i, load, j);
  return 1.5 * number(problem, target, i, load, j) - 2 * number(problem, target, i, load, j, 1) +
         0.5 * number(problem, target, i, load, j, 2);
}

Dense::Dense(const ContactProblem& problem)
    : n(problem.grid.size()), by_force(problem.load == LoadKind::force),
      force(problem.force / problem.element_area()), approach(problem.approach), gap(n), cosine(n), sine(n),
      rigid(2 * n), mu(n) {
  const std::vector<int> shear{component_x, component_s}, normal{component_n};
  nn = matrix(problem, normal, normal, false);
  nt = matrix(problem, normal, shear, false);
  tt = matrix(problem, shear, shear, true);
  tn = matrix(problem, shear, normal, true);
  const double length = problem.motion == MotionKind::shift ? 1 : problem.grid.dx;
  for (int i = 0; i < n; ++i) {
    const int row = i / problem.grid.mx;
    gap[i] = problem.gap[i];
    cosine[i] = std::cos(problem.rows[row].delta);
    sine[i] = std::sin(problem.rows[row].delta);
    mu[i] = problem.friction_of(row);
    rigid[i] = problem.slip_x[i] * length;
    rigid[n + i] = problem.slip_s[i] * length;
  }
}

bool holds(const Dense& d, const Solution& s) {
  constexpr double tolerance = 1e-9;
  const VectorXd u = d.nn * s.pn + d.nt * s.pt, e = d.gap - s.approach * d.cosine + u;
  const VectorXd slip = d.rigid - d.tt * s.pt - d.tn * s.pn;
  const double pressure = s.pn.cwiseAbs().maxCoeff(), distance = std::max(u.cwiseAbs().maxCoeff(), 1e-300);
  if (d.by_force && !(std::abs(d.cosine.dot(s.pn) + d.sine.dot(s.pt.tail(d.n)) - d.force) <=
                      tolerance * (d.force + pressure)))
    return false;
  double largest_slip = (d.tt * s.pt).cwiseAbs().maxCoeff();
  for (int i = 0; i < d.n; ++i)
    if (s.pn[i] > 0)
      largest_slip = std::max({largest_slip, std::abs(d.rigid[i]), std::abs(d.rigid[d.n + i])});
  for (int i = 0; i < d.n; ++i) {
    const double p = s.pn[i], bound = d.mu[i] * p, scale = d.mu[i] * pressure;
    const double t = std::hypot(s.pt[i], s.pt[d.n + i]), w = std::hypot(slip[i], slip[d.n + i]);
    if (!(p >= 0 && e[i] >= -tolerance * distance && p * e[i] <= tolerance * pressure * distance &&
          t <= bound + tolerance * scale))
      return false;
    if (p > 0 && w > tolerance * largest_slip && // slips: traction is the bound, along the slip
        !(std::hypot(s.pt[i] - bound * slip[i] / w, s.pt[d.n + i] - bound * slip[d.n + i] / w) <=
              1e3 * tolerance * scale ||
          w <= 1e3 * tolerance * largest_slip))
      return false;
  }
  return true;
}

Solution solve(const ContactProblem& problem) {
  const Dense d(problem);
  Solution out = norm_and_tang(d);
  if (out.found && holds(d, out))
    return out;
  out = by_steps(d);
  out.found = out.found && holds(d, out);
  return out;
}

} // namespace bem_contact::textbook
