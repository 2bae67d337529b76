#include "bem_contact/uses/shakedown/residual_fields.hpp"
#include "tests/halfspace/quadrature.hpp"

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace {

using namespace bem_contact;
using namespace bem_contact::shakedown;
using halfspace::Stress;

const std::vector<double> s_knots{-3, -1.2, -0.5, 0.1, 0.6, 1.5, 2.5}, depth_knots{0, 0.2, 0.5, 1, 2};

/// Some field with all its stresses. A deviator does not know the mean stress, but xx of these fields is 0.
struct RandomField {
  ResidualFields fields;
  std::vector<double> coefficients;

  explicit RandomField(Residual kind, double curvature = 0)
      : fields(s_knots, depth_knots, kind, curvature), coefficients(fields.size()) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    for (double& c : coefficients)
      c = normal(random);
  }
  Stress at(double s, double depth) const {
    const FieldsAtPoint f = fields.at(s, depth);
    Deviator sum = Deviator::Zero();
    for (std::size_t i = 0; i < f.fields.size(); ++i)
      sum += coefficients.at(f.fields[i]) * f.stress[i];
    Stress t = stress_of(sum);
    const double mean = -t.xx;
    t.xx += mean;
    t.ss += mean;
    t.nn += mean;
    return t;
  }
};

/// Equilibrium without forces, by differences, at points inside the intervals.
TEST(ResidualFields, BalanceThemselves) {
  const RandomField field(Residual::all);
  const double h = 1e-5;
  for (const double s : {-2.0, -0.9, -0.1, 0.3, 1.1, 2.1})
    for (const double n : {0.1, 0.3, 0.7, 1.6}) {
      const Stress right = field.at(s + h, n), left = field.at(s - h, n), below = field.at(s, n + h),
                   above = field.at(s, n - h);
      const double scale = std::abs(right.ss) + std::abs(right.nn) + std::abs(right.sn) + std::abs(right.xs);
      EXPECT_NEAR((right.ss - left.ss + below.sn - above.sn) / (2 * h), 0, 1e-3 * scale);
      EXPECT_NEAR((right.sn - left.sn + below.nn - above.nn) / (2 * h), 0, 1e-3 * scale);
      EXPECT_NEAR((right.xs - left.xs + below.xn - above.xn) / (2 * h), 0, 1e-3 * scale);
    }
}

/// The same below a round surface, in the coordinates of its arc and depth (h = 1 - c n is a radius over that
/// of the surface): d(ss)/ds / h + d(sn)/dn - 2 c/h sn = 0, and so on (Timoshenko and Goodier, section 27).
TEST(ResidualFields, BalanceThemselvesBelowARoundSurface) {
  for (const double c : {0.3, -0.4}) {
    const RandomField field(Residual::all, c);
    const double e = 1e-5;
    for (const double s : {-2.0, -0.9, -0.1, 0.3, 1.1, 2.1})
      for (const double n : {0.1, 0.3, 0.7, 1.6}) {
        const double h = 1 - c * n;
        const Stress t = field.at(s, n), right = field.at(s + e, n), left = field.at(s - e, n),
                     below = field.at(s, n + e), above = field.at(s, n - e);
        const double scale =
            std::abs(right.ss) + std::abs(right.nn) + std::abs(right.sn) + std::abs(right.xs);
        EXPECT_NEAR((right.ss - left.ss) / h / (2 * e) + (below.sn - above.sn) / (2 * e) - 2 * c / h * t.sn,
                    0, 1e-3 * scale);
        EXPECT_NEAR((right.sn - left.sn) / h / (2 * e) + (below.nn - above.nn) / (2 * e) -
                        c / h * (t.nn - t.ss),
                    0, 1e-3 * scale);
        EXPECT_NEAR((right.xs - left.xs) / h / (2 * e) + (below.xn - above.xn) / (2 * e) - c / h * t.xn, 0,
                    1e-3 * scale);
      }
  }
}

