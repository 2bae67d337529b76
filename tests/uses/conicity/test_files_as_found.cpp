// Profile files as people have them: with rim faces, missing values, another datum, the other side. Each must
// give what the same profile gives as it should be, or say what it may mean.
#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "bem_contact/uses/conicity/wheelset_conicity.hpp"
#include "tests/base/message.hpp"
#include "tests/profile/curves.hpp"
#include "tests/profile/warnings.hpp"

#include <gmock/gmock.h>

#include <filesystem>

namespace {

using namespace bem_contact;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

struct Conicity {
  double radius = 0, wheel_y = 0, rail_y = 0; ///< right, at displacement 0, mm
  std::vector<double> tan_gamma;              ///< for 1, 2, 3 mm; nan: none
  std::string said;
};

Conicity conicity(std::vector<SceneChange> changes) {
  changes.push_back({"position.rail_inclination", 0.025});
  const SaidWarnings warnings;
  const WheelsetOnTrack wheelset = wheelset_of(scene_without_file(changes));
  const WheelsetConicity found = wheelset_conicity(wheelset, {.largest = 3, .step = 1});
  const WheelsetStand middle = stand(wheelset, 0);
  Conicity out{middle.right.radius, middle.right.wheel.y, middle.right.rail.y, {}, warnings.text()};
  for (const WheelsetConicity::Value& v : found.values)
    out.tan_gamma.push_back(v.motion ? v.motion->tan_gamma : std::nan(""));
  return out;
}

/// A cone of positive or negative slope outside, and the flange of S1002: the slope tells the sign.
TEST(NegativeCone, IsSaid) {
  const auto said = [](double slope) {
    std::vector<Point2> points;
    for (double y = 60; y > -20; y -= 0.5)
      points.push_back({y, -slope * y});
    const ProfileCurve flange = standard_profile("S1002");
    for (double s = flange.nearest({-30, 5}).s; s <= flange.s_end(); s += 0.5)
      points.push_back(flange.at(s).position);
    const TabulatedProfile wheel(ProfileCurve::through_points("cone", points));
    const TabulatedProfile rail(standard_profile("60E1"));
    const WheelsetOnTrack wheelset{.right_rail = rail,
                                   .right_wheel = wheel,
                                   .left_rail = rail,
                                   .left_wheel = wheel,
                                   .position = {.rail_inclination = 0.025}};
    const SaidWarnings warnings;
    wheelset_conicity(wheelset, {.largest = 3, .step = 1});
    return warnings.text();
  };
  EXPECT_THAT(said(-0.05),
              AllOf(HasSubstr("the cone is negative in the middle"), HasSubstr("tan gamma is -0.0500")));
  EXPECT_THAT(said(0.05), testing::IsEmpty());
  EXPECT_THAT(conicity({{"wheel.profile", "S1002"}, {"rail.profile", "60E1"}}).said, testing::IsEmpty());
}

class AsFound : public testing::Test {
protected:
  void SetUp() override {
    if (!std::filesystem::exists(folder_))
      GTEST_SKIP() << "the shared data are not at hand";
  }
  std::string file(const char* name) const { return (folder_ / name).string(); }

private:
  std::filesystem::path folder_ = std::filesystem::path(CONFORMAL_SOURCE_DIR) / "../shared/data/found";
};

/// All these wheels are S1002 moved by nothing but its datum; the values are a search's by others.
void expect_right(const Conicity& found) {
  EXPECT_NEAR(found.radius, 459.9803, 2e-4);
  EXPECT_NEAR(found.wheel_y, 0.58, 0.01);
  EXPECT_NEAR(found.rail_y, -2.45, 0.01);
  EXPECT_NEAR(found.tan_gamma.at(2), 0.0907, 1e-4);
}

TEST_F(AsFound, AWheelWithTheBackOfItsRim) {
  const Conicity found = conicity(
      {{"wheel.profile", file("file-03-wheel-back-face-drawn/wheel.txt")}, {"rail.profile", "60E1"}});
  expect_right(found);
  EXPECT_THAT(found.said, Not(HasSubstr("z points up")));
}

TEST_F(AsFound, ATreadWithoutAFlange) {
  const std::string wheel = file("file-06-tread-without-flange-z-up/tread.txt");
  EXPECT_THAT(conicity({{"wheel.profile", wheel}, {"rail.profile", "60E1"}}).said, HasSubstr("profile_z = "));
  expect_right(conicity({{"wheel.profile", wheel}, {"wheel.profile_z", "up"}, {"rail.profile", "60E1"}}));
}

TEST_F(AsFound, AWheelWithMissingValues) {
  const Conicity found =
      conicity({{"wheel.profile", file("file-08-missing-value-999/wheel.txt")}, {"rail.profile", "60E1"}});
  expect_right(found);
  EXPECT_THAT(found.said, HasSubstr("2 points left out"));
}

TEST_F(AsFound, AWheelWithAnotherDatum) {
  for (const auto& [name, back] : {std::pair{"back_at_-77.8.txt", -77.8}, {"back_at_-60.txt", -60.0}}) {
    const std::string wheel = file("file-13-tape-circle-not-70-mm-from-the-back/") + name;
    const Conicity found = conicity({{"wheel.profile", wheel}, {"rail.profile", "60E1"}});
    EXPECT_THAT(found.said, HasSubstr("wheel.flange_back = ")) << name;
    EXPECT_EQ(found.said.find("there is no play") != std::string::npos, back == -60) << found.said;
    const Conicity right =
        conicity({{"wheel.profile", wheel}, {"wheel.flange_back", back}, {"rail.profile", "60E1"}});
    EXPECT_NEAR(right.radius, 459.9803, 2e-4);
    EXPECT_NEAR(right.tan_gamma.at(2), 0.0907, 1e-4);
    EXPECT_THAT(right.said, AllOf(Not(HasSubstr("play")), Not(HasSubstr("flange_back"))));
  }
}

TEST_F(AsFound, ALeftRailAsItLiesInTheTrack) {
  for (const char* name : {"left_in_track.txt", "right.txt"}) {
    const Conicity found =
        conicity({{"wheel.profile", "S1002"},
                  {"rail.profile", file("file-04-left-rail-as-it-lies-in-the-track/") + name}});
    EXPECT_NEAR(found.radius, 460.946, 1e-3) << name;
    EXPECT_NEAR(found.tan_gamma.at(1), 0.7266, 1e-4) << name;
    EXPECT_EQ(found.said.find("centre of the track") != std::string::npos, name[0] == 'l');
  }
}

} // namespace
