#include "bem_contact/h5/table.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "bem_contact/profile/worn/nominal_place.hpp"
#include "tests/app/run_program.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace {

using namespace bem_contact;
using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

class ConicityCommand : public ProgramTest {
protected:
  static double at(const json& table, const char* over, double where, const char* column) {
    for (std::size_t i = 0; i < table[over].size(); ++i)
      if (std::abs(table[over][i].get<double>() - where) < 1e-9)
        return table[column][i].get<double>();
    return NAN;
  }
  /// A cone of slope 0.05, as points.
  std::string cone() const { return write("cone.txt", "60 -3\n30 -1.5\n0 0\n-30 1.5\n-60 3\n").string(); }
};

TEST_F(ConicityCommand, AConeHasKlingelsWavelength) {
  const Outcome r = run("conicity --rail 60E1 --wheel '" + cone() + "' --json");
  ASSERT_EQ(r.code, 0) << r.err;
  const json j = json::parse(r.out);
  for (const double amplitude : {1.0, 5.0, 10.0}) {
    EXPECT_NEAR(at(j["conicity"], "amplitude", amplitude, "tan_gamma"), 0.05, 1e-6);
    EXPECT_NEAR(at(j["conicity"], "amplitude", amplitude, "wavelength"),
                2 * M_PI * std::sqrt(750 * 460 / 0.05), 0.5);
  }
  EXPECT_NEAR(at(j["function"], "lateral", -7, "difference"), -0.7, 1e-6);
}

/// 60E1 as it lies in the track: with rail_inclination = 0 it gives what the inclined standard gives, and a
/// warning with both.
TEST_F(ConicityCommand, ARailThatIsInclinedTwiceIsSaid) {
  const ProfileCurve upright = standard_profile("60E1");
  const NominalPlace in_track{{-7, 0}, -0.025};
  std::string points;
  for (double s = upright.s_begin(); s <= upright.s_end(); s += 0.2) {
    const Point2 p = in_track.to_measured(upright.at(s).position);
    points += fmt::format("{:.6f} {:.6f}\n", p.y, p.z);
  }
  const std::string command = "conicity --json --wheel S1002 --rail ";
  const std::string measured = command + "'" + write("rail.txt", points).string() + "' ";
  const Outcome once = run(measured), standard = run(command + "60E1 --rail-inclination 0.025");
  ASSERT_EQ(once.code, 0) << once.err;
  EXPECT_THAT(once.err, Not(HasSubstr("inclined")));
  EXPECT_NEAR(at(json::parse(once.out)["conicity"], "amplitude", 3, "tan_gamma"),
              at(json::parse(standard.out)["conicity"], "amplitude", 3, "tan_gamma"), 2e-3);
  EXPECT_THAT(run(measured + "--rail-inclination 0.025").err, HasSubstr("already inclined (about 1:40)"));
  const std::string left =
      command + "60E1 --rail-inclination 0.025 --left-rail '" + (folder_ / "rail.txt").string() + "'";
  EXPECT_THAT(run(left).err, HasSubstr("left rail: the rail's file is already inclined (about 1:40)"));
}

TEST_F(ConicityCommand, TextJsonCsvAndHdf5AgreeAndTheHelpIsRight) {
  const std::string wheelset = "conicity --wheel S1002 --rail 60E1 --rail-inclination 0.025 ";
  const std::string files =
      "--csv '" + (folder_ / "c.csv").string() + "' -o '" + (folder_ / "c.h5").string() + "'";
  const Outcome text = run(wheelset + files), as_json = run(wheelset + "--json");
  ASSERT_EQ(text.code, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("     3     0.1741         8.844    -3.000     3.000\n")); // as --help says
  const std::string page = text_of(CONFORMAL_SOURCE_DIR "/data/tutorial/conicity.md");
  for (const char* start :
       {"        0.0 ", "        1.0 ", "        3.0 ", "             1 ", "             3 "})
    EXPECT_THAT(page, HasSubstr(text.out.substr(text.out.find(start), 50))) << start;
  const Outcome help = run("conicity --help");
  EXPECT_THAT(help.out, HasSubstr("0.1741"));
  EXPECT_THAT(help.out, HasSubstr("8.844"));
  const json j = json::parse(as_json.out);
  const H5Table table = read_h5(folder_ / "c.h5");
  for (const char* group : {"function", "conicity"})
    for (const auto& [name, values] : j[group].items()) {
      const H5Dataset& data = table.datasets.at(std::string(group) + "/" + name);
      EXPECT_FALSE(data.unit.empty());
      EXPECT_EQ(data.values, values.get<std::vector<double>>()) << name;
    }
  EXPECT_THAT(run("info '" + (folder_ / "c.h5").string() + "'").out,
              HasSubstr("conicity/tan_gamma [10]: equivalent conicity"));
  const std::string csv = text_of(folder_ / "c.csv");
  EXPECT_THAT(csv, HasSubstr("lateral_mm,difference_mm,tan_difference,roll_rad,"));
  EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + j["function"]["lateral"].size());
}

