#include "bem_contact/base/error.hpp"
#include "bem_contact/uses/fatigue/shakedown.hpp"
#include "tests/base/message.hpp"
#include "tests/uses/fatigue/hertz_patch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace bem_contact;
using namespace bem_contact::fatigue;
using ::testing::HasSubstr;

/// FI_surf = mu - 2 pi a b k / (3 Fz), k = 300 MPa, mu = 0.3, for two contacts of 7.3 of the reference facts.
TEST(Shakedown, IndexOfHertzContacts) {
  const HertzPatch narrow{8.011383, 2.533052, 82500, 0.3 * 82500}, wide{7.161676, 5.387172, 1e5, 0.3 * 1e5};
  EXPECT_NEAR(surface_index(shakedown_point(narrow, 300)), 0.14545, 5e-6);
  EXPECT_NEAR(surface_index(shakedown_point(wide, 300)), 0.05759, 5e-6);
  EXPECT_NEAR(surface_index(shakedown_point(narrow, 300)),
              0.3 - 2 * std::numbers::pi * narrow.a * narrow.b * 300 / (3 * 82500), 1e-12);
}

/// The index is zero where the point lies on the limit p0 / k = 1 / mu, and above it beyond.
TEST(Shakedown, IndexVanishesOnTheLimit) {
  for (const double mu : {0.1, 0.25, 0.6}) {
    EXPECT_NEAR(surface_index({1 / mu, mu}), 0, 1e-15);
    EXPECT_GT(surface_index({1.01 / mu, mu}), 0);
    EXPECT_LT(surface_index({0.99 / mu, mu}), 0);
  }
  EXPECT_LT(surface_index({1e9, 0}), 0) << "there is no limit without traction";
}

/// 4 without friction: the shear along the surface is p0/4 at most. The surface takes over at 0.367 (Johnson
/// and Jefferis 1963).
TEST(Shakedown, LimitBelowTheSurface) {
  EXPECT_NEAR(limit_below(0), 4, 1e-3);
  EXPECT_LT(limit_below(0.365), 0.999 / 0.365);
  for (const double mu : {0.368, 0.4, 0.6})
    EXPECT_NEAR(limit_below(mu), 1 / mu, 1e-9);
  for (double mu = 0; mu < 0.6; mu += 0.05)
    EXPECT_LT(limit_below(mu + 0.05), limit_below(mu));
}

TEST(Shakedown, IndexOfElements) {
  EXPECT_DOUBLE_EQ(element_index(400, 1000, 300), 0.1);
  EXPECT_DOUBLE_EQ(element_index(200, 1000, 300), -0.1);
  EXPECT_DOUBLE_EQ(element_index(3, 10, 300), -0.5); // almost no pressure
}

TEST(Shakedown, RefusesWhatIsNotPositive) {
  EXPECT_THAT(message_of([] { require_yield_shear(0); }), HasSubstr("The yield stress in shear cannot be 0"));
  EXPECT_THROW(surface_index({0, 0.3}), InputError);
}

} // namespace