TEST(ResidualFields, LeaveTheSurfaceAndTheEndsFree) {
  const RandomField field(Residual::all);
  for (const double s : {-2.0, -0.3, 0.8}) {
    const Stress t = field.at(s, 0);
    EXPECT_NEAR(t.nn, 0, 1e-12);
    EXPECT_NEAR(t.sn, 0, 1e-12);
    EXPECT_NEAR(t.xn, 0, 1e-12);
    EXPECT_GT(std::abs(t.ss), 1e-3);
    const Stress bottom = field.at(s, 2 - 1e-9);
    EXPECT_NEAR(bottom.nn, 0, 1e-6);
    EXPECT_NEAR(bottom.sn, 0, 1e-6);
    EXPECT_NEAR(bottom.xn, 0, 1e-6);
  }
  for (const double n : {0.3, 1.2}) {
    const Stress side = field.at(-3 + 1e-9, n);
    EXPECT_NEAR(side.ss, 0, 1e-6);
    EXPECT_NEAR(side.sn, 0, 1e-6);
    EXPECT_NEAR(side.xs, 0, 1e-6);
  }
  EXPECT_TRUE(field.fields.at(-3.1, 0.5).fields.empty());
  EXPECT_TRUE(field.fields.at(0, 2.1).fields.empty());
}

/// Across a knot stresses of the plane are continuous.
TEST(ResidualFields, AreContinuous) {
  const RandomField field(Residual::all);
  const Stress a = field.at(0.1 - 1e-9, 0.3), b = field.at(0.1 + 1e-9, 0.3);
  EXPECT_NEAR(a.ss, b.ss, 1e-5);
  EXPECT_NEAR(a.nn, b.nn, 1e-5);
  EXPECT_NEAR(a.xs, b.xs, 1e-5);
}

/// A part of a thick ring with an eigenstrain alpha T(r), in plane strain; E alpha T is 1 at the outer
/// radius. That of the whole ring (Timoshenko and Goodier, section 151) with the bending (section 29) that
/// frees its ends.
class ThickRing {
public:
  static constexpr double inner = 10, outer = 20, poisson = 0.28;

  static double eigenstrain(double r) { return r * r / (outer * outer); }
  ThickRing() { bending_ = moment() / ring_moment_of_bending(); }

  struct Stresses {
    double round = 0, radial = 0;
  };
  Stresses at(double r) const {
    const Stresses heat = whole_ring(r), bend = bending(r);
    return {heat.round - bending_ * bend.round, heat.radial - bending_ * bend.radial};
  }

private:
  static double integral(double from, double to) { // of T r
    return (std::pow(to, 4) - std::pow(from, 4)) / (4 * outer * outer);
  }
  static Stresses whole_ring(double r) {
    constexpr double a = inner, b = outer;
    const double all = integral(a, b) / (b * b - a * a), inside = integral(a, r),
                 factor = 1 / ((1 - poisson) * r * r);
    return {factor * ((r * r + a * a) * all + inside - eigenstrain(r) * r * r),
            factor * ((r * r - a * a) * all - inside)};
  }
  static Stresses bending(double r) { // of a unit of its factor
    constexpr double a = inner, b = outer;
    const double logs = b * b * std::log(r / b) + a * a * std::log(a / r),
                 third = a * a * b * b / (r * r) * std::log(b / a);
    return {-third + logs + b * b - a * a, third + logs};
  }
  template <class Round> static double moment_of(const Round& round) { // by Simpson's rule
    constexpr int steps = 400;
    double sum = 0;
    for (int i = 0; i <= steps; ++i) {
      const double r = std::lerp(inner, outer, double(i) / steps);
      sum += (i == 0 || i == steps ? 1 : i % 2 ? 4 : 2) * round(r) * r;
    }
    return sum * (outer - inner) / (3 * steps);
  }
  static double moment() {
    return moment_of([](double r) { return whole_ring(r).round; });
  }
  static double ring_moment_of_bending() {
    return moment_of([](double r) { return bending(r).round; });
  }

  double bending_ = 0;
};

std::vector<double> even_steps(double from, double to, int count) {
  std::vector<double> out;
  for (int i = 0; i <= count; ++i)
    out.push_back(std::lerp(from, to, double(i) / count));
  return out;
}

