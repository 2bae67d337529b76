#include "bem_contact/uses/shakedown/melan.hpp"

#include "bem_contact/influence/dense.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace bem_contact::shakedown {

namespace {

/// 1. Gap between factor and bound, over the factor, at which the programme is solved: a hundredth of what
/// the sizes of elements and splines change.
constexpr double gap_tolerance = 1e-4;
/// 1. Bound of its iterations; 12 to 25 are usual.
constexpr int most_iterations = 60;
/// 1. Share of the way to the border of the cones that a step takes.
constexpr double step_share = 0.98;

/// A vector of the cone: first component not below the length of the rest.
struct Cone {
  double head = 0;
  Deviator rest = Deviator::Zero();
};

double product(const Cone& a, const Cone& b) {
  return a.head * b.head + a.rest.dot(b.rest);
}
/// What stays positive inside the cone.
double depth_in_cone(const Cone& a) {
  const double length = a.rest.norm();
  return (a.head - length) * (a.head + length);
}

/// The scaling that maps both slack and multiplier to the same point (Nesterov and Todd).
struct Scaling {
  double size = 1; ///< eta
  Cone axis;       ///< w of length 1

  Scaling(const Cone& slack, const Cone& multiplier) {
    const double s = std::sqrt(depth_in_cone(slack)), z = std::sqrt(depth_in_cone(multiplier));
    size = std::sqrt(s / z);
    const Cone a{slack.head / s, slack.rest / s}, b{multiplier.head / z, -multiplier.rest / z};
    const double twice = std::sqrt(2 * (1 + a.head * b.head - a.rest.dot(b.rest)));
    axis = {(a.head + b.head) / twice, (a.rest + b.rest) / twice};
  }
  Cone apply(const Cone& u, double sign, double factor) const {
    const double along = axis.rest.dot(u.rest);
    return {factor * (axis.head * u.head + sign * along),
            factor * (u.rest + (sign * u.head + along / (1 + axis.head)) * axis.rest)};
  }
  Cone times(const Cone& u) const { return apply(u, 1, size); }        ///< W u
  Cone divided(const Cone& u) const { return apply(u, -1, 1 / size); } ///< W^-1 u
};

/// x of a o x = b.
Cone quotient(const Cone& a, const Cone& b) {
  const double head = (a.head * b.head - a.rest.dot(b.rest)) / depth_in_cone(a);
  return {head, (b.rest - head * a.rest) / a.head};
}
Cone jordan(const Cone& a, const Cone& b) {
  return {product(a, b), a.head * b.rest + b.head * a.rest};
}

/// The longest step from inside the cone that does not leave it, at most 1e9.
double longest_step(const Cone& from, const Cone& way) {
  const double a = way.head * way.head - way.rest.squaredNorm(),
               b = from.head * way.head - from.rest.dot(way.rest), c = depth_in_cone(from);
  const double root = b * b - a * c;
  double step = way.head < 0 ? -from.head / way.head : 1e9;
  if (root >= 0) { // a t^2 + 2 b t + c = 0
    const double q = -(b + std::copysign(std::sqrt(root), b));
    for (const double t : {a != 0 ? q / a : -1.0, q != 0 ? c / q : -1.0})
      if (t > 0)
        step = std::min(step, t);
  }
  return step;
}

/// The unknowns: the load factor, the coefficients of the fields, and xx at each point.
struct Unknowns {
  double factor = 0;
  Eigen::VectorXd coefficients, xx;
};

class Programme {
public:
  Programme(const std::vector<YieldPoint>& points, int fields) : points_(points), fields_(fields) {
    for (const YieldPoint& p : points) {
      first_.push_back(cones_);
      cones_ += p.path.size();
    }
    x_ = {0.0, Eigen::VectorXd::Zero(fields),
          Eigen::VectorXd::Zero(static_cast<Eigen::Index>(points.size()))};
    start();
  }