TEST_F(ConicityCommand, TakesASceneAndAnotherLeftWheel) {
  const std::string scene =
      write("s.toml", "rail.profile = \"60E1\"\nwheel.profile = \"S1002\"\nload.force = 1e5\n"
                      "position.rail_inclination = 0.025\nposition.lateral = 5\n")
          .string();
  const Outcome same = run("conicity '" + scene + "' --json"),
                other = run("conicity '" + scene + "' --json --left-wheel '" + cone() + "'");
  ASSERT_EQ(same.code, 0) << same.err;
  ASSERT_EQ(other.code, 0) << other.err;
  const json a = json::parse(same.out), b = json::parse(other.out);
  EXPECT_NEAR(at(a["conicity"], "amplitude", 3, "tan_gamma"), 0.1741, 1e-4);
  EXPECT_NEAR(at(a["function"], "lateral", 0, "difference"), 0, 1e-9);
  EXPECT_EQ(b["left"]["wheel"].get<std::string>().find("S1002"), std::string::npos);
  EXPECT_EQ(at(a["function"], "lateral", 2, "right_radius"), at(b["function"], "lateral", 2, "right_radius"));
  EXPECT_NE(at(a["function"], "lateral", 2, "left_radius"), at(b["function"], "lateral", 2, "left_radius"));
}

TEST_F(ConicityCommand, TheFileKeepsItsInputs) {
  const std::string file = (folder_ / "c.h5").string();
  ASSERT_EQ(
      run("conicity --rail 60E1 --wheel S1002 --to 1 --left-wheel '" + cone() + "' -o '" + file + "'").code,
      0);
  const H5Table table = read_h5(file);
  EXPECT_EQ(text_attribute(table, "inputs/rail.profile/name"), "60E1");
  EXPECT_EQ(text_attribute(table, "inputs/left_wheel.profile/name"), "cone.txt");
  EXPECT_EQ(text_attribute(table, "inputs/left_wheel.profile/sha256").size(), 64u);
  EXPECT_EQ(table.texts.at("inputs/left_wheel.profile/content").text, text_of(folder_ / "cone.txt"));
  EXPECT_FALSE(text_attribute(table, "commit").empty());
  EXPECT_THAT(run("info --scene-with-defaults '" + file + "'").out, HasSubstr("profile = \"S1002\""));
}

TEST_F(ConicityCommand, SaysWhatIsMissingOrWrong) {
  const auto refused = [&](const std::string& arguments, const char* word) {
    const Outcome r = run("conicity " + arguments);
    EXPECT_EQ(r.code, 2) << arguments;
    EXPECT_EQ(r.out, "");
    EXPECT_THAT(r.err, HasSubstr(word));
  };
  refused("--wheel S1002", "--rail is not given (without a scene it says what touches)");
  refused("--wheel S1002 --rail 60E9", "60E1");
  refused("--wheel S1002 --rail 60E1 --to 60", "at most 45 mm");
  refused("--wheel S1002 --rail 60E1 --step 0", "above 0");
  refused("--wheel S1002 --rail 60E1 --rail-inclination 1:40", "1:40 is a fraction: write 0.025");
  refused("--wheel S1002 --rail 60E1 --rail-inclination 1/20", "write 0.05");
  refused("--wheel S1002 --rail 60E1 --wheel-radius -5", "wheel_radius");
  const std::string profile = cone();
  refused("--rail 60E1 --wheel '" + profile + "' --csv '" + profile + "'", "cone.txt");
}

