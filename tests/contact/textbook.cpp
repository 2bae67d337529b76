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

} // namespace

double number(const ContactProblem& problem, int target, int i, int load, int j, int ahead) {
  const int mx = problem.grid.mx, m = target % mx + ahead - load % mx;
  return (m < 0 ? parity(i, j) : 1) * problem.numbers.at(std::abs(m), target / mx, i, load / mx, j);
}

double step_number(const ContactProblem& problem, int target, int i, int load, int j) {
  return 1.5 * number(problem, target, i, load, j) - 2 * number(problem, target, i, load, j, 1) +
         0.5 * number(problem, target, i, load, j, 2);
}

Solution solve(const ContactProblem& problem) {
  const int n = problem.grid.size();
  const std::vector<int> shear{component_x, component_s}, normal{component_n};
  const MatrixXd nn = matrix(problem, normal, normal, false), nt = matrix(problem, normal, shear, false);
  const MatrixXd tt = matrix(problem, shear, shear, true), tn = matrix(problem, shear, normal, true);
  VectorXd gap(n), cosine(n), sine(n), rigid(2 * n), mu(n);
  for (int i = 0; i < n; ++i) {
    gap[i] = problem.gap[i];
    cosine[i] = std::cos(problem.rows[i / problem.grid.mx].delta);
    sine[i] = std::sin(problem.rows[i / problem.grid.mx].delta);
    mu[i] = problem.friction_of(i / problem.grid.mx);
    rigid[i] = problem.slip_x[i] * problem.grid.dx;
    rigid[n + i] = problem.slip_s[i] * problem.grid.dx;
  }
  const bool by_force = problem.load == LoadKind::force;
  Solution out{VectorXd::Zero(n), VectorXd::Zero(2 * n), problem.approach, false};
  std::vector<char> in_contact(n, 1), slips(n, 0);
  for (int turn = 0; turn < 200; ++turn) {
    const VectorXd before_n = out.pn, before_t = out.pt;
    const double force = problem.force / problem.element_area() - sine.dot(out.pt.tail(n));
    if (!norm(nn, gap + nt * out.pt, cosine, force, by_force, in_contact, out.pn, out.approach))
      return out;
    const VectorXd bound = mu.cwiseProduct(out.pn);
    slips.assign(n, 0);
    if (!tang(tt, rigid - tn * out.pn, bound, slips, out.pt))
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

} // namespace bem_contact::textbook
