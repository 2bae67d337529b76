#include "bem_contact/base/error.hpp"
#include "bem_contact/uses/fatigue/fatigue_of_result.hpp"
#include "tests/base/message.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace bem_contact;
using namespace bem_contact::fatigue;
using ::testing::HasSubstr;

/// The published lines 2.22e-7 T - 4.44e-6 and -9.09e-8 T + 1.59e-5, whose coefficients are rounded to three
/// digits.
TEST(Damage, FollowsThePublishedLines) {
  const DamageFunction f;
  EXPECT_EQ(damage_of(f, 0), 0);
  EXPECT_EQ(damage_of(f, 19.9), 0);
  EXPECT_NEAR(damage_of(f, 40), 4.44e-6, 1e-8);
  EXPECT_NEAR(damage_of(f, 65), 9.99e-6, 1.1e-8);
  EXPECT_NEAR(damage_of(f, 120), 4.99e-6, 1.1e-8);
  EXPECT_NEAR(damage_of(f, 175), 0, 1e-20);
  EXPECT_EQ(damage_of(f, 200), 0);
}

/// The whole life rail model lets wear win above the last node.
TEST(Damage, MayBecomeNegative) {
  DamageFunction f;
  f.wear_is_negative = true;
  EXPECT_NEAR(damage_of(f, 230), -5e-6, 1e-12);
}

TEST(Damage, TakesOtherNodes) {
  const DamageFunction f{.t_gamma = {10, 20}, .damage = {1e-6, 3e-6}};
  EXPECT_EQ(damage_of(f, 9), 0);
  EXPECT_NEAR(damage_of(f, 10), 1e-6, 1e-20);
  EXPECT_NEAR(damage_of(f, 15), 2e-6, 1e-20);
  EXPECT_NEAR(damage_of(f, 20), 3e-6, 1e-20);
  EXPECT_EQ(damage_of(f, 21), 0);
}

std::string refusal(const DamageFunction& f) {
  return message_of([&] { validate(f); });
}

TEST(Damage, RefusesNodesThatDoNotFit) {
  EXPECT_EQ(refusal({}), "no error");
  EXPECT_THAT(refusal({.t_gamma = {1}, .damage = {0}}), HasSubstr("1 value of T-gamma and 1 of damage"));
  EXPECT_THAT(refusal({.t_gamma = {1, 2}, .damage = {0}}), HasSubstr("2 values of T-gamma and 1 of damage"));
  EXPECT_THAT(refusal({.t_gamma = {2, 2}, .damage = {0, 1}}),
              HasSubstr("must be finite, not negative, and rise"));
}

} // namespace
