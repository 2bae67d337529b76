#include "bem_contact/explore/changed_text.hpp"

#include <gtest/gtest.h>

namespace bem_contact {

namespace {

using explore::changed_text;

constexpr const char* given = R"(# Räder: S1002 on 60E1
kind = "wheel_rail"
rail.profile = "60E1" # ä, before a value
wheel = { profile = "S1002" }

[position]
lateral = 6.6 # mm

[load]
force = 1e5 # N
[motion]
friction = 0.3
)";

/// What reads the new text gets what the changes ask for.
void expect_same_scene(const std::string& text, const std::vector<SceneChange>& changes) {
  EXPECT_EQ(parse_scene_file({text}), parse_scene_file({given}, changes));
}

} // namespace

TEST(ChangedText, ValuesAreReplacedInPlaceAndAllElseStays) {
  const std::vector<SceneChange> changes{{"position.lateral", 6.75}, {"rail.profile", std::string("54E1")}};
  const std::string text = changed_text({given}, changes);
  std::string wanted = given;
  wanted.replace(wanted.find("6.6"), 3, "6.75");
  wanted.replace(wanted.find("60E1\""), 4, "54E1"); // the one in the comment has no quotation mark
  EXPECT_EQ(text, wanted);
  expect_same_scene(text, changes);
}

TEST(ChangedText, NewKeysGoIntoTheirTables) {
  const std::vector<SceneChange> changes{
      {"position.yaw", 0.002},         {"motion.xi", -1e-3},
      {"layer.compliance", 1.5e-4},    {"wheel.influence", std::string("w.h5")},
      {"wheel.material.young", 2.1e5}, {"solver.model", std::string("halfspace")}};
  const std::string text = changed_text({given}, changes);
  for (const char* part :
       {"[position]\nyaw = 0.002\nlateral = 6.6 # mm\n", "layer.compliance = 0.00015\n", "# Räder"})
    EXPECT_NE(text.find(part), std::string::npos) << part;
  expect_same_scene(text, changes);
}

TEST(ChangedText, AFormThatIsNotForeseenGivesTheWholeScene) {
  // The first line that begins with [ is in a list, not a table.
  const SceneText odd("grid.accuracy_of = \"pmax\"\nstresses.depths = [\n[1.0]\n]\n");
  EXPECT_ANY_THROW(changed_text(odd, {})); // not a scene at all
  const SceneText quoted("kind = \"wheel_rail\"\n\"rail\".profile = \"60E1\"\nwheel.profile = "
                         "\"S1002\"\nload.force = 1e5\n[\"position\"]\nlateral = 1\n");
  const std::vector<SceneChange> changes{{"position.yaw", 0.002}};
  const std::string text = changed_text(quoted, changes);
  EXPECT_EQ(parse_scene_file({text}), parse_scene_file(quoted, changes));
}

} // namespace bem_contact
