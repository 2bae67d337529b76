#include "bem_contact/geometry/level_roll.hpp"

#include <gtest/gtest.h>

namespace {

using namespace bem_contact;

/// Two straight lines that meet in a kink, as where a contact goes from tread to flange: the roll is known.
TEST(LevelRoll, FindsItAcrossAKink) {
  for (const double steep : {1.0, 8.0, 50.0})
    for (const double kink : {-0.01, -1e-4, 1e-4, 0.01})
      for (const double start : {-0.02, 0.0, 0.02}) {
        double last = 0;
        int calls = 0;
        const auto unequal = [&](double roll) {
          last = roll;
          ++calls;
          return -1500 * (kink + (roll - kink) * (roll > kink ? steep : 1));
        };
        const double root = kink > 0 ? 0 : kink - kink / steep; // on the line that crosses zero
        const double found = level_roll(unequal, start, 1500, 1e-9);
        EXPECT_NEAR(found, root, 1e-11) << steep << " " << kink << " " << start;
        EXPECT_EQ(last, found) << "the heights are those of the roll that is returned";
        EXPECT_LE(calls, 20) << steep << " " << kink << " " << start;
      }
}

/// The bound holds where no roll is level.
TEST(LevelRoll, Ends) {
  int calls = 0;
  level_roll([&](double roll) { return ++calls, roll > 0 ? -1.0 : 1.0; }, 0.01, 1500, 1e-9);
  EXPECT_LE(calls, 100);
}

} // namespace
