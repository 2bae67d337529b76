#include "bem_contact/uses/shakedown/residual_fields.hpp"

#include <gtest/gtest.h>

#include <cmath>
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

TEST(ResidualFields, InPlaneHaveNoShearAlongTheTrack) {
  const RandomField field(Residual::in_plane);
  EXPECT_LT(field.fields.size(), RandomField(Residual::all).fields.size());
  const Stress t = field.at(0.3, 0.4);
  EXPECT_EQ(t.xs, 0);
  EXPECT_EQ(t.xn, 0);
  EXPECT_GT(std::abs(t.sn), 1e-3);
}

} // namespace
