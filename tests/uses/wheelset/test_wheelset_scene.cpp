#include "bem_contact/base/error.hpp"
#include "tests/base/message.hpp"
#include "tests/uses/wheelset/scenes.hpp"

#include <gmock/gmock.h>

namespace {

using namespace bem_contact;
using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(WheelsetScene, RefusesWhatBelongsToOneWheel) {
  for (const auto& [line, words] :
       {std::pair("load.force = 1e5\n", "load.force"),
        {"load.force_y = 1e4\n", "wheelset.force_y"},
        {"position.roll = 1e-3\n", "roll of the wheelset is found"},
        {"position.vertical = 0.1\n", "position.vertical"},
        {"position.side = 'left'\n", "both wheels are solved"},
        {"motion.xi = 1e-3\n", "wheelset.torque"},
        {"motion.kind = 'transient'\n", "steady"},
        {"left_rail.influence = 'a.h5'\n", "profile is not given"},
        {"motion.rolling_radius = 460\nwheelset.torque = 1e5\n", "either of the two"}})
    EXPECT_THAT(message_of([&, line = line] { standard(line); }), HasSubstr(words)) << line;
  EXPECT_THAT(message_of([] {
                parse_scene_file("rail.profile = '60E1'\nwheel.profile = 'S1002'\nload.force = 1e5\n"
                                 "wheelset.roll_moment = 1e6\n");
              }),
              HasSubstr("wheelset.force is not given"));
}

/// What is wrong with the axle's force is said of the wheelset, not of one wheel.
TEST(WheelsetScene, AWarningOfTheAxleBelongsToTheWheelset) {
  const WheelsetDescription found = check_wheelset(
      parse_scene_file("rail.profile = '60E1'\nwheel.profile = 'S1002'\nposition.rail_inclination = 0.025\n"
                       "motion.friction = 0.3\nwheelset.force = 200\n"));
  EXPECT_THAT(found.warnings.texts(),
              testing::ElementsAre(testing::HasSubstr("wheelset.force looks like kN")));
  EXPECT_THAT(found.right.warnings.texts(), testing::ElementsAreArray(found.left.warnings.texts()));
}

TEST(WheelsetScene, IsNoSceneOfOneWheelAndBack) {
  EXPECT_THAT(message_of([] { Sequence().solve(standard("")); }), HasSubstr("bem_contact wheelset"));
  SceneFile one = standard("");
  one.wheelset = {};
  one.load.force = 1e5;
  EXPECT_THAT(message_of([&] { solve_wheelset(one); }), HasSubstr("[wheelset]"));
  const SceneFile scene = standard("wheelset.force_y = 1e4\n");
  EXPECT_EQ(parse_scene_file(scene_with_defaults(scene)).wheelset, scene.wheelset);
}

TEST(WheelsetScene, RefusesWhatHasNoEquilibrium) {
  EXPECT_THAT(
      message_of([] { solve_wheelset(cones("wheelset.roll_moment = 9e7\nmotion.frictionless = true\n")); }),
      AllOf(HasSubstr("left wheel lifts"), HasSubstr("roll_moment")));
  EXPECT_THAT(message_of([] { solve_wheelset(standard("wheelset.force_y = 4e5\n")); }),
              AllOf(HasSubstr("No lateral displacement"), HasSubstr("climbs"),
                    HasSubstr("by a search with larger elements"), HasSubstr("up to about 3.0e+05 N")));
  EXPECT_THAT(message_of([] { solve_wheelset(cones("wheelset.torque = 3e7\n")); }),
              HasSubstr("friction used up"));
}

/// The message names the key that is too large, also where the search for a lateral force fails by it.
TEST(WheelsetScene, RefusalsNameTheKeyThatIsToBlame) {
  const std::string in_curve = "position.yaw = 2e-3\n";
  EXPECT_THAT(message_of([&] { solve_wheelset(standard(in_curve + "wheelset.torque = 2.9e7\n")); }),
              AllOf(HasSubstr("cannot bear a torque of 2.9e+07"), HasSubstr("wheelset.torque nearer to 0")));
  EXPECT_THAT(
      message_of([&] { solve_wheelset(standard("wheelset.force_y = 2e4\nwheelset.torque = 1e8\n")); }),
      HasSubstr("wheelset.torque nearer to 0"));
  EXPECT_THAT(
      message_of([&] { solve_wheelset(standard("wheelset.force_y = 2e4\nwheelset.roll_moment = 1e9\n")); }),
      AllOf(HasSubstr("left wheel lifts"), HasSubstr("wheelset.roll_moment nearer to 0")));
  EXPECT_THAT(
      message_of([&] { solve_wheelset(standard("wheelset.force_y = 2e4\nwheelset.roll_moment = 1.4e8\n")); }),
      AllOf(HasSubstr("a wheel lifts"), HasSubstr("wheelset.roll_moment nearer to 0")));
}

} // namespace
