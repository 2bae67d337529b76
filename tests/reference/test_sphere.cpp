#include "tests/reference/sphere.hpp"

#include "bem_contact/base/error.hpp"

#include <cmath>
#include <gmock/gmock.h>
#include <numbers>

namespace bem_contact::reference {
namespace {

const Material sphere_steel{80000, 0.3};

TEST(Sphere, UniformPressureIsLame) {
  const double young = 2 * sphere_steel.shear_modulus * 1.3;
  EXPECT_NEAR(ball_mode(sphere_steel, 10, 0), -10 * (1 - 0.6) / young, 1e-18);
  EXPECT_NEAR(cavity_mode(sphere_steel, 10, 0), 10 * 1.3 / (2 * young), 1e-18);
}

/// Waves short against the radius: the half-space under p cos(kx), u = (1 - nu) p/(G k), k = n/R.
TEST(Sphere, ShortWavesAreTheHalfSpaces) {
  for (const int n : {1000, 10000}) {
    const double flat = 0.7 * 10 / (sphere_steel.shear_modulus * n);
    EXPECT_NEAR(cavity_mode(sphere_steel, 10, n), flat, 3.0 / n * flat);
    EXPECT_NEAR(-ball_mode(sphere_steel, 10, n), flat, 3.0 / n * flat);
  }
}

/// n = 2, by hand from the equations on the surface (A, B: Lur'e's constants): nothing but the pressure acts.
TEST(Sphere, SecondModeFulfilsItsEquations) {
  const double nu = 0.3, p_2g = 1 / (2 * sphere_steel.shear_modulus);
  // inside: 7 + 2 nu of A and B no shear, -6 nu of A and 2 B the pressure
  const double a = p_2g / (6 * nu + 2 * (7 + 2 * nu)), b = -(7 + 2 * nu) * a;
  EXPECT_NEAR(ball_mode(sphere_steel, 1, 2), 12 * nu * a + 2 * b, 1e-18);
}

TEST(Sphere, RingNumbersAreSymmetricAndConverge) {
  const EqualRings rings{10, 0.01, 30};
  const auto coarse = ring_numbers(sphere_steel, sphere_steel, rings, 400),
             fine = ring_numbers(sphere_steel, sphere_steel, rings, 800),
             finest = ring_numbers(sphere_steel, sphere_steel, rings, 1600);
  for (int i = 0; i < 30; ++i)
    for (int j = 0; j < 30; ++j)
      EXPECT_NEAR(fine[i * 30 + j], fine[j * 30 + i], 1e-12 * fine[0]);
  double first = 0, second = 0;
  for (int i = 0; i < 30; ++i) {
    first = std::max(first, std::abs(coarse[31 * i] - finest[31 * i]));
    second = std::max(second, std::abs(fine[31 * i] - finest[31 * i]));
  }
  EXPECT_LT(second, 0.3 * first);
  EXPECT_LT(second, 2e-3 * fine[31 * 29]);
}

/// All rings of a whole sphere, uniformly loaded: the mode n = 0 alone.
TEST(Sphere, AllRingsTogetherAreUniform) {
  const EqualRings rings{10, 0.05, 40};
  EXPECT_NEAR(40 * rings.area(), 4 * std::numbers::pi * 100, 1e-9);
  const auto numbers = ring_numbers(sphere_steel, sphere_steel, rings, 300);
  for (int i = 0; i < 40; ++i) {
    double sum = 0;
    for (int j = 0; j < 40; ++j)
      sum += numbers[i * 40 + j];
    EXPECT_NEAR(sum, cavity_mode(sphere_steel, 10, 0) - ball_mode(sphere_steel, 10, 0), 1e-9 * numbers[0]);
  }
}

TEST(Sphere, RefusesWhatItHasNot) {
  EXPECT_THROW(ball_mode(sphere_steel, 10, 1), InputError);
  EXPECT_THROW(cavity_mode(sphere_steel, -1, 2), InputError);
  EXPECT_THROW(ring_numbers(sphere_steel, sphere_steel, {10, 0.5, 5}, 100), InputError);
  EXPECT_THROW(ring_numbers(sphere_steel, sphere_steel, {10, 0.5, 2}, 0), InputError);
}

} // namespace
} // namespace bem_contact::reference
