#include "bem_contact/base/error.hpp"
#include "bem_contact/base/temporary_folder.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "bem_contact/uses/shakedown/shakedown_of_result.hpp"
#include "tests/base/message.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>

namespace {

using namespace bem_contact;
using namespace bem_contact::shakedown;
using halfspace::Stress;
using ::testing::HasSubstr;

/// A Hertz circle that slips all over, 1,000 MPa.
SceneResult circle() {
  return Sequence().solve(parse_scene_file(
      "kind = \"patch\"\nsolver.model = \"halfspace\"\n[motion]\nfriction = 0.2\nxi = 0.05\n[load]\nforce = "
      "1000\n[grid]\ndx = 0.08\nds = 0.08\nmx = 20\nms = 20\n[gap]\na = 0.01\nb = 0.01\n"));
}

class InitialStresses : public ::testing::Test {
protected:
  InitialStress read(const std::string& text) const {
    std::ofstream(folder_ / "stress.csv") << text;
    return read_initial_stress(folder_ / "stress.csv");
  }
  std::string refused(const std::string& text) const {
    return message_of([&] { read(text); });
  }
  TemporaryFolder folder_;
};

/// The limit stays what it is (Melan); stresses along the surface of -100 MPa lower the hydrostatic stress by
/// 200/3 MPa everywhere, and the amplitudes not at all.
TEST_F(InitialStresses, FatigueFeelsThemAndTheLimitDoesNot) {
  const SceneResult result = circle();
  const ShakedownProperties bare{.yield_shear = 300, .dang_van_a = 0.4};
  ShakedownProperties pressed = bare;
  pressed.initial = read("depth,xx,ss\n0,-100,-100\n");
  const PatchShakedown before = shakedown_of(result, bare).patches.at(0),
                       after = shakedown_of(result, pressed).patches.at(0);
  EXPECT_EQ(after.lower.value, before.lower.value);
  EXPECT_EQ(after.upper.value, before.upper.value);
  constexpr double of_ball = 2e-4 * 500; // MPa: the smallest ball is found within 2e-4 of its radius
  EXPECT_NEAR(after.dang_van.value, before.dang_van.value - 0.4 * 200 / 3, of_ball);
  EXPECT_NEAR(after.dang_van_surface, before.dang_van_surface - 0.4 * 200 / 3, of_ball);
  EXPECT_NEAR(after.crossland.value, before.crossland.value - bare.crossland() * 200 / 3, of_ball);
  EXPECT_NE(after.first_yield.value, before.first_yield.value);
}

/// At the load factor of first yield the stresses together reach k: half of the load on half of it.
TEST_F(InitialStresses, FirstYieldIsThatOfBothTogether) {
  const SceneResult result = circle();
  ShakedownProperties steel{.yield_shear = 300};
  const PatchShakedown bare = shakedown_of(result, steel).patches.at(0);
  steel.initial = read("depth,xx\n0,300\n20,300\n"); // 300 / sqrt(3) of the deviator's k
  const double first = shakedown_of(result, steel).patches.at(0).first_yield.value;
  EXPECT_LT(first, bare.first_yield.value);
  EXPECT_GT(first, (1 - 1 / std::sqrt(3.0)) * bare.first_yield.value);
  steel.initial = read("depth,xx\n0,600\n"); // beyond k alone
  const PatchShakedown beyond = shakedown_of(result, steel).patches.at(0);
  EXPECT_EQ(beyond.first_yield.value, 0);
  EXPECT_EQ(beyond.yielding, bare.lower.value >= 1 ? Yielding::once : Yielding::for_ever);
}

TEST_F(InitialStresses, AreLinearBetweenLinesAndEndWithTheLast) {
  const InitialStress table = read("s,depth,xx,nn\n0,0,0,0\n0,2,20,4\n10,2,40,8\n10,0,20,0\n");
  EXPECT_EQ(table.at(5, 1), (Stress{.xx = 20, .nn = 3}));
  EXPECT_EQ(table.at(-3, 0.5), (Stress{.xx = 5, .nn = 1}));
  EXPECT_EQ(table.at(99, 99), (Stress{.xx = 40, .nn = 8}));
}

TEST_F(InitialStresses, RefuseWhatIsNoTable) {
  EXPECT_THAT(refused("depth,sigma\n0,1\n"), HasSubstr("its columns are depth, sigma"));
  EXPECT_THAT(refused("xx\n0\n"), HasSubstr("its columns are xx"));
  EXPECT_THAT(refused("depth,xx\n"), HasSubstr("no"));
  EXPECT_THAT(refused("depth,xx\n-1,3\n"), HasSubstr("depths"));
  EXPECT_THAT(refused("depth,xx\n1,3\n1,4\n"), HasSubstr("twice"));
  EXPECT_THAT(refused("depth,nn\n0,3\n"), HasSubstr("nn is 3 MPa at a depth of 0"));
  EXPECT_THAT(refused("s,depth,xx\n0,1,3\n1,2,3\n"), HasSubstr("other depths"));
  EXPECT_THAT(refused("depth,xx\n0,nan\n"), HasSubstr("nan"));
}

} // namespace