/// Of all stresses that balance themselves those with the least energy beside the eigenstrain are the thermal
/// stresses. They need no eigenstrain of their own: the space of the stress functions has them, in a bent bar
/// that is loaded from outside (convex) and from inside (concave).
TEST(ResidualFields, HaveTheThermalStressOfAThickRing) {
  using R = ThickRing;
  const ThickRing ring;
  for (const double surface : {R::outer, R::inner}) {
    const bool convex = surface == R::outer;
    const double curvature = (convex ? 1 : -1) / surface, length = 2.2 * surface;
    const std::vector<double> s = even_steps(-length, length, 40), n = even_steps(0, R::outer - R::inner, 22);
    const ResidualFields fields(s, n, Residual::in_plane, curvature);
    const auto radius = [&](double depth) { return convex ? surface - depth : surface + depth; };
    Eigen::MatrixXd energy = Eigen::MatrixXd::Zero(fields.size(), fields.size());
    Eigen::VectorXd work = Eigen::VectorXd::Zero(fields.size());
    const GaussRule gauss(4);
    constexpr double nu =
        R::poisson / (1 - R::poisson); // of plane strain; E / (1 - nu^2) is the unit of stress
    constexpr double unit = 1 - R::poisson * R::poisson, heat = 1 + R::poisson;
    const auto in_plane = [](const Deviator& d) { // xx of the fields is 0
      Stress t = stress_of(d);
      t.ss -= t.xx, t.nn -= t.xx;
      return t;
    };
    for (std::size_t i = 0; i + 1 < s.size(); ++i)
      for (std::size_t j = 0; j + 1 < n.size(); ++j)
        for (std::size_t p = 0; p < 16; ++p) {
          const double at_s = std::midpoint(s[i], s[i + 1]) + 0.5 * (s[i + 1] - s[i]) * gauss.point[p % 4],
                       depth = std::midpoint(n[j], n[j + 1]) + 0.5 * (n[j + 1] - n[j]) * gauss.point[p / 4];
          const double area = 0.25 * (s[i + 1] - s[i]) * (n[j + 1] - n[j]) * gauss.weight[p % 4] *
                              gauss.weight[p / 4] * (1 - curvature * depth);
          const FieldsAtPoint f = fields.at(at_s, depth);
          std::vector<Stress> t;
          for (const Deviator& d : f.stress)
            t.push_back(in_plane(d));
          for (std::size_t k = 0; k < t.size(); ++k) {
            work[f.fields[k]] -= area * heat * R::eigenstrain(radius(depth)) * (t[k].ss + t[k].nn);
            for (std::size_t l = 0; l < t.size(); ++l)
              energy(f.fields[k], f.fields[l]) +=
                  area * unit *
                  (t[k].ss * t[l].ss + t[k].nn * t[l].nn - nu * (t[k].ss * t[l].nn + t[k].nn * t[l].ss) +
                   2 * (1 + nu) * t[k].sn * t[l].sn);
          }
        }
    const Eigen::VectorXd found = energy.ldlt().solve(work);
    double largest = 0, worst = 0;
    for (const double at_s : {0.0, 0.13 * surface})
      for (double depth = 0; depth < R::outer - R::inner; depth += 0.237) {
        const FieldsAtPoint f = fields.at(at_s, depth);
        Stress sum;
        for (std::size_t k = 0; k < f.fields.size(); ++k)
          sum.add(found[f.fields[k]], in_plane(f.stress[k]));
        const R::Stresses right = ring.at(radius(depth));
        largest = std::max({largest, std::abs(right.round), std::abs(right.radial)});
        worst = std::max(
            {worst, std::abs(sum.ss - right.round), std::abs(sum.nn - right.radial), std::abs(sum.sn)});
      }
    EXPECT_GT(largest, 0.02);
    EXPECT_LT(worst, 0.005 * largest) << surface;
  }
}

TEST(ResidualFields, InPlaneHaveNoShearAlongTheTrack) {
  const RandomField field(Residual::in_plane);
  EXPECT_LT(field.fields.size(), RandomField(Residual::all).fields.size());
  const Stress t = field.at(0.3, 0.4);
  EXPECT_EQ(t.xs, 0);
  EXPECT_EQ(t.xn, 0);
  EXPECT_GT(std::abs(t.sn), 1e-3);
}

} // namespace
