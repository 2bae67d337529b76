#include "bem_contact/base/error.hpp"
#include "bem_contact/uses/wear/law.hpp"
#include "tests/base/message.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <numbers>

namespace {

using namespace bem_contact;
using namespace bem_contact::wear;
using ::testing::HasSubstr;

/// The three regimes as published (Lewis and Dwyer-Joyce 2004): 5.3 I, 55.1, 55.1 + 61.9 (I - 77.2).
TEST(EnergyLaw, HasThreeRegimes) {
  const EnergyLaw law;
  EXPECT_DOUBLE_EQ(mass_rate(law, 0), 0);
  EXPECT_DOUBLE_EQ(mass_rate(law, 5), 26.5);
  EXPECT_NEAR(mass_rate(law, 10.4), 55.12, 1e-12);
  EXPECT_DOUBLE_EQ(mass_rate(law, 10.5), 55.1);
  EXPECT_DOUBLE_EQ(mass_rate(law, 77.2), 55.1);
  EXPECT_NEAR(mass_rate(law, 87.2), 55.1 + 619, 1e-10);
}

/// Where severe wear becomes catastrophic the rate does not jump: 61.9 I - 4778.7, as it is sometimes
/// written, would fall to 0 there.
TEST(EnergyLaw, DoesNotJumpToCatastrophicWear) {
  const EnergyLaw law;
  EXPECT_NEAR(mass_rate(law, 77.2 * (1 + 1e-12)), mass_rate(law, 77.2), 1e-6);
}

/// I = 5 N/mm^2 takes off 3.40e-3 mm per metre rolled; over 10 mm that is 3.40e-5 mm in a passage, and a
/// wheel of radius 460 mm, which meets it once in a revolution, loses 1 mm in 85 km.
TEST(EnergyLaw, DepthOfTheExample) {
  const double rate = depth_rate(EnergyLaw{}, {.power = 5, .pressure = 800, .sliding = 1e-2});
  EXPECT_NEAR(1e3 * rate, 3.397e-3, 1e-6);
  const double passage = 10 * rate;
  EXPECT_NEAR(passage, 3.397e-5, 1e-8);
  EXPECT_NEAR(2 * std::numbers::pi * 460 / passage / 1e6, 85.07, 0.01);
}

/// depth = k p d / H in each region of the map of KTH, and the borders belong to the lower side.
TEST(ArchardLaw, UsesTheRegionOfTheMap) {
  const ArchardLaw law{.hardness = 3000, .rolling_speed = 2e4, .map = kth_map(3000)};
  const auto k = [&](double sliding_speed, double pressure) {
    const double sliding = sliding_speed / law.rolling_speed;
    return depth_rate(law, {.power = 1, .pressure = pressure, .sliding = sliding}) * law.hardness /
           (pressure * sliding);
  };
  EXPECT_NEAR(k(100, 1000), 5.5e-4, 1e-15);
  EXPECT_NEAR(k(500, 1000), 35e-4, 1e-15);
  EXPECT_NEAR(k(900, 1000), 5.5e-4, 1e-15);
  for (const double speed : {100.0, 500.0, 900.0})
    EXPECT_NEAR(k(speed, 2500), 350e-4, 1e-14);
  EXPECT_EQ(coefficient(law.map, 200, 2400), 5.5e-4);
  EXPECT_EQ(coefficient(law.map, 200.001, 2400), 35e-4);
}

/// Archard's law is linear in pressure and in sliding distance where k is constant.
TEST(ArchardLaw, IsLinearWithoutBorders) {
  const ArchardLaw law{.hardness = 2000, .rolling_speed = 1e4, .map = {{}, {}, {4e-4}}};
  EXPECT_DOUBLE_EQ(depth_rate(law, {.power = 0, .pressure = 1000, .sliding = 1e-3}),
                   4e-4 * 1000 * 1e-3 / 2000);
  EXPECT_DOUBLE_EQ(depth_rate(law, {.power = 9, .pressure = 3000, .sliding = 2e-3}),
                   4e-4 * 3000 * 2e-3 / 2000);
}

std::string refusal(const Law& law) {
  return ::message_of([&] { validate(law); });
}

TEST(WearLaw, HasAName) {
  EXPECT_EQ(law_named("energy", 3000, 3e4), Law(EnergyLaw{}));
  EXPECT_EQ(law_named("archard", 2000, 1e4),
            Law(ArchardLaw{.hardness = 2000, .rolling_speed = 1e4, .map = kth_map(2000)}));
  EXPECT_THROW(law_named("usual", 3000, 3e4), InputError);
  EXPECT_THROW(law_named("energy", 3000, 3e4, kth_map(3000)), InputError); // it would be ignored
}

TEST(WearLaw, RefusesWhatIsNoLaw) {
  EXPECT_EQ(refusal(EnergyLaw{}), "no error");
  EXPECT_EQ(refusal(ArchardLaw{.map = kth_map(3000)}), "no error");
  EXPECT_THAT(refusal(EnergyLaw{.density = 0}), HasSubstr("density (it must be positive)"));
  EXPECT_THAT(refusal(EnergyLaw{.mild = -1}), HasSubstr("coefficient"));
  EXPECT_THAT(refusal(EnergyLaw{.severe_until = 5}), HasSubstr("limit of a regime"));
  EXPECT_THAT(refusal(ArchardLaw{.hardness = std::numeric_limits<double>::quiet_NaN(), .map = kth_map(3000)}),
              HasSubstr("hardness"));
  EXPECT_THAT(refusal(ArchardLaw{.map = {{200, 100}, {}, {1, 1, 1}}}),
              HasSubstr("must be positive and rise"));
  EXPECT_THAT(refusal(ArchardLaw{.map = {{200}, {}, {1}}}),
              HasSubstr("1 borders of speed and 0 of pressure make 2 regions, and it has 1 coefficients"));
}

} // namespace
