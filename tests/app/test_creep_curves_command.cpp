#include "bem_contact/app/commands/creep_curves_command.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/h5/table.hpp"
#include "tests/app/run_program.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace {

using namespace bem_contact;
using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string rolling = "'" CONFORMAL_SOURCE_DIR "/data/scenes/steady_rolling.toml'";

class CreepCurvesCommand : public ProgramTest {};

TEST_F(CreepCurvesCommand, TextJsonCsvAndHdf5AgreeAndTheHelpIsRight) {
  const std::string command = "creep-curves " + rolling + " --xi=-0.001:0.001:3 --phi 0:0.001:2 ";
  const Outcome text =
      run(command + "--csv '" + (folder_ / "c.csv").string() + "' -o '" + (folder_ / "c.h5").string() + "'");
  ASSERT_EQ(text.code, 0) << text.err;
  for (const char* line :
       {"dFx/dxi     1.7163e+06", "1.719e+06      -0.15 %", "by its derivatives", "10 contact problems"})
    EXPECT_THAT(text.out, HasSubstr(line));
  const std::string page = text_of(CONFORMAL_SOURCE_DIR "/data/tutorial/creep-curves.md");
  for (const char* start :
       {"  dFx/dxi", "  dMz/dphi", "  Fx         671.54", "  Fs         919.83 -4.013e+05"})
    EXPECT_THAT(page, HasSubstr(text.out.substr(text.out.find(start), 45))) << start;
  const Outcome help = run("creep-curves --help");
  for (const char* figure : {"1.7163e+06", "1.719e+06", "0.15 %", "6.093e+05"})
    EXPECT_THAT(help.out, HasSubstr(figure));
  const json j = json::parse(run(command + "--json").out);
  EXPECT_TRUE(j["certified"].get<bool>());
  EXPECT_NEAR(j["sensitivities"][0][0].get<double>(), 6.093e5, 100);
  EXPECT_EQ(j["contact_problems"], 1 + 4 + 3 + 2); // four with derivatives
  EXPECT_FALSE(j["sensitivities_by_differences"].get<bool>());
  const H5Table table = read_h5(folder_ / "c.h5");
  for (const char* kind : {"xi", "phi"})
    for (const auto& [name, values] : j["curves"][kind].items()) {
      const H5Dataset& data = table.datasets.at("curves/" + std::string(kind) + "/" + name);
      EXPECT_FALSE(data.unit.empty());
      EXPECT_EQ(data.values, values.get<std::vector<double>>()) << name;
    }
  EXPECT_EQ(table.datasets.at("kalker").values.at(0), j["kalker"][0][0].get<double>());
  const std::string csv = text_of(folder_ / "c.csv");
  EXPECT_THAT(csv, HasSubstr("varied,creepage,Fx_N"));
  EXPECT_THAT(csv, HasSubstr("\nxi,-0.001,"));
  EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + 3 + 2);
  const std::string file = "'" + (folder_ / "c.h5").string() + "'";
  EXPECT_THAT(run("info " + file).out, HasSubstr("Creep curves"));
  EXPECT_EQ(run("info --scene " + file).out,
            text_of(CONFORMAL_SOURCE_DIR "/data/scenes/steady_rolling.toml"));
  EXPECT_FALSE(text_attribute(table, "commit").empty());
}

