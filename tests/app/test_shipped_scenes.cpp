#include "bem_contact/base/input_file.hpp"
#include "tests/app/run_program.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <regex>

namespace {

using namespace bem_contact;
using nlohmann::json;

class ShippedScenes : public ProgramTest {};

TEST_F(ShippedScenes, OfRollersCurvesAndInclinationsToo) {
  const auto answer = [this](const std::string& command, const std::string& name) {
    const Outcome r = run(command + " '" CONFORMAL_SOURCE_DIR "/data/scenes/" + name + ".toml' --json");
    EXPECT_EQ(r.code, 0) << name << ": " << r.err;
    return json::parse(r.out);
  };
  const auto number = [](const json& j, const char* table, const char* name) {
    return j[table][name].get<double>();
  };
  const json rig = answer("solve", "roller_rig");
  EXPECT_GT(std::hypot(number(rig, "quantities", "Fx"), number(rig, "quantities", "Fs")),
            0.995 * 0.3 * 19797);
  const json face = answer("solve", "lubricated_gauge_face");
  EXPECT_LT(std::hypot(number(face, "quantities", "Fx"), number(face, "quantities", "Fs")), 0.2 * 91883);
  EXPECT_NEAR(number(answer("solve", "flexible_wheelset"), "quantities", "Fy"), -15476, 352);
  const json curve = answer("wheelset", "curved_track");
  EXPECT_NEAR(number(curve, "wheelset", "curve_force"), 2982, 1);
  EXPECT_NEAR(number(curve, "wheelset", "Fy"), 3000 + 2982, 1);
  EXPECT_NEAR(number(curve, "wheelset", "curve_radius_difference"), 1.38, 1e-9);
  const json unequal = answer("wheelset", "unequal_wheels");
  EXPECT_NEAR(number(unequal, "wheelset", "roll"), 0.29e-3, 0.005e-3);
  EXPECT_NEAR(unequal["right"]["track"]["Fx"].get<double>(), 4459, 150);
}

/// The scenes that are shipped for the closed forms give what their first lines say.
TEST_F(ShippedScenes, GiveWhatTheirFirstLinesSay) {
  const auto solved = [this](const std::string& name, const std::string& warning = "") {
    const Outcome r = run("solve '" CONFORMAL_SOURCE_DIR "/data/scenes/" + name + ".toml' --json");
    EXPECT_EQ(r.code, 0) << name << ": " << r.err;
    EXPECT_EQ(r.err.empty(), warning.empty()) << name << r.err;
    EXPECT_THAT(r.err, testing::HasSubstr(warning)) << name;
    return json::parse(r.out);
  };
  const auto creepage = [](const json& j) { return j["quantities"]["creepage_x"].get<double>(); };
  const json carter = solved("carter"); // and as exactly as it states
  EXPECT_NEAR(carter["quantities"]["Fx"].get<double>(), 68700, 0.005 * 68700);
  EXPECT_NEAR(carter["quantities"]["Fx"].get<double>(), 68700,
              carter["quantities"]["Fx_error"].get<double>());
  EXPECT_NEAR(carter["quantities"]["pmax"].get<double>(), 113.889,
              carter["quantities"]["pmax_error"].get<double>());
  EXPECT_NEAR(solved("persson_tangent_plane")["quantities"]["pmax"].get<double>(), 14.235, 0.002 * 14.235);
  EXPECT_NEAR(creepage(solved("cattaneo")), 0.0081724, 0.005 * 0.0081724);
  EXPECT_NEAR(creepage(solved("cattaneo_to_carter")), 2.4e-4, 0.01 * 2.4e-4);
  const json unlike = solved("unlike_materials");
  EXPECT_NEAR(creepage(unlike), 5.263e-4, 0.003 * 5.263e-4);
  EXPECT_GT(unlike["solver"]["outer_rate"].get<double>(), 0);
  EXPECT_LT(unlike["solver"]["outer_rate"].get<double>(), 0.1);
  const json spin = solved("pure_spin");
  EXPECT_NEAR(spin["quantities"]["Fz"].get<double>(), 8200, 0.005 * 8200);
  EXPECT_NEAR(spin["quantities"]["Mz"].get<double>(), 4347, 0.005 * 4347);
  std::vector<double> shear; // below one point
  const json below = solved("stresses");
  for (const json& depth : below["stresses"]["largest_shear"][0][0])
    shear.push_back(depth.get<double>());
  const auto largest = std::ranges::max_element(shear);
  EXPECT_NEAR(*largest, 313.1, 0.005 * 313.1);
  EXPECT_EQ(largest - shear.begin(), 4) << "in the depth of .33 mm";
  const json still = solved("rolling_over_a_grid");
  EXPECT_EQ(still["history"].size(), 33u);
  EXPECT_GT(still["history"][32]["Fx"].get<double>(), 2 * still["history"][4]["Fx"].get<double>());
  const json along = solved("friction_along_s", "depend on the size of the elements");
  EXPECT_LT(along["quantities"]["Fx"].get<double>(), 0.25 * 15000);
  const json falling = solved("falling_friction");
  EXPECT_NEAR(falling["quantities"]["Fx"].get<double>(), 33082, 0.001 * 33082);
  EXPECT_NEAR(falling["quantities"]["Tmax_rail"].get<double>(), 67.3, 0.5);
  const json turned = solved("turned_ellipse");
  EXPECT_NEAR(turned["quantities"]["pmax"].get<double>(), 813.1, 0.002 * 813.1);
  EXPECT_NEAR(turned["quantities"]["Fs"].get<double>(), 3000, 3000 * 1e-6);
  EXPECT_GT(turned["quantities"]["creepage_s"].get<double>(), 0);
  const json tables = solved("by_tables");
  ASSERT_EQ(tables["history"].size(), 3u);
  for (const json& step : tables["history"])
    EXPECT_NEAR(step["Fx"].get<double>(), 914.3, 0.012 * 914.3);
  std::string longer = read_text_file(CONFORMAL_SOURCE_DIR "/data/scenes/by_tables.toml", "scene");
  longer = std::regex_replace(longer, std::regex("steps = 3"), "steps = 40");
  longer = std::regex_replace(longer, std::regex("\"by_"), "\"" CONFORMAL_SOURCE_DIR "/data/scenes/by_");
  const Outcome returned = run("solve '" + write("longer.toml", longer).string() + "' --json");
  ASSERT_EQ(returned.code, 0) << returned.err;
  EXPECT_NEAR(json::parse(returned.out)["quantities"]["Fx"].get<double>(), 914.34, 1e-4 * 914.34)
      << "back at steady rolling, which the first step had left";
  // Of the scene with influence files, which take a minute to make, the half-space part; the rest is in
  // end_to_end.
  std::string ring = read_text_file(CONFORMAL_SOURCE_DIR "/data/scenes/ring_and_roller.toml", "scene");
  ring = std::regex_replace(ring, std::regex("(influence|structural) = .*"), "");
  const Outcome rolled = run("solve '" + write("ring.toml", ring).string() + "' --json");
  ASSERT_EQ(rolled.code, 0) << rolled.err;
  EXPECT_NEAR(json::parse(rolled.out)["quantities"]["Fx"].get<double>(), 909, 0.002 * 909);
  EXPECT_NEAR(json::parse(rolled.out)["quantities"]["pmax"].get<double>(), 629, 0.002 * 629);
  EXPECT_NEAR(solved("by_height")["quantities"]["Fz"].get<double>(), 80700, 0.002 * 80700);
  // Its profiles scatter as measured ones do; what is said of their smoothing is no matter here.
  const Outcome curved = run("solve '" CONFORMAL_SOURCE_DIR "/data/scenes/wheelset_in_a_curve.toml' --json");
  ASSERT_EQ(curved.code, 0) << curved.err;
  EXPECT_THAT(curved.err, ::testing::Not(::testing::HasSubstr("does not converge")));
  const json curve = json::parse(curved.out)["quantities"];
  EXPECT_NEAR(curve["Fz"].get<double>(), 8e4, 0.1);
  EXPECT_LT(curve["Fx"].get<double>(), -2e4) << "a driven wheel pushes the rail back";
}

} // namespace
