#include "bem_contact/base/error.hpp"
#include "bem_contact/uses/conicity/equivalent_conicity.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

namespace {

using namespace bem_contact;

using Function = std::vector<RadiusDifference>;
constexpr KlingelLengths lengths{1500, 460};
constexpr double er = 1500 * 460;

/// Of a wheelset with conical wheels (Klingel 1883), mm.
double klingel_wavelength(double tan_gamma, const KlingelLengths& l) {
  return 2 * std::numbers::pi * std::sqrt(l.contact_distance * l.wheel_radius / (2 * tan_gamma));
}

template <class F> Function sampled(const F& f, double reach, double step) {
  Function out;
  const int steps = static_cast<int>(std::lround(reach / step));
  for (int i = -steps; i <= steps; ++i)
    out.push_back({i * step, f(i * step)});
  return out;
}

double conicity(const Function& f, double amplitude) {
  const auto found = equivalent_conicity(f, amplitude, lengths);
  return found ? found->tan_gamma : NAN;
}

TEST(EquivalentConicity, IsExactForACone) {
  for (const double gamma : {0.025, 0.05, 0.4}) {
    const Function f = sampled([&](double y) { return 2 * gamma * y; }, 10, 0.1);
    for (const double amplitude : {0.05, 1.0, 3.33, 10.0}) {
      const auto found = equivalent_conicity(f, amplitude, lengths);
      ASSERT_TRUE(found) << amplitude;
      EXPECT_NEAR(found->tan_gamma, gamma, 1e-12 * gamma);
      EXPECT_NEAR(found->wavelength, klingel_wavelength(gamma, lengths), 1e-12 * found->wavelength);
      EXPECT_NEAR(found->to, amplitude, 1e-9);
      EXPECT_NEAR(found->from, -amplitude, 1e-9);
    }
  }
  // Klingel 1883: 2 pi sqrt(b r0 / gamma), b half the distance of the contact circles.
  EXPECT_DOUBLE_EQ(klingel_wavelength(0.05, lengths), 2 * std::numbers::pi * std::sqrt(750 * 460 / 0.05));
}

/// A constant difference of either sign: the path is made of parabolas, 8 sqrt(e r0 A / (2 d)) long.
TEST(EquivalentConicity, IsExactForAJump) {
  const double d = 0.3;
  const Function f{{-10, -d}, {0, -d}, {0, d}, {10, d}};
  for (const double amplitude : {1.0, 4.0, 10.0})
    EXPECT_NEAR(equivalent_conicity(f, amplitude, lengths)->wavelength,
                8 * std::sqrt(er * amplitude / (2 * d)), 1e-6);
}

/// Flange clearance: straight on for 2 c at the slope sqrt(2 gamma / (e r0)) (A - c), half a circle beyond.
TEST(EquivalentConicity, IsExactForAWheelsetBetweenTwoFlanges) {
  const double gamma = 0.2, c = 3;
  const auto between = [&](double y) { return std::abs(y) < c ? 0 : 2 * gamma * (y - std::copysign(c, y)); };
  const Function f = sampled(between, 10, 0.5);
  for (const double amplitude : {3.5, 5.0, 9.0}) {
    const double circle = klingel_wavelength(gamma, lengths);
    const double straight = 4 * c / (std::sqrt(2 * gamma / er) * (amplitude - c));
    EXPECT_NEAR(equivalent_conicity(f, amplitude, lengths)->wavelength, circle + straight, 1e-6);
  }
  EXPECT_FALSE(equivalent_conicity(f, 2.0, lengths)); // nothing steers it
}

/// difference = c y^3: a quarter of the wavelength is sqrt(2 e r0 / c) / A times the integral of
/// 1 / sqrt(1 - u^4) from 0 to 1, which is 1.31102877714606. The error is that of linear interpolation.
TEST(EquivalentConicity, ConvergesWithTheSquareOfTheStepForACubic) {
  const double c = 0.01, amplitude = 4;
  const double exact = 4 * 1.31102877714606 * std::sqrt(2 * er / c) / amplitude;
  const auto error = [&](double step) {
    const Function f = sampled([&](double y) { return c * y * y * y; }, 6, step);
    return std::abs(equivalent_conicity(f, amplitude, lengths)->wavelength / exact - 1);
  };
  EXPECT_LT(error(0.1), 5e-4);
  EXPECT_NEAR(error(0.2) / error(0.1), 4, 0.2);
  EXPECT_NEAR(error(0.1) / error(0.05), 4, 0.2);
}

double uneven(double y) {
  return 0.2 * y + 0.03 * y * y + 0.01 * y * y * y + (y > 2.5 ? 0.4 : 0);
}

TEST(EquivalentConicity, IsTheSameInTheMirrorAndMovedSideways) {
  const Function f = sampled(uneven, 8, 0.1);
  Function mirrored, moved;
  for (auto p = f.rbegin(); p != f.rend(); ++p)
    mirrored.push_back({-p->lateral, -p->difference});
  for (const RadiusDifference& p : f)
    moved.push_back({p.lateral + 1.23, p.difference});
  for (const double amplitude : {0.7, 2.0, 4.0}) {
    const double value = conicity(f, amplitude);
    EXPECT_NEAR(conicity(mirrored, amplitude), value, 1e-12 * value);
    EXPECT_NEAR(conicity(moved, amplitude), value, 1e-10 * value);
    const auto a = equivalent_conicity(f, amplitude, lengths),
               b = equivalent_conicity(moved, amplitude, lengths);
    EXPECT_NEAR(b->to - a->to, 1.23, 1e-9);
  }
}

/// A value between two others, on their chord, changes nothing.
TEST(EquivalentConicity, DependsOnTheFunctionAndNotOnItsTable) {
  const Function f = sampled(uneven, 8, 0.5);
  Function finer{f.front()};
  for (std::size_t k = 1; k < f.size(); ++k) {
    finer.push_back(
        {0.3 * f[k].lateral + 0.7 * f[k - 1].lateral, 0.3 * f[k].difference + 0.7 * f[k - 1].difference});
    finer.push_back(f[k]);
  }
  for (const double amplitude : {0.7, 2.0, 4.0})
    EXPECT_NEAR(conicity(finer, amplitude), conicity(f, amplitude), 1e-10);
}

/// Between two wells: small motions stay in the deeper one, large ones go over both, and where the width
/// jumps no motion has the amplitude.
TEST(EquivalentConicity, HasNoMotionOfAnAmplitudeThatAHumpForbids) {
  const Function f = sampled([](double y) { return (y + 4) * (y + 1) * (y - 3) * 0.01; }, 12, 0.05);
  EXPECT_TRUE(equivalent_conicity(f, 1.0, lengths));
  EXPECT_FALSE(equivalent_conicity(f, 4.0, lengths));
  EXPECT_TRUE(equivalent_conicity(f, 7.0, lengths));
}

TEST(EquivalentConicity, IsNotGivenWhereTheFunctionEndsOrSteersOutwards) {
  const Function f = sampled([](double y) { return 0.1 * y; }, 5, 0.1);
  EXPECT_TRUE(equivalent_conicity(f, 5.0, lengths));
  EXPECT_FALSE(equivalent_conicity(f, 5.1, lengths));
  EXPECT_FALSE(equivalent_conicity(sampled([](double y) { return -0.1 * y; }, 5, 0.1), 1.0, lengths));
  EXPECT_FALSE(equivalent_conicity(sampled([](double) { return 0.0; }, 5, 0.1), 1.0, lengths));
  EXPECT_THROW(equivalent_conicity(Function{{0, 0}, {1, 1}}, 1.0, lengths), InputError);
  EXPECT_THROW(equivalent_conicity(f, 0.0, lengths), InputError);
  EXPECT_THROW(equivalent_conicity(Function{{0, 0}, {2, 1}, {1, 1}}, 1.0, lengths), InputError);
}

} // namespace