/// What is computed beside a measured point is what a curve has there; every door says the same.
TEST_F(CreepCurvesCommand, BesideMeasuredForces) {
  const std::string points =
      write("points.csv", "xi,Fx,scatter # of a test\n0.0005,450,5\n-1e-3,-900,100\n").string();
  const std::string command =
      "creep-curves " + rolling + " --xi=-0.001:0.0005:2 --measured '" + points + "' ";
  const Outcome text = run(command + "-o '" + (folder_ / "c.h5").string() + "'");
  ASSERT_EQ(text.code, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("Fx as measured"));
  const json j = json::parse(run(command + "--json").out), m = j.at("measured");
  EXPECT_EQ(j["curves"].size(), 1U);
  const auto curve = j["curves"]["xi"]["Fx"].get<std::vector<double>>(),
             computed = m["points"]["computed"].get<std::vector<double>>();
  EXPECT_NEAR(computed.at(0), curve.at(1), 1e-4 * 1200); // another start
  EXPECT_NEAR(computed.at(1), curve.at(0), 1e-4 * 1200);
  EXPECT_NEAR(m["points"]["difference"][0].get<double>(), computed[0] - 450, 1e-9);
  EXPECT_NEAR(m["mean_difference"].get<double>(), (computed[0] - 450 + computed[1] + 900) / 2, 1e-9);
  EXPECT_EQ(m["within_scatter"], (std::abs(computed[0] - 450) <= 5) + (std::abs(computed[1] + 900) <= 100));
  const H5Table table = read_h5(folder_ / "c.h5");
  EXPECT_EQ(table.datasets.at("measured/points/computed").values, computed);
  EXPECT_EQ(table.datasets.at("measured/points/scatter").values, (std::vector<double>{5, 100}));
  EXPECT_EQ(text_attribute(table, "measured/force"), "Fx");
  EXPECT_THAT(run(command + "--csv '" + points + "'").err, HasSubstr("points.csv"));
  EXPECT_THAT(text_of(points), HasSubstr("of a test"));
  const Outcome below =
      run("creep-curves " + rolling + " --xi=-0.001:0.0005:2 --measured '" +
          write("below.csv", "xi,Fx,scatter\n0.0005,450,5\n-1e-3,-900,-1\n").string() + "'");
  EXPECT_EQ(below.code, 2);
  EXPECT_THAT(below.err, HasSubstr("has a scatter of -1 in its row 2"));
  for (const char* wrong : {"xi,Fy\n0,1\n", "Fx,xi\n0,1\n", "xi,Fx,width\n0,1,2\n", "xi\n0\n", "xi,Fx\n"}) {
    write("points.csv", wrong);
    EXPECT_EQ(run(command).code, 2) << wrong;
  }
}

/// Chunks of points start cold, however many processes share them.
TEST_F(CreepCurvesCommand, SeveralProcessesShareThePoints) {
  const std::string command = "creep-curves " + rolling + " --xi=-0.001:0.001:9 --json --jobs ";
  const auto forces = [&](const std::string& jobs) {
    const Outcome said = run(command + jobs);
    EXPECT_EQ(said.code, 0) << said.err;
    return json::parse(said.out)["curves"]["xi"]["Fx"].get<std::vector<double>>();
  };
  const std::vector<double> alone = forces("1"), two = forces("2");
  EXPECT_EQ(two, forces("3"));
  for (std::size_t i = 0; i < alone.size(); ++i)
    EXPECT_NEAR(two[i], alone[i], 1e-6 * 1200) << i; // of mu Fn
}

TEST(CreepRange, IsReadOrRefused) {
  using app::creep_range;
  EXPECT_THAT(creep_range(CreepKind::xi, "auto").values, IsEmpty());
  EXPECT_THAT(creep_range(CreepKind::phi, "-1e-3:1e-3:3").values, ElementsAre(-1e-3, 0, 1e-3));
  for (const char* wrong :
       {"", "1", "1:2", "1:2:1", "1:2:2.5", "1:2:3:4", "a:2:3", "1:2:99999", "1:2:3x", "0:nan:"})
    EXPECT_THROW(creep_range(CreepKind::eta, wrong), InputError) << wrong;
}

TEST_F(CreepCurvesCommand, SaysWhatIsWrong) {
  const auto refused = [&](const std::string& arguments, const char* word) {
    const Outcome r = run("creep-curves " + arguments);
    EXPECT_EQ(r.code, 2) << arguments;
    EXPECT_EQ(r.out, "");
    EXPECT_THAT(r.err, HasSubstr(word));
  };
  refused("'" CONFORMAL_SOURCE_DIR "/data/scenes/hertz.toml'", "no friction");
  refused("'" CONFORMAL_SOURCE_DIR "/data/scenes/cattaneo.toml'", "no steady rolling");
  refused(rolling + " --xi 1:2", "FROM:TO:COUNT");
  refused(rolling + " --xi 0:1e-3:2 -o " + rolling, "steady_rolling.toml");
}

} // namespace
