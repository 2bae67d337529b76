#include "bem_contact/uses/shakedown/fatigue_criteria.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace bem_contact;
using namespace bem_contact::shakedown;
using halfspace::Stress;

std::vector<Stress> cycle(const Stress& amplitude, const Stress& mean) {
  std::vector<Stress> out;
  for (int i = 0; i < 64; ++i)
    out.push_back(Stress(mean).add(std::cos(2 * 3.14159265358979 * i / 64), amplitude));
  return out;
}

Ball ball_of(const std::vector<Stress>& stresses) {
  DeviatorPath path;
  for (const Stress& t : stresses)
    path.push_back(deviator(t));
  return smallest_ball(path);
}

/// Alternating torsion t: both criteria give t, whatever mean shear is on it.
TEST(FatigueCriteria, Torsion) {
  for (const double mean : {0.0, 200.0}) {
    const std::vector<Stress> torsion = cycle({.xn = 100}, {.xn = mean});
    EXPECT_NEAR(dang_van(torsion, ball_of(torsion), 0.4), 100, 1e-2);
    EXPECT_NEAR(crossland(torsion, ball_of(torsion), 0.2), 100, 1e-2);
  }
}

/// Reversed bending b: b/2 + a b/3 and b/sqrt(3) + alpha b/3. The weights are such that b = t / (a/3 + 1/2)
/// is as bad as torsion t, with both.
TEST(FatigueCriteria, Bending) {
  const double a = 0.4, t = 100, b = t / (a / 3 + 0.5);
  const std::vector<Stress> bending = cycle({.xx = b}, {});
  EXPECT_NEAR(dang_van(bending, ball_of(bending), a), t, 1e-2);
  EXPECT_NEAR(crossland(bending, ball_of(bending), crossland_alpha(a)), t, 1e-2);
}

/// Hydrostatic pressure helps, tension harms.
TEST(FatigueCriteria, MeanStress) {
  const std::vector<Stress> pressed = cycle({.xn = 100}, {-90, -90, -90, 0, 0, 0});
  EXPECT_NEAR(dang_van(pressed, ball_of(pressed), 0.4), 100 - 36, 1e-2);
  EXPECT_NEAR(crossland(pressed, ball_of(pressed), 0.2), 100 - 18, 1e-2);
}

} // namespace