  MelanLoad solve() {
    MelanLoad out;
    for (int i = 0; i < most_iterations && !out.converged; ++i) {
      if (!iterate())
        break;
      out.converged = gap() <= gap_tolerance * x_.factor && residual_size() <= gap_tolerance;
    }
    collect(out);
    return out;
  }

private:
  /// The residual deviator of a point for these unknowns.
  Deviator residual(std::size_t i, const Unknowns& x) const {
    Deviator out = x.xx[static_cast<Eigen::Index>(i)] * unit_xx();
    const FieldsAtPoint& f = points_[i].fields;
    for (std::size_t k = 0; k < f.fields.size(); ++k)
      out += x.coefficients[f.fields[k]] * f.stress[k];
    return out;
  }

  void start() {
    double largest = 0;
    for (const YieldPoint& p : points_)
      for (const Deviator& d : p.path)
        largest = std::max(largest, d.norm());
    x_.factor = 0.5 / largest;
    slack_.resize(cones_);
    multiplier_.resize(cones_);
    each([&](std::size_t i, std::size_t j, std::size_t c) {
      slack_[c] = {1, x_.factor * points_[i].path[j]};
      const double scale = x_.factor / (double(cones_) * depth_in_cone(slack_[c]));
      multiplier_[c] = {scale * slack_[c].head, -scale * slack_[c].rest};
    });
  }

  template <class Body> void each(const Body& body) const {
    for (std::size_t i = 0; i < points_.size(); ++i)
      for (std::size_t j = 0; j < points_[i].path.size(); ++j)
        body(i, j, first_[i] + j);
  }

  double gap() const {
    double out = 0;
    for (std::size_t c = 0; c < cones_; ++c)
      out += product(slack_[c], multiplier_[c]);
    return out;
  }
  /// What is missing to Koiter's conditions; `of` are the multipliers.
  Unknowns dual_residual(const std::vector<Cone>& of, double target) const {
    Unknowns out{-target, Eigen::VectorXd::Zero(fields_),
                 Eigen::VectorXd::Zero(static_cast<Eigen::Index>(points_.size()))};
    for (std::size_t i = 0; i < points_.size(); ++i) {
      Deviator sum = Deviator::Zero();
      for (std::size_t j = 0; j < points_[i].path.size(); ++j) {
        const Deviator& rest = of[first_[i] + j].rest;
        sum += rest;
        out.factor -= points_[i].path[j].dot(rest);
      }
      out.xx[static_cast<Eigen::Index>(i)] = -unit_xx().dot(sum);
      const FieldsAtPoint& f = points_[i].fields;
      for (std::size_t k = 0; k < f.fields.size(); ++k)
        out.coefficients[f.fields[k]] -= f.stress[k].dot(sum);
    }
    return out;
  }
  double residual_size() const {
    const Unknowns r = dual_residual(multiplier_, 1);
    double work = 0, largest = std::abs(r.factor);
    for (const Cone& z : multiplier_)
      work += z.head;
    const double sum = r.coefficients.cwiseAbs().sum() + r.xx.cwiseAbs().sum();
    return std::max(largest, sum / work);
  }

  /// Factors the normal equations of the current scaling.
  bool factor() {
    scaling_.clear();
    scaling_.reserve(cones_);
    const auto n = static_cast<Eigen::Index>(points_.size());
    matrix_.setZero(fields_, fields_);
    load_column_.setZero(fields_);
    load_xx_.resize(n);
    load_diagonal_ = 0;
    stiffness_.resize(points_.size());
    load_stiffness_.resize(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
      Eigen::Matrix<double, 5, 5> h = Eigen::Matrix<double, 5, 5>::Zero();
      Deviator load = Deviator::Zero();
      for (std::size_t j = 0; j < points_[i].path.size(); ++j) {
        const std::size_t c = first_[i] + j;
        scaling_.emplace_back(slack_[c], multiplier_[c]);
        const Scaling& w = scaling_.back();
        const double share = 1 / (w.size * w.size);
        const Deviator& d = points_[i].path[j];
        h.noalias() += (2 * share) * w.axis.rest * w.axis.rest.transpose();
        h.diagonal().array() += share;
        const Deviator hd = share * (d + 2 * w.axis.rest.dot(d) * w.axis.rest);
        load += hd;
        load_diagonal_ += d.dot(hd);
      }
      add_point(i, h, load);
    }
    matrix_.diagonal().array() += 1e-13 * matrix_.diagonal().maxCoeff(); // a field that no point feels
    if (!factor_cholesky(matrix_))
      return false;
    Eigen::MatrixXd column = load_column_;
    solve_lower(matrix_, column);
    load_diagonal_ -= column.squaredNorm();
    solve_lower_transposed(matrix_, column);
    response_ = column;
    return load_diagonal_ > 0;
  }

