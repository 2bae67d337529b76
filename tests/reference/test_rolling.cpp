#include "bem_contact/base/error.hpp"
#include "bem_contact/reference/hertz.hpp"
#include "bem_contact/reference/rolling.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

using namespace bem_contact;
using namespace bem_contact::reference;

TEST(Carter, PublishedVector) {
  const CarterSolution c = carter({82000, 0.28}, 500, 1, 0.6, 0.3);
  EXPECT_NEAR(c.normal_force, 178.90, 5e-3);
  EXPECT_NEAR(c.max_pressure, 113.89, 5e-3);
  EXPECT_NEAR(c.creepage, 2.4e-4, 1e-15); // on the rail: Carter's -2.4e-4 has the wheel's sign
  EXPECT_NEAR(c.force_ratio, 0.640, 1e-15);
}

TEST(Carter, TractionAddsUpToTheForce) {
  const CarterSolution c = carter({82000, 0.28}, 500, 1, 0.6, 0.3);
  const int n = 200000;
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    const double x = -1 + (i + 0.5) * 2 / n, p = c.max_pressure * std::sqrt(1 - x * x);
    EXPECT_LE(std::abs(c.traction(x)), c.friction * p * (1 + 1e-12));
    sum += c.traction(x) * 2 / n;
  }
  EXPECT_NEAR(sum / (c.friction * c.normal_force), c.force_ratio, 1e-7);
  EXPECT_EQ(c.traction(1.01), 0);
  EXPECT_LT(c.traction(0.9), 0.5 * c.friction * c.max_pressure * std::sqrt(1 - 0.81)); // stick leads
  EXPECT_NEAR(c.traction(-0.5), c.friction * c.max_pressure * std::sqrt(0.75), 1e-12); // slip trails
}

TEST(Carter, LimitsAreNoForceAndFullSlip) {
  EXPECT_EQ(carter({82000, 0.28}, 500, 1, 1, 0.3).creepage, 0);
  EXPECT_EQ(carter({82000, 0.28}, 500, 1, 1, 0.3).force_ratio, 0);
  EXPECT_EQ(carter({82000, 0.28}, 500, 1, 0, 0.3).force_ratio, 1);
  EXPECT_THROW(carter({82000, 0.28}, 500, 1, 1.1, 0.3), InputError);
}

TEST(Cattaneo, PublishedVector) {
  const Material m{200, 0.42};
  const HertzContact normal = hertz_by_force(0.01, 0.01, contact_modulus(m, m), 9.1954);
  EXPECT_NEAR(normal.semi_axis_x, 1, 5e-6);
  const CattaneoSolution c = cattaneo(m, 1, 9.1954, 0.4, 7.0 / 8 * 0.4 * 9.1954);
  EXPECT_NEAR(c.stick_ratio, 0.5, 1e-14);
  EXPECT_NEAR(c.shift, 0.0081724, 5e-8);
  EXPECT_EQ(cattaneo(m, 1, 9.1954, 0.4, 0).shift, 0);
  EXPECT_THROW(cattaneo(m, 1, 9.1954, 0.4, 4), InputError);
}

TEST(BentallJohnson, PublishedVector) {
  const Material soft{23000, 0.31}, steel{82000, 0.28};
  EXPECT_NEAR(bentall_johnson_creepage(soft, steel, 25, 0.1), 5.259e-4, 5e-8);
  EXPECT_NEAR(bentall_johnson_creepage(steel, soft, 25, 0.1), -5.259e-4, 5e-8);
  EXPECT_EQ(bentall_johnson_creepage(steel, steel, 25, 0.1), 0);
  const CombinedMaterial same = combined(steel, steel);
  EXPECT_NEAR(same.shear_modulus, 82000, 1e-9);
  EXPECT_NEAR(same.poisson, 0.28, 1e-15);
}

TEST(CreepCoefficients, AgreeWithKalkersTable) {
  // Kalker 1990, table E3 (1967), three decimals as printed there: about 1 % apart.
  const auto table = creep_coefficients();
  const auto near = [](double value, double kalker) { EXPECT_NEAR(value / kalker, 1, 0.015); };
  for (const CreepCoefficients& c : table)
    if (c.a_over_b == 1 && c.poisson == 0.25) {
      near(c.c11, 4.12);
      near(c.c22, 3.67);
      near(c.c23, 1.47);
      near(c.c33, 1.19);
    } else if (c.a_over_b == 1 && c.poisson == 0.5) {
      near(c.c11, 5.20);
      near(c.c22, 3.98);
      near(c.c23, 1.63);
      near(c.c33, 1.16);
    }
  EXPECT_EQ(table.size(), 6u);
  EXPECT_EQ(table[0].c11, table[0].c22); // nu = 0: no difference between the directions
}

TEST(CreepCoefficients, ForcesOnTheRailHaveTheCreepagesSign) {
  const CreepCoefficients& k = creep_coefficients()[1];
  const double a = 6, b = 6, g = 82000;
  const LinearForces f = linear_creep_forces(k, g, a, b, 1e-4, 2e-4, 3e-5);
  EXPECT_NEAR(f.fx, 36 * g * 4.116 * 1e-4, 1e-9);
  EXPECT_NEAR(f.fy, 36 * g * (3.673 * 2e-4 + 6 * 1.470 * 3e-5), 1e-9);
  EXPECT_NEAR(f.mz, 216 * g * (-1.470 * 2e-4 + 6 * 1.176 * 3e-5), 1e-8);
}

TEST(FullSlip, SpinMoment) {
  // Integral of mu p r over a Hertzian disc: 2 pi mu p0 int r^2 sqrt(1 - r^2/a^2) dr, p0 = 3N/(2 pi a^2).
  const double mu = 0.3, force = 1e4, a = 2, p0 = 3 * force / (2 * std::numbers::pi * a * a);
  double sum = 0;
  const int n = 100000;
  for (int i = 0; i < n; ++i) {
    const double r = (i + 0.5) * a / n;
    sum += 2 * std::numbers::pi * mu * p0 * r * r * std::sqrt(1 - r * r / (a * a)) * a / n;
  }
  EXPECT_NEAR(full_spin_moment(mu, force, a) / sum, 1, 1e-6);
}
