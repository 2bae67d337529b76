#include "bem_contact/scene/network.hpp"

#include "bem_contact/scene/contact_setup.hpp"
#include "bem_contact/scene/warnings.hpp"
#include "tests/base/message.hpp"
#include "tests/base/temporary_folder.hpp"

#include <fmt/format.h>
#include <fstream>
#include <gmock/gmock.h>

namespace bem_contact {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const std::string pair = "rail.profile = '60E1'\nwheel.profile = 'S1002'\nload.force = 1e5\n";

/// The figures of this test are those of the networks' sources, written again.
TEST(Network, GivesTheSameSceneAsItsKeysSpelledOut) {
  for (const auto& [network, keys] :
       {std::pair{"UIC", "gauge = 1435\ngauge_height = 14\nback_to_back = 1360\nrail_inclination = 0.025"},
        {"GB", "gauge = 1435\ngauge_height = 14\nback_to_back = 1360\nrail_inclination = 0.05"},
        {"China", "gauge = 1435\ngauge_height = 16\nback_to_back = 1353\nrail_inclination = 0.025"},
        {"AREMA", "gauge = 1435.1\ngauge_height = 15.9\nback_to_back = 1355.7\nrail_inclination = 0.025"}}) {
    const std::string named = fmt::format("[track]\nnetwork = '{}'\n", network);
    const SceneFile by_name = parse_scene_file(pair + named);
    SceneFile by_keys = parse_scene_file(pair + "[position]\n" + keys + "\ntape_circle = 70\n");
    by_keys.track.network = by_name.track.network;
    EXPECT_TRUE(by_name == by_keys) << network;
    EXPECT_TRUE(parse_scene_file(scene_with_defaults(by_name)) == by_name) << network;
  }
  EXPECT_TRUE(parse_scene_file(pair + "track.network = 'none'\n") == parse_scene_file(pair));
}

/// Digit for digit: where the rigid bodies touch.
TEST(Network, PutsTheWheelWhereItsKeysPutIt) {
  const auto touch = [](const std::string& more) {
    const SceneFile scene = parse_scene_file(pair + more);
    return set_up_contact(scene, read_profiles(scene)).wheel_rail()->touch.front();
  };
  const TouchPoint by_name = touch("position.lateral = 5.5\ntrack.network = 'GB'\n");
  const TouchPoint by_keys = touch("position.lateral = 5.5\nposition.rail_inclination = 0.05\n");
  EXPECT_EQ(by_name.rail_s, by_keys.rail_s);
  EXPECT_EQ(by_name.wheel_s, by_keys.wheel_s);
  EXPECT_NE(by_name.rail_s, touch("position.lateral = 5.5\n").rail_s);
}

TEST(Network, EachOfItsValuesIsOverriddenByItsKey) {
  const SceneFile chinese = parse_scene_file(pair + "track.network = 'China'\n");
  for (const auto& [key, member] : {std::pair{"gauge", &WheelsetPosition::gauge},
                                    {"gauge_height", &WheelsetPosition::gauge_height},
                                    {"back_to_back", &WheelsetPosition::back_to_back},
                                    {"rail_inclination", &WheelsetPosition::rail_inclination}}) {
    SceneFile expected = chinese;
    const WheelsetPosition defaults;
    expected.position.*member = defaults.*member; // the key's own default, given: no "not given"
    const SceneFile given = parse_scene_file(
        pair + fmt::format("track.network = 'China'\nposition.{} = {:.17g}\n", key, defaults.*member));
    EXPECT_TRUE(given == expected) << key;
  }
}

TEST(Network, IsNamedWithAllItsValues) {
  EXPECT_EQ(
      track_text(parse_scene_file(pair + "track.network = 'China'\n")),
      "track: China, gauge 1435 mm (16 mm below the top), flange backs 1353 mm apart, tape circle 70 mm "
      "from the back, rail inclined by 1:40");
  EXPECT_THAT(track_text(parse_scene_file(pair)),
              HasSubstr("it stands upright (position.rail_inclination is 0)"));
  EXPECT_THAT(track_text(parse_scene_file(pair + "track.network = 'UIC'\nposition.rail_inclination = 0\n")),
              Not(HasSubstr("neither")));
}

/// American wheels: no source confirms where their tape circle is, so it is asked for.
TEST(Network, AsksForATapeCircleThatNoSourceConfirms) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "wheel.txt") << "-70 5\n-55 28\n-40 15\n0 0\n60 -2\n";
  const std::string wheel = "rail.profile = '60E1'\nload.force = 1e5\nwheel.profile = '" +
                            (folder.path() / "wheel.txt").string() + "'\ntrack.network = 'AREMA'\n";
  EXPECT_THAT(message_of([&] { parse_scene_file(wheel); }),
              HasSubstr("no source confirms one for AREMA, and"));
  const SceneFile scene = parse_scene_file(wheel + "position.tape_circle = 77.8\n");
  EXPECT_EQ(scene.position.tape_circle, 77.8);
  EXPECT_EQ(scene.wheel.reading.tape_circle, 77.8); // where wheel.flange_back puts y = 0
}

/// A wheel with another tape circle stands farther out by the difference, with the same flange.
TEST(Network, ATapeCircleMovesTheWheelFromItsFlangeBack) {
  const TemporaryFolder folder;
  std::ofstream file(folder.path() / "wheel.txt");
  const SceneFile standard = parse_scene_file(pair);
  const TabulatedProfile wheel = read_profiles(standard).wheel;
  for (double s = wheel.s_begin(); s <= wheel.s_end(); s += 0.25)
    file << wheel.at(s).position.y + 70 << ' ' << wheel.at(s).position.z << '\n';
  file.close();
  const auto pose = [&](const std::string& more) {
    const SceneFile scene =
        parse_scene_file("rail.profile = '60E1'\nload.force = 1e5\nwheel.flange_back = 0\nwheel.profile = '" +
                         (folder.path() / "wheel.txt").string() + "'\n" + more);
    const WheelRailProfiles read = read_profiles(scene);
    return place(scene.position, read.rail, read.wheel);
  };
  const WheelOnRail usual = pose(""), american = pose("position.tape_circle = 77.8\n");
  EXPECT_NEAR(american.wheel_pose.origin.y - usual.wheel_pose.origin.y, 7.8, 1e-12);
  const auto flange_back = [](const WheelOnRail& p) {
    return p.wheel_pose.origin.y + p.wheel.nodes().back().position.y;
  };
  EXPECT_NEAR(flange_back(american), flange_back(usual), 1e-9);
  EXPECT_THAT(message_of([&] { read_profiles(parse_scene_file(pair + "position.tape_circle = 77.8\n")); }),
              HasSubstr("The tape circle of S1002 is 70 mm from its flange back"));
}

} // namespace
} // namespace bem_contact