/// Each line of a map is what the command says of that wheelset alone, but for the place of a jump of the
/// contact; a pattern names files.
TEST_F(ConicityCommand, AMapHasTheNumbersOfSingleWheelsets) {
  cone();
  write("steep.txt", "60 -6\n30 -3\n0 0\n-30 3\n-60 6\n");
  const std::string pattern = "\"" + (folder_ / "*.txt").string() + "\"",
                    file = (folder_ / "map.h5").string();
  const Outcome r = run("conicity --wheels " + pattern +
                        " S1002 --rails 60E1 54E1 --rail-inclination 0.025 --gauges "
                        "1433:1437:3 --json -o '" +
                        file + "' --csv '" + (folder_ / "map.csv").string() + "'");
  ASSERT_EQ(r.code, 0) << r.err;
  const json map = json::parse(r.out)["map"];
  ASSERT_EQ(map["tan_gamma"].size(), 18u);
  for (std::size_t i = 0; i < 18; ++i) {
    const std::string wheel = std::vector<std::string>{"'" + (folder_ / "cone.txt").string() + "'",
                                                       "'" + (folder_ / "steep.txt").string() + "'",
                                                       "S1002"}[i / 6],
                      rail = i / 3 % 2 ? "54E1" : "60E1";
    const Outcome one =
        run(fmt::format("conicity --wheel {} --rail {} --rail-inclination 0.025 --gauge {} --json", wheel,
                        rail, 1433 + 2 * (i % 3)));
    const json alone = json::parse(one.out);
    EXPECT_NEAR(map["tan_gamma"][i].get<double>(), at(alone["conicity"], "amplitude", 3, "tan_gamma"), 1e-8)
        << i;
    EXPECT_EQ(map["gauge"][i].get<double>(), 1433.0 + 2 * static_cast<double>(i % 3));
    if (i >= 12) { // cones of points have no flange
      EXPECT_NEAR(map["nonlinearity"][i].get<double>(), alone["nonlinearity"].get<double>(), 1e-9);
      EXPECT_NEAR(map["play"][i].get<double>(), alone["play"].get<double>(), 1e-12);
    }
  }
  EXPECT_NEAR(map["tan_gamma"][0].get<double>(), 0.05, 1e-6);
  EXPECT_NEAR(map["tan_gamma"][6].get<double>(), 0.1, 1e-6);
  const H5Table stored = read_h5(file);
  EXPECT_EQ(stored.datasets.at("map/tan_gamma").values, map["tan_gamma"].get<std::vector<double>>());
  EXPECT_THAT(text_of(folder_ / "map.csv"), HasSubstr("\n\"S1002\",\"54E1\",1437,"));
}

/// Without noise nothing scatters; a seed says it all, also of a pair in a larger map; more noise scatters
/// more.
TEST_F(ConicityCommand, NoiseOfProfilesScattersTheConicity) {
  const auto spread = [&](const std::string& more, const char* column = "tan_gamma_spread") {
    const Outcome r = run("conicity --rail 60E1 --rail-inclination 0.025 --draws 6 --json " + more);
    EXPECT_EQ(r.code, 0) << r.err;
    return json::parse(r.out)["map"][column].get<std::vector<double>>();
  };
  EXPECT_EQ(spread("--wheel S1002 --noise 0"), std::vector<double>{0});
  const double little = spread("--wheel S1002 --noise 0.002").at(0),
               much = spread("--wheel S1002 --noise 0.02").at(0);
  EXPECT_GT(little, 0);
  EXPECT_GT(much, 2 * little);
  EXPECT_EQ(spread("--wheel S1002 --noise 0.002").at(0), little);
  EXPECT_NE(spread("--wheel S1002 --noise 0.002 --seed 2").at(0), little);
  EXPECT_EQ(spread("--wheels LMA S1002 --gauges 1434:1435:2 --noise 0.002").at(3), little);
  EXPECT_NEAR(spread("--wheel S1002 --noise 0.002", "tan_gamma_mean").at(0), 0.1741, 0.02);
}

TEST_F(ConicityCommand, MapsThatCannotBeMadeAreRefused) {
  for (const auto& [line, words] :
       {std::pair{"--wheels 'no_such_*.whl' --rail 60E1", "no file has a name like this"},
        {"--wheels S1002 --rail 60E1 --gauges 1430:1440", "FROM:TO:COUNT"},
        {"--wheels S1002 --rail 60E1 --left-wheel LMA", "both sides have the same profiles"},
        {"--wheels S1002", "--rail is not given"},
        {"--wheels S1002 60E1 --rail 60E1", "60E1 is the profile of a rail"}}) {
    const Outcome r = run(std::string("conicity ") + line);
    EXPECT_EQ(r.code, 2) << line;
    EXPECT_THAT(r.err, HasSubstr(words)) << line;
  }
}

} // namespace
