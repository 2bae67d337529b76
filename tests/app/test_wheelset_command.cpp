#include "bem_contact/h5/table.hpp"
#include "tests/app/run_program.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace {

using namespace bem_contact;
using nlohmann::json;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;

const std::string in_a_curve = "'" CONFORMAL_SOURCE_DIR "/data/scenes/wheelset.toml'";

class WheelsetCommand : public ProgramTest {};

TEST_F(WheelsetCommand, TextJsonHdf5AndVtkAgreeAndThePagesAreRight) {
  const std::string h5 = (folder_ / "w.h5").string();
  const Outcome text =
      run("wheelset " + in_a_curve + " -o '" + h5 + "' --vtk-prefix '" + (folder_ / "w").string() + "'");
  ASSERT_EQ(text.code, 0) << text.err;
  EXPECT_THAT(text.out, ContainsRegex("Left wheel\ntrack: gauge 1435 mm[^\n]*\nmodel: halfspace"));
  const std::string page = text_of(CONFORMAL_SOURCE_DIR "/data/tutorial/wheelset.md");
  for (const char* start : {"  share ", "  Fz ", "  Fy ", "  radius "})
    EXPECT_THAT(page, HasSubstr(text.out.substr(text.out.find(start), 50))) << start;
  const json j = json::parse(run("wheelset " + in_a_curve + " --json").out);
  EXPECT_TRUE(j["certified"].get<bool>());
  EXPECT_NEAR(j["wheelset"]["Fy"].get<double>(), 2e4, 0.4);
  EXPECT_EQ(j["left"]["result"]["quantities"]["Fz"], j["left"]["track"]["Fz"]);
  const H5Table table = read_h5(h5);
  for (const auto& [name, value] : j["wheelset"].items())
    if (!value.is_null()) {
      EXPECT_EQ(table.datasets.at("wheelset/" + name).values.at(0), value.get<double>()) << name;
    }
  for (const char* side : {"right", "left"}) {
    EXPECT_EQ(table.datasets.at(std::string(side) + "/track/Fy").values.at(0),
              j[side]["track"]["Fy"].get<double>());
    for (const std::string stated : {"Fy_error", "Fz_error", "pmax_error", "area_error", "T_gamma_error"}) {
      const json& error = j[side]["track"][stated];
      EXPECT_GT(error.get<double>(), 0) << stated;
      EXPECT_EQ(error, j[side]["result"]["quantities"][stated]) << stated;
      EXPECT_EQ(table.datasets.at(side + ("/track/" + stated)).values.at(0), error.get<double>()) << stated;
    }
    EXPECT_EQ(table.datasets.at(std::string(side) + "/result/p_n").shape.size(), 2u);
    EXPECT_TRUE(std::filesystem::exists(folder_ / (std::string("w_") + side + ".vts")));
  }
  EXPECT_THAT(run("info '" + h5 + "'").out, HasSubstr("Both wheels of a wheelset"));
  EXPECT_THAT(run("info --scene '" + h5 + "'").out, HasSubstr("force_y = 2e4"));
  const Outcome repeated = run("solve '" + h5 + "'");
  EXPECT_EQ(repeated.code, 2);
  EXPECT_THAT(repeated.err, HasSubstr("both wheels of a wheelset"));
  EXPECT_THAT(repeated.err, HasSubstr("give it to bem_contact wheelset"));
}

TEST_F(WheelsetCommand, AForceInKilonewtonsIsSaid) {
  const std::string text =
      "rail.profile = '60E1'\nwheel.profile = 'S1002'\nposition.rail_inclination = 0.025\n"
      "motion.friction = 0.3\nwheelset.force = ";
  for (const char* command : {"check", "wheelset"}) {
    const std::string small = write("small.toml", text + "200\n").string();
    const Outcome r = run(std::string(command) + " '" + small + "'");
    EXPECT_THAT(r.out + r.err, HasSubstr("wheelset.force looks like kN (200 N on an axle). Give it in N."));
  }
  EXPECT_THAT(run("check '" + write("usual.toml", text + "2e5\n").string() + "'").out,
              ::testing::Not(HasSubstr("kN")));
}

TEST_F(WheelsetCommand, SaysWhatIsWrong) {
  const Outcome one = run("wheelset '" CONFORMAL_SOURCE_DIR "/data/scenes/conformal_small.toml'");
  EXPECT_EQ(one.code, 2);
  EXPECT_THAT(one.err, HasSubstr("[wheelset]"));
  const Outcome solve = run("solve " + in_a_curve);
  EXPECT_EQ(solve.code, 2);
  EXPECT_THAT(solve.err, HasSubstr("bem_contact wheelset"));
  EXPECT_EQ(run("wheelset " + in_a_curve + " -o " + in_a_curve).code, 2);
}

} // namespace
