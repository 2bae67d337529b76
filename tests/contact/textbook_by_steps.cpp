#include "tests/contact/textbook.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <vector>

namespace bem_contact::textbook {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

enum class State : char { exterior, adhesion, slip };

/// p_n, then p_x and p_s of all elements; then q. Zero outside the contact.
struct Unknowns {
  VectorXd p;
  double q = 0;
};

class AllAtOnce {
public:
  AllAtOnce(const Dense& d, double friction, double motion)
      : d_(d), n_(d.n), mu_(friction * d.mu), rigid_(motion * d.rigid) {
    a_.resize(3 * n_, 3 * n_);
    a_ << d.nn, d.nt, -d.tn, -d.tt;
  }

  /// e, then S.
  VectorXd kinematics(const Unknowns& u) const {
    VectorXd r = a_ * u.p;
    r.head(n_) += d_.gap - u.q * d_.cosine;
    r.tail(2 * n_) += rigid_;
    return r;
  }

  /// Newton's method for given sets; p_n > 0 in contact is not asked.
  bool newton(const std::vector<State>& sets, Unknowns& u) const {
    std::vector<int> free; // indices of p
    for (int i = 0; i < n_; ++i)
      if (sets[i] != State::exterior)
        for (int c = 0; c < 3; ++c)
          free.push_back(c * n_ + i);
      else
        u.p[i] = u.p[n_ + i] = u.p[2 * n_ + i] = 0;
    const int m = static_cast<int>(free.size()), all = m + d_.by_force;
    if (m == 0)
      return !d_.by_force;
    for (int k = 0; k < 50; ++k) {
      const VectorXd r = kinematics(u);
      MatrixXd j = MatrixXd::Zero(all, all);
      VectorXd f(all);
      for (int row = 0; row < m; row += 3) {
        const int i = free[row];
        const bool slips = sets[i] == State::slip;
        const double px = u.p[n_ + i], ps = u.p[2 * n_ + i], sx = r[n_ + i], ss = r[2 * n_ + i];
        const double g = mu_[i] * u.p[i], scale = std::max({std::abs(g), std::abs(px), std::abs(ps), 1e-300});
        f[row] = r[i];
        f[row + 1] = slips ? (px * px + ps * ps - g * g) / scale : sx;
        f[row + 2] = slips ? (px * ss - ps * sx) / scale : ss;
        for (int c = 0; c < m; ++c) {
          const int l = free[c];
          j(row, c) = a_(i, l);
          j(row + 1, c) = slips ? 0 : a_(n_ + i, l);
          j(row + 2, c) = slips ? (px * a_(2 * n_ + i, l) - ps * a_(n_ + i, l)) / scale : a_(2 * n_ + i, l);
        }
        if (slips) {
          j(row + 1, row) -= 2 * mu_[i] * g / scale;
          j(row + 1, row + 1) += 2 * px / scale;
          j(row + 1, row + 2) += 2 * ps / scale;
          j(row + 2, row + 1) += ss / scale;
          j(row + 2, row + 2) -= sx / scale;
        }
        if (d_.by_force) {
          j(row, m) = -d_.cosine[i];
          j(m, row) = d_.cosine[i];
          j(m, row + 2) = d_.sine[i];
        }
      }
      if (d_.by_force)
        f[m] = d_.cosine.dot(u.p.head(n_)) + d_.sine.dot(u.p.tail(n_)) - d_.force;
      const VectorXd step = j.fullPivLu().solve(-f);
      if (!step.allFinite())
        return false;
      double size = 0, change = 0;
      for (int c = 0; c < m; ++c) {
        u.p[free[c]] += step[c];
        change = std::max(change, std::abs(step[c]));
        size = std::max(size, std::abs(u.p[free[c]]));
      }
      if (d_.by_force)
        u.q += step[m];
      if (change <= 1e-13 * size)
        return true;
      if (!(size < 1e100))
        return false;
    }
    return false;
  }

  /// Sets that follow from the unknowns; whether they are those given. `one`: no more than the first that is
  /// wrong is changed (Murty's rule against cycles).
  bool settled(const Unknowns& u, std::vector<State>& sets, bool one) const {
    const VectorXd r = kinematics(u);
    const double small = 1e-13 * (a_.topRows(n_) * u.p).cwiseAbs().maxCoeff();
    bool same = true;
    for (int i = 0; i < n_; ++i) {
      State next = sets[i];
      const double bound = mu_[i] * u.p[i], px = u.p[n_ + i], ps = u.p[2 * n_ + i];
      if (sets[i] == State::exterior)
        next = r[i] < -small ? State::adhesion : State::exterior;
      else if (u.p[i] < 0)
        next = State::exterior;
      else if (sets[i] == State::adhesion)
        next = std::hypot(px, ps) > bound * (1 + 1e-12) ? State::slip : State::adhesion;
      else if (px * r[n_ + i] + ps * r[2 * n_ + i] < 0)
        next = State::adhesion;
      same = same && next == sets[i];
      sets[i] = next;
      if (one && !same)
        return false;
    }
    return same;
  }

  bool solve(std::vector<State>& sets, Unknowns& u) const {
    for (int turn = 0; turn < 200; ++turn) {
      for (int i = 0; i < n_; ++i)
        if (sets[i] == State::slip) {
          const double length = std::hypot(u.p[n_ + i], u.p[2 * n_ + i]), bound = mu_[i] * u.p[i];
          for (const int c : {1, 2})
            u.p[c * n_ + i] *= length > 0 ? bound / length : 0;
        }
      if (!newton(sets, u))
        return false;
      if (settled(u, sets, turn > 20))
        return true;
    }
    return false;
  }

private:
  const Dense& d_;
  int n_;
  VectorXd mu_, rigid_;
  MatrixXd a_;
};

/// `friction`: it grows; otherwise the rigid slip does.
Solution follow(const Dense& d, bool friction) {
  Unknowns u{VectorXd::Zero(3 * d.n), d.approach};
  std::vector<State> sets(d.n, State::adhesion);
  double share = 0, step = 0.1;
  while (share < 1) {
    const double next = std::min(1.0, share + step);
    Unknowns trial = u;
    std::vector<State> trial_sets = sets;
    if (AllAtOnce(d, friction ? next : 1, friction ? 1 : next).solve(trial_sets, trial)) {
      u = trial;
      sets = trial_sets;
      share = next;
      step *= 1.5;
    } else if ((step *= 0.5) < 1e-5)
      return {VectorXd::Zero(d.n), VectorXd::Zero(2 * d.n), 0, false};
  }
  return {u.p.head(d.n), u.p.tail(2 * d.n), u.q, true};
}

} // namespace

Solution by_steps(const Dense& d) {
  const Solution by_friction = follow(d, true);
  return by_friction.found && holds(d, by_friction) ? by_friction : follow(d, false);
}

} // namespace bem_contact::textbook
