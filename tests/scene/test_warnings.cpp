#include "bem_contact/scene/warnings.hpp"

#include "bem_contact/profile/standard_profiles.hpp"
#include "bem_contact/profile/worn/nominal_place.hpp"
#include "bem_contact/scene/scene_reader.hpp"
#include "tests/base/message.hpp"
#include "tests/base/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>

namespace bem_contact {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> warnings_of(const std::string& more) {
  const SceneFile scene =
      parse_scene_file("rail.profile = '60E1'\nwheel.profile = 'S1002'\nload.force = 1e5\n"
                       "grid.dx = 1.0\ngrid.ds = 0.5\n" +
                       more);
  return input_warnings(scene, set_up_contact(scene, read_profiles(scene))).texts();
}

TEST(Warnings, OrdinaryScenesRaiseNone) {
  for (const char* more :
       {"", "position.lateral = 6.7", "position.lateral = -9", "position.wheel_radius = 330",
        "motion.rolling_radius = 455", "motion.friction = 0.6\nposition.yaw = 0.02",
        "motion.speed = 3e4\nmotion.pitch_rate = 66\nmotion.lateral_velocity = 100"})
    EXPECT_THAT(warnings_of(more), IsEmpty()) << more;
}

TEST(Warnings, OtherUnitsAndDiametersAreSaid) {
  EXPECT_THAT(warnings_of("motion.friction = 30"), ElementsAre(HasSubstr("it is no percentage")));
  EXPECT_THAT(warnings_of("rail.material.young = 2.1e11"),
              ElementsAre(HasSubstr("rail.material: a Young's modulus of 2.1e+11 MPa")));
  EXPECT_THAT(warnings_of("rail.material.young = 210"),
              ElementsAre(HasSubstr("a Young's modulus of 210 MPa")));
  EXPECT_THAT(warnings_of("motion.phi = 0.7"), ElementsAre(HasSubstr("spin of a radius of 1.43 mm")));
  EXPECT_THAT(warnings_of("position.lateral = -20"),
              ElementsAre(HasSubstr("the other wheel's flange over its own")));
  EXPECT_THAT(warnings_of("position.wheel_radius = 920"), ElementsAre(HasSubstr("not the diameter")));
  EXPECT_THAT(warnings_of("motion.speed = 20\nmotion.pitch_rate = 43.5"),
              ElementsAre(HasSubstr("a rolling radius of 0.4598 mm on a wheel of 460 mm")));
  EXPECT_THAT(warnings_of("motion.rolling_radius = 0.46"), ElementsAre(HasSubstr("it slides")));
  EXPECT_THAT(warnings_of("motion.speed = 20\nmotion.lateral_velocity = 30"),
              ElementsAre(HasSubstr("lateral_velocity is 1.5 times motion.speed")));
}

TEST(Warnings, FrictionAboveOneAndForcesInKilonewtonsAreSaid) {
  EXPECT_THAT(warnings_of("motion.friction = 0.9"), IsEmpty());
  EXPECT_THAT(warnings_of("motion.friction = 1.1"), ElementsAre(HasSubstr("motion.friction = 1.1")));
  const SceneFile scene =
      parse_scene_file("rail.profile = '60E1'\nwheel.profile = 'S1002'\nload.force = 100\n"
                       "grid.dx = 1.0\ngrid.ds = 0.5\n");
  EXPECT_THAT(input_warnings(scene, set_up_contact(scene, read_profiles(scene))).texts(),
              ElementsAre(HasSubstr("load.force looks like kN (100 N on a wheel)")));
}

/// 60E1 as it lies in the track, inclined 1:40 towards the centre.
TEST(Warnings, ARailThatIsInclinedTwiceIsSaid) {
  const TemporaryFolder folder;
  const ProfileCurve upright = standard_profile("60E1");
  const NominalPlace in_track{{-7.5, 0.1}, -std::atan(1 / 40.0)};
  std::ofstream file(folder.path() / "rail.txt");
  for (double s = upright.s_begin(); s <= upright.s_end(); s += 0.4) {
    const Point2 p = in_track.to_measured(upright.at(s).position);
    file << p.y << ' ' << p.z << '\n';
  }
  file.close();
  const std::string rail = "rail.profile = '" + (folder.path() / "rail.txt").string() + "'\n";
  const auto warnings = [&](const std::string& more) {
    const SceneFile scene = parse_scene_file(rail + "wheel.profile = 'S1002'\nload.force = 1e5\n" + more);
    return input_warnings(scene, set_up_contact(scene, read_profiles(scene))).texts();
  };
  EXPECT_THAT(warnings(""), IsEmpty());
  EXPECT_THAT(
      warnings("position.rail_inclination = 0.025"),
      ElementsAre(HasSubstr(
          "the rail's file is already inclined (about 1:40), and position.rail_inclination = 0.025")));
}

/// Scenes of earlier versions are read, and say what the key is called now.
TEST(Warnings, AKeyUnderItsFormerNameIsReadWithARemark) {
  const std::string text = "rail.profile = '60E1'\nwheel.profile = 'S1002'\nload.force = 1e5\n";
  const SceneFile scene = parse_scene_file(text + "position.cant = 0.025\n");
  EXPECT_EQ(scene.position.rail_inclination, 0.025);
  EXPECT_THAT(input_warnings(scene, set_up_contact(scene, read_profiles(scene))).texts(),
              ElementsAre("position.cant is now called position.rail_inclination"));
  SceneReader changed{SceneText(text)};
  changed.set({"position.cant", 0.05});
  EXPECT_EQ(changed.scene().position.rail_inclination, 0.05);
  EXPECT_THAT(
      message_of([&] { parse_scene_file(text + "[position]\ncant = 0.025\nrail_inclination = 0.025\n"); }),
      HasSubstr("is the same key under its former name) Give one of them."));
  EXPECT_THAT(message_of([&] { parse_scene_file(text + "position.cant = 0.7\n"); }),
              HasSubstr("position.rail_inclination = 0.7 (out of range)"));
}

/// Only an inclination makes it a warning.
TEST(Warnings, NobodyLooksForAnInclinationThatTurnsNothing) {
  const SceneFile scene =
      parse_scene_file("rail.profile = '" CONFORMAL_SOURCE_DIR
                       "/data/bodies/worn_rail.txt'\nwheel.profile = 'S1002'\nload.force = 1e4\n");
  const ContactSetup setup = set_up_contact(scene, read_profiles(scene));
  const RailInclination& inclination = setup.wheel_rail()->rail_inclination;
  const auto known = [&] {
    return inclination.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  };
  input_warnings(scene, setup);
  EXPECT_FALSE(known());
  SceneFile canted = scene;
  canted.position.rail_inclination = 0.025;
  input_warnings(canted, setup);
  EXPECT_TRUE(known());
}

TEST(Warnings, AWheelOnItsFlangeIsSaid) {
  EXPECT_THAT(warnings_of("position.lateral = 60"), ElementsAre(HasSubstr("the tip of its flange")));
  EXPECT_THAT(warnings_of("position.lateral = 60"),
              ElementsAre(testing::AllOf(HasSubstr("y = -55."), HasSubstr("wheel.flange_back"))));
}

/// S1002 leaves 6 mm between its flange and the gauge face of 60E1.
TEST(Warnings, AWheelsetWithoutPlayIsSaid) {
  EXPECT_THAT(warnings_of("position.back_to_back = 1365"), IsEmpty());
  EXPECT_THAT(warnings_of("position.gauge = 1426"), IsEmpty());
  EXPECT_THAT(warnings_of("position.back_to_back = 1380"),
              ElementsAre(testing::AllOf(HasSubstr("there is no play"), HasSubstr("wheel.flange_back"))));
  EXPECT_THAT(warnings_of("position.gauge = 1415"), ElementsAre(HasSubstr("there is no play")));
}

TEST(Warnings, KeysOfProfileFilesHaveNoEffectOnStandards) {
  EXPECT_THAT(warnings_of("rail.smoothing = 5"),
              ElementsAre(HasSubstr("rail.smoothing: without effect (60E1 is no profile file)")));
  EXPECT_THAT(warnings_of("rail.nominal = '60E1'"),
              ElementsAre(HasSubstr("rail.nominal: without effect (60E1 is no profile file)")));
  EXPECT_THAT(warnings_of("wheel.flange_back = 0\nwheel.mirror = true"),
              ElementsAre(HasSubstr("wheel.mirror, wheel.flange_back: without effect")));
  EXPECT_THAT(warnings_of("rail.y = 3"), ElementsAre(HasSubstr("rail.y: without effect")));
  EXPECT_THAT(warnings_of("rail.place = 'absolute'\nrail.y = 753.5\nposition.gauge = 1450"),
              ElementsAre(HasSubstr("position.gauge: without effect")));
}

TEST(Warnings, APatchHasMaterialsAndFriction) {
  const SceneFile scene = parse_scene_file("kind = 'patch'\nload.force = 1e3\ngrid.mx = 4\ngrid.ms = 4\n"
                                           "motion.friction = 30\nwheel.material.young = 2.1e11\n");
  EXPECT_THAT(input_warnings(scene, set_up_patch(scene)).texts(),
              ElementsAre(HasSubstr("wheel.material"), HasSubstr("friction = 30")));
}

} // namespace
} // namespace bem_contact
