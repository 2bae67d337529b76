#include "tests/app/run_program.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace {

using namespace bem_contact;
using nlohmann::json;
using ::testing::HasSubstr;

class FromContact : public ProgramTest {
protected:
  Outcome convert(const std::string& text) const {
    return run("from-contact '" + write("cases.inp", text).string() + "' -o '" +
               (folder_ / "scenes").string() + "'");
  }
  std::string scene(int number) const {
    return (folder_ / "scenes" / ("cases_00" + std::to_string(number) + ".toml")).string();
  }
  json solved(int number) const {
    const Outcome done = run("solve '" + scene(number) + "' --json");
    EXPECT_EQ(done.code, 0) << done.err;
    return done.code == 0 ? json::parse(done.out) : json();
  }
};

/// Two spheres by curvatures, without friction, beside Hertz's formula.
const std::string spheres = R"(% a remark
 3  MODULE
 200100  P-B-T-N-F-S   remark
 022020  L-D-C-M-Z-E
 0101111 H-G-I-A-O-W-R
 1000.0  0.0 0.0  0d0      FN, CKSI, CETA, CPHI
 0.3 0.3                   FSTAT, FKIN
 0.28 0.28  82000.  82000. POISS 1,2, GG 1,2
 -1                        IPOTCN
 20 20  1d-2 1d-2 1.2      MX, MY, A1, B1, SCALE
 0  MODULE
)";

TEST_F(FromContact, AnEllipseByItsCurvatures) {
  const Outcome done = convert(spheres);
  ASSERT_EQ(done.code, 0) << done.out << done.err;
  EXPECT_THAT(done.out, HasSubstr("case 1: cases_001.toml"));
  const json found = solved(1);
  // R = 50 mm, E* = G / (1 - nu): p0 = (6 F E*^2 / R^2)^(1/3) / pi
  const double modulus = 82000 / (1 - 0.28), p0 = std::cbrt(6 * 1000 * modulus * modulus / 2500) / M_PI;
  EXPECT_NEAR(found["quantities"]["pmax"].get<double>() / p0, 1, 0.02);
}

/// Rolling with creepage: signs turn, forces are relative, and the grid is the one given.
TEST_F(FromContact, ForcesCreepagesAndGrid) {
  const std::string text = R"(
 3 MODULE
  203110   P-B-T-N-F-S
  022020   L-D-C-M-Z-E
 0101111   H-G-I-A-O-W-R
   4000.  -0.5  0.001  0.0002   FN, FX, CETA, CPHI
   0.3  0.3                     FSTAT, FKIN
   0.0d  0.4  3000.             CHI, DQ, VELOC
   0.28 0.3   82000. 80000.
   1                            IPOTCN
   16 14 -3.2 -2.8 0.4 0.4      MX,MY,XL,YL,DX,DY
   1 1                          IBASE, IPLAN
   2d-3 0. 3d-3 0. 0.
   0.
 0 MODULE
)";
  ASSERT_EQ(convert(text).code, 0);
  const std::string toml = text_of(scene(1));
  for (const char* line :
       {"load.force = 4000", "motion.eta = -0.001", "motion.phi = -0.0002", "load.force_x = -600",
        "gap.a = 0.002", "gap.b = 0.003", "grid.mx = 16", "grid.ms = 14", "grid.dx = 0.4",
        "motion.speed = 3000", "wheel.material.shear_modulus = 80000", "rail.material.poisson = 0.28"})
    EXPECT_THAT(toml, HasSubstr(line));
  EXPECT_NEAR(solved(1)["quantities"]["Fx"].get<double>(), -600, 1e-3);
}

