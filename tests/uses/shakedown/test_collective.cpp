#include "bem_contact/base/error.hpp"
#include "bem_contact/scene/sweep_file.hpp"
#include "bem_contact/uses/shakedown/collective.hpp"
#include "bem_contact/uses/shakedown/fatigue_limits.hpp"
#include "tests/base/message.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace bem_contact;
using namespace bem_contact::shakedown;
using ::testing::HasSubstr;

/// Hertz circles of two forces, the larger one three times as often.
SweepFile two_forces() {
  return parse_sweep_file(
      SceneText{"kind = \"patch\"\nsolver.model = \"halfspace\"\n[motion]\nfrictionless = "
                "true\n[load]\nforce = 1000\n[grid]\n"
                "dx = 0.1\nds = 0.1\nmx = 18\nms = 18\n[gap]\na = 0.01\nb = 0.01\n[sweep]\nmode = \"zip\"\n"
                "load.force = [500, 1000]\nweight = [1, 3]\n"});
}

/// Damages add up after Miner: the smaller load does none, three of four passages that of the larger one.
TEST(CollectiveShakedown, SumsDamagesUp) {
  ShakedownProperties steel;
  const CollectiveShakedown bare = shakedown_of(two_forces(), steel);
  ASSERT_EQ(bare.patches.size(), 2U);
  EXPECT_TRUE(std::isnan(bare.envelope.worst_damage.value));
  const double small = bare.patches[0].dang_van.value, large = bare.patches[1].dang_van.value;
  EXPECT_NEAR(large / small, std::cbrt(2.0), 0.02);
  EXPECT_NEAR(bare.envelope.worst_dang_van.value, large, 0.03 * large);
  steel.fatigue_limit = 0.5 * (small + large);
  const CollectiveShakedown found = shakedown_of(two_forces(), steel, 2);
  const double peak = found.envelope.worst_dang_van.value;
  EXPECT_NEAR(found.envelope.worst_damage.value, 0.75 * 1e-6 * std::pow(peak / *steel.fatigue_limit, 8),
              1e-3 * found.envelope.worst_damage.value);
  EXPECT_EQ(found.patches[0].damage(), 0);
  EXPECT_GT(found.patches[1].damage(), 0);
  EXPECT_THAT(in_words(found, steel), HasSubstr("of 2 patches"));
}

/// Each case is what it is alone, on any number of threads.
TEST(CollectiveShakedown, DoesNotDependOnThreads) {
  const CollectiveShakedown one = shakedown_of(two_forces(), {}, 1), two = shakedown_of(two_forces(), {}, 2);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(one.patches.at(i).lower.value, two.patches.at(i).lower.value);
    EXPECT_EQ(one.patches.at(i).index, i);
  }
  EXPECT_EQ(one.envelope.dang_van, two.envelope.dang_van);
}

TEST(Steels, HaveTheValuesOfTheirStandards) {
  EXPECT_EQ(steel_named("R260").tensile_strength, 880);
  EXPECT_FALSE(steel_named("R260").yield_shear());
  EXPECT_NEAR(steel_named("ER7").yield_shear().value(), 520 / std::sqrt(3.0), 1e-9);
  EXPECT_NEAR(torsion_limit(steel_named("ER7")), 0.45 * 0.577 * 820, 1e-9);
  EXPECT_NEAR(dang_van_a_of_steels(), 0.231, 1e-12);
  EXPECT_THAT(message_of([] { steel_named("R350T"); }), HasSubstr("Did you mean R350HT"));
  EXPECT_EQ(properties_of("R260").yield_shear, 300);
  EXPECT_EQ(properties_of("ER8").steel, "ER8");
}

/// 10^6 at the limit, a 256th at twice the stress, infinitely many below.
TEST(Steels, BearCycles) {
  EXPECT_TRUE(std::isinf(cycles_of(200, 200)));
  EXPECT_NEAR(cycles_of(400, 200), 1e6 / 256, 1e-6);
}

} // namespace