  /// Adds a point to the normal equations, without its xx.
  void add_point(std::size_t i, const Eigen::Matrix<double, 5, 5>& h, const Deviator& load) {
    const Deviator hu = h * unit_xx();
    const double huu = unit_xx().dot(hu), load_xx = unit_xx().dot(load);
    stiffness_[i] = {hu, huu};
    load_xx_[static_cast<Eigen::Index>(i)] = load_xx;
    const Eigen::Matrix<double, 5, 5> reduced = h - hu * hu.transpose() / huu;
    const Deviator reduced_load = load - hu * (load_xx / huu);
    load_diagonal_ -= load_xx * load_xx / huu;
    const FieldsAtPoint& f = points_[i].fields;
    for (std::size_t k = 0; k < f.fields.size(); ++k) {
      const Deviator hk = reduced * f.stress[k];
      load_column_[f.fields[k]] += f.stress[k].dot(reduced_load);
      for (std::size_t l = 0; l < f.fields.size(); ++l)
        if (f.fields[l] <= f.fields[k])
          matrix_(f.fields[k], f.fields[l]) += hk.dot(f.stress[l]);
    }
  }

  /// Solves the normal equations for a right-hand side.
  Unknowns solved(const Unknowns& right) const {
    Eigen::MatrixXd b = right.coefficients;
    double load = right.factor;
    const auto n = static_cast<Eigen::Index>(points_.size());
    for (Eigen::Index i = 0; i < n; ++i) { // without xx
      const auto& [hu, huu] = stiffness_[i];
      const double share = right.xx[i] / huu;
      load -= load_xx_[i] * share;
      const FieldsAtPoint& f = points_[i].fields;
      for (std::size_t k = 0; k < f.fields.size(); ++k)
        b(f.fields[k], 0) -= f.stress[k].dot(hu) * share;
    }
    Unknowns out;
    out.factor = (load - response_.dot(b.col(0))) / load_diagonal_;
    solve_lower(matrix_, b);
    solve_lower_transposed(matrix_, b);
    out.coefficients = b.col(0) - out.factor * response_;
    out.xx.resize(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto& [hu, huu] = stiffness_[i];
      Deviator fields = Deviator::Zero();
      const FieldsAtPoint& f = points_[i].fields;
      for (std::size_t k = 0; k < f.fields.size(); ++k)
        fields += out.coefficients[f.fields[k]] * f.stress[k];
      out.xx[i] = (right.xx[i] - hu.dot(fields) - load_xx_[i] * out.factor) / huu;
    }
    return out;
  }

  /// Newton's step for slack o multiplier = target in scaled space.
  template <class Target> void find_step(const Target& target, const Unknowns& missing) {
    std::vector<Cone> moved(cones_); // W^-1 of (point \ target)
    for (std::size_t c = 0; c < cones_; ++c)
      moved[c] = scaling_[c].divided(quotient(scaling_[c].times(multiplier_[c]), target(c)));
    const Unknowns also = dual_residual(moved, 0);
    Unknowns right{-missing.factor - also.factor, -missing.coefficients - also.coefficients,
                   -missing.xx - also.xx};
    step_ = solved(right);
    slack_step_.resize(cones_);
    multiplier_step_.resize(cones_);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Deviator same = residual(i, step_);
      for (std::size_t j = 0; j < points_[i].path.size(); ++j) {
        const std::size_t c = first_[i] + j;
        slack_step_[c] = {0, step_.factor * points_[i].path[j] + same};
        const Scaling& w = scaling_[c];
        const Cone back = w.divided(w.divided(slack_step_[c]));
        multiplier_step_[c] = {moved[c].head - back.head, moved[c].rest - back.rest};
      }
    }
  }