/// Transient cases that go on from each other are the steps of one scene.
TEST_F(FromContact, StepsOfOneHistory) {
  const auto one = [](int previous, double force, const char* digits) {
    return " 3 MODULE\n " + std::to_string(previous) + "01100 P\n " + digits + " L\n 0101111 H\n " +
           std::to_string(force) + " 0.0 -1e-4 0.0\n";
  };
  const std::string bodies =
      " 0.3 0.3\n 0.28 0.28 82000. 82000.\n 3\n 12 12 -2.2 -2.2 0.4 0.4\n 1 1\n 2e-3 0. 2e-3 0. 0. 0.\n";
  const Outcome done = convert(one(2, 2000, "022020") + bodies + one(0, 2200, "111000") +
                               one(0, 2400, "111000") + " 0 MODULE\n");
  ASSERT_EQ(done.code, 0) << done.out << done.err;
  EXPECT_THAT(done.out, HasSubstr("cases 1 to 3: cases_001.toml"));
  const json found = solved(1);
  EXPECT_NEAR(found["quantities"]["Fz"].get<double>(), 2400, 1);
  EXPECT_THAT(text_of(folder_ / "scenes" / "cases_001_step_table.csv"), HasSubstr("load,xi,eta,phi\n2000"));
}

/// Module 1: a wheel on a rail, and then the same with another position alone.
TEST_F(FromContact, AWheelOnARail) {
  const std::string profile = CONFORMAL_SOURCE_DIR "/data/bodies/hollow_wheel.txt";
  const std::string text = R"(
 1 MODULE
 1203100   C-P-B-T-N-F-S
 0022033   V-L-D-C-M-Z-E
 0101111   H-G-I-A-O-W-R
 0.3 0.3
 0.28 0.28 82000. 82000.
 0.4 0.4 1.0 90.0d 8.0 4.0        DX, DS, DQREL, A_SEP, D_SEP, D_COMB
 14. 0 1435. 0.025                GAUGHT, GAUGSQ, GAUGWD, CANT
 ')" CONFORMAL_SOURCE_DIR R"(/data/bodies/worn_rail.txt' 0 1. 0. 0
 0. 0. 0.   0. 0. 0.              DY, DZ, DROLL, VY, VZ, VROLL
 1360. -70. 460.                  FBDIST, FBPOS, NOMRAD
 ')" + profile + R"(' 0 1. 0. 0
 0. 2.0 80000. -1d-3 0.05d 0.     S, Y, FZ, ROLL, YAW, PITCH
 20000. 0. 0. 0. 0. -43.4         VS, VY, VZ, VROLL, VYAW, VPITCH
 1 MODULE
 1203100
 0111011
 0101111
 0. 3.0 80000. -1d-3 0. 0.
 0 MODULE
)";
  std::string second = text;
  second.replace(second.find(" 0111011"), 8, " 0110001"); // Z = 0, E = 1: the same bodies at another place
  const Outcome done = convert(second);
  ASSERT_EQ(done.code, 0) << done.out << done.err;
  const std::string first = text_of(scene(1)), next = text_of(scene(2));
  for (const char* line :
       {"position.lateral = 2", "position.side = \"right\"", "position.roll = -0.001", "load.force = 80000",
        "motion.pitch_rate = 43.4", "position.rail_inclination = 0.025", "wheel.place = \"absolute\"",
        "wheel.y = 750", "rail.unit = \"mm\"", "hollow_wheel.txt"})
    EXPECT_THAT(first, HasSubstr(line));
  EXPECT_THAT(next, HasSubstr("position.lateral = 3"));
  EXPECT_THAT(next, HasSubstr("motion.pitch_rate = 43.4"));
  EXPECT_EQ(run("check '" + scene(1) + "'").code, 0);

  std::string pulled = text; // F = 1: FX in the place of VPITCH
  pulled.replace(pulled.find("1203100"), 7, "1203110");
  pulled.replace(pulled.find("-43.4 "), 6, "5000. ");
  pulled.replace(pulled.rfind(" 1 MODULE"), std::string::npos, " 0 MODULE\n");
  const Outcome yawed = convert(pulled);
  EXPECT_EQ(yawed.code, 2);
  EXPECT_THAT(yawed.out, HasSubstr("no scene: F = 1 with YAW"));
  pulled.replace(pulled.find("0.05d"), 5, "0.   ");
  ASSERT_EQ(convert(pulled).code, 0);
  EXPECT_THAT(text_of(scene(1)), HasSubstr("load.force_x = 5000"));
}