  double longest(const std::vector<Cone>& from, const std::vector<Cone>& way) const {
    double out = 1e9;
    for (std::size_t c = 0; c < cones_; ++c)
      out = std::min(out, longest_step(from[c], way[c]));
    return out;
  }

  /// One iteration by a predictor and a corrector (Mehrotra). False where the numbers do not allow it.
  bool iterate() {
    if (!factor())
      return false;
    const double centre = gap() / double(cones_);
    const Unknowns missing = dual_residual(multiplier_, 1);
    std::vector<Cone> point(cones_);
    for (std::size_t c = 0; c < cones_; ++c)
      point[c] = scaling_[c].times(multiplier_[c]);
    const auto minus_square = [&](std::size_t c) {
      const Cone square = jordan(point[c], point[c]);
      return Cone{-square.head, -square.rest};
    };
    find_step(minus_square, missing);
    const double predicted =
        std::min({1.0, longest(slack_, slack_step_), longest(multiplier_, multiplier_step_)});
    const double sigma = std::pow(1 - predicted, 3);
    std::vector<Cone> second(cones_);
    for (std::size_t c = 0; c < cones_; ++c) {
      second[c] = jordan(scaling_[c].divided(slack_step_[c]), scaling_[c].times(multiplier_step_[c]));
      const Cone square = minus_square(c);
      second[c] = {square.head - second[c].head + sigma * centre, square.rest - second[c].rest};
    }
    Unknowns partly{(1 - sigma) * missing.factor, (1 - sigma) * missing.coefficients,
                    (1 - sigma) * missing.xx};
    find_step([&](std::size_t c) { return second[c]; }, partly);
    const double step = std::min(
        1.0, step_share * std::min(longest(slack_, slack_step_), longest(multiplier_, multiplier_step_)));
    if (!(step > 1e-8))
      return false;
    take(step);
    return true;
  }

  void take(double step) {
    x_.factor += step * step_.factor;
    x_.coefficients += step * step_.coefficients;
    x_.xx += step * step_.xx;
    for (std::size_t c = 0; c < cones_; ++c) {
      slack_[c].rest += step * slack_step_[c].rest;
      multiplier_[c].head += step * multiplier_step_[c].head;
      multiplier_[c].rest += step * multiplier_step_[c].rest;
    }
  }

  void collect(MelanLoad& out) const {
    out.factor = x_.factor;
    double work = 0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      double here = 0;
      for (std::size_t j = 0; j < points_[i].path.size(); ++j)
        here += multiplier_[first_[i] + j].head;
      out.work.push_back(here);
      work += here;
      out.residual.push_back(residual(i, x_));
    }
    out.bound = work;
    for (double& one : out.work)
      one /= work;
    out.coefficients.assign(x_.coefficients.begin(), x_.coefficients.end());
    out.xx.assign(x_.xx.begin(), x_.xx.end());
  }

  struct PointStiffness {
    Deviator hu;
    double huu = 0;
  };

  const std::vector<YieldPoint>& points_;
  int fields_;
  std::size_t cones_ = 0;
  std::vector<std::size_t> first_; ///< cone of each point
  Unknowns x_, step_;
  std::vector<Cone> slack_, multiplier_, slack_step_, multiplier_step_;
  std::vector<Scaling> scaling_;
  Eigen::MatrixXd matrix_;
  Eigen::VectorXd load_column_, load_xx_, response_;
  double load_diagonal_ = 0;
  std::vector<PointStiffness> stiffness_;
  std::vector<Deviator> load_stiffness_;
};

} // namespace

MelanLoad largest_load(const std::vector<YieldPoint>& points, int fields) {
  return Programme(points, fields).solve();
}

} // namespace bem_contact::shakedown