/// A rail that changes along the track: the place S counts, and it is placed by the origin of its files.
TEST_F(FromContact, ARailOfSections) {
  write("rail.slcs",
        "0 1\n2\n0\n1\n-200 '" CONFORMAL_SOURCE_DIR "/data/bodies/worn_rail.txt'\n300 '" CONFORMAL_SOURCE_DIR
        "/data/bodies/worn_rail.txt'\n");
  const std::string text = R"(
 1 MODULE
 1200100   C-P-B-T-N-F-S
 0022033   V-L-D-C-M-Z-E
 0101111   H-G-I-A-O-W-R
 0.3 0.3
 0.28 0.28 82000. 82000.
 0.8 0.8 1.0 90.0d 8.0 4.0        DX, DS, DQREL, A_SEP, D_SEP, D_COMB
 -1. 750. 0. 0.025                GAUGHT, RAILY0, RAILZ0, CANT
 'rail.slcs' 0 1. 0. 0
 0. 0. 0.   0. 0. 0.              DY, DZ, DROLL, VY, VZ, VROLL
 1360. -70. 460.                  FBDIST, FBPOS, NOMRAD
 ')" CONFORMAL_SOURCE_DIR R"(/data/bodies/hollow_wheel.txt' 0 1. 0. 0
 120. 2.0 80000. 0. 0. 0.         S, Y, FZ, ROLL, YAW, PITCH
 20000. 0. 0. 0. 0. -43.4         VS, VY, VZ, VROLL, VYAW, VPITCH
 0 MODULE
)";
  const Outcome done = convert(text);
  ASSERT_EQ(done.code, 0) << done.out << done.err;
  for (const char* line :
       {"rail.slcs\"", "position.along = 120", "rail.place = \"absolute\"", "rail.y = 750"})
    EXPECT_THAT(text_of(scene(1)), HasSubstr(line));
  EXPECT_EQ(run("check '" + scene(1) + "'").code, 0);

  std::string round = text; // a wheel that changes round its axle: PITCH turns it forwards
  round.replace(round.find(CONFORMAL_SOURCE_DIR "/data/bodies/hollow_wheel.txt"),
                std::string(CONFORMAL_SOURCE_DIR "/data/bodies/hollow_wheel.txt").size(), "wheel.slcw");
  round.replace(round.find("'rail.slcs'"), 11, "'" CONFORMAL_SOURCE_DIR "/data/bodies/worn_rail.txt'");
  round.replace(round.find("80000. 0. 0. 0. "), 16, "80000. 0. 0. 0.2");
  write("wheel.slcw",
        "0 1\n2\n0\n2\n-1 '" CONFORMAL_SOURCE_DIR "/data/bodies/hollow_wheel.txt'\n1 '" CONFORMAL_SOURCE_DIR
        "/data/bodies/hollow_wheel.txt'\n");
  ASSERT_EQ(convert(round).code, 0);
  for (const char* line : {"wheel.slcw\"", "wheel.sections_angle = 0.2"})
    EXPECT_THAT(text_of(scene(1)), HasSubstr(line));
  EXPECT_EQ(run("check '" + scene(1) + "'").code, 0);

  std::string by_gauge = text;
  by_gauge.replace(by_gauge.find("-1. 750."), 8, "14. 0   ");
  const Outcome refused = convert(by_gauge);
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.out, HasSubstr("GAUGHT of a rail that changes along the track"));
}

/// What would be another problem has no scene, with the digit that says so; the other cases have.
TEST_F(FromContact, SaysWhatHasNoCounterpart) {
  std::string approximate = spheres;
  approximate.replace(approximate.find(" 200100"), 7, " 230100");
  const Outcome done =
      convert(spheres.substr(0, spheres.find(" 0  MODULE")) + approximate.substr(approximate.find(" 3")));
  EXPECT_EQ(done.code, 2);
  EXPECT_THAT(done.out, HasSubstr("case 1: cases_001.toml"));
  EXPECT_THAT(done.out, HasSubstr("case 2 (line 11): no scene: B = 3"));
  const auto refused = [&](const std::string& text, const char* words) {
    const Outcome wrong = convert(text);
    EXPECT_EQ(wrong.code, 2);
    EXPECT_THAT(wrong.err, HasSubstr(words));
  };
  refused("no digits\n", "MODULE cannot be read");
  refused("", "MODULE cannot be read (the file ends here)");
  refused(" 0 MODULE\n", "has no case");
  refused(" 3 MODULE\n 200100\n", "the file ends here");
  refused(" 11 MODULE\n", "MODULE is 11");
}

} // namespace
