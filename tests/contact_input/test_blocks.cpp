#include "tests/contact_input/contact_text.hpp"

#include "bem_contact/contact_input/rules.hpp"

#include <numbers>
#include <stdexcept>

// Each digit: the block that it reads, what it keeps, what it removes.
namespace {

using namespace bem_contact::contact_input;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

CaseState only(const std::string& module, const DigitLines& digits, const std::string& data) {
  return cases_of(case_of(module, digits, data)).at(0);
}

const std::string rolling_ball = " 0d 0.2 30000.\n 0.28 0.27 82000. 81000.\n",
                  by_curvature = " -1\n 24 20 0.01 0.02 1.2\n", load = " 5000. -0.01 0. 0.001\n",
                  coulomb = " 0.3 0.3\n";

TEST(ContactBlocks, ABallByItsDigits) {
  const CaseState s = cases_of(ball_case)[0];
  EXPECT_EQ(s[Data::kinematics]["CPHI"], 0.001);
  EXPECT_EQ(s[Data::friction].at(0, 1), 0.3);
  EXPECT_EQ(s[Data::rolling]["VELOC"], 30000);
  EXPECT_EQ(s[Data::material]["GG2"], 81000);
  EXPECT_EQ(s[Data::potential]["B1"], 0.02);
  EXPECT_EQ(s[Data::potential].line, 9);
  for (const Data data :
       {Data::sheet, Data::layer, Data::heat, Data::slip, Data::stresses, Data::track, Data::damping})
    EXPECT_FALSE(s.has(data)) << name_of(data);
  EXPECT_THROW((void)s[Data::track], std::out_of_range);
  EXPECT_THROW((void)s[Data::kinematics]["PEN"], std::out_of_range);
}

TEST(ContactBlocks, NAndFOfAPatch) {
  const char* first[] = {"PEN", "FN"};
  for (int n = 0; n < 2; ++n)
    for (int f = 0; f < 3; ++f) {
      const auto k = only("3", {"201" + std::to_string(n) + std::to_string(f) + "0", "022020"},
                          " 1 2 3 4\n 0.3 0.3\n 0.28 0.28 1. 1.\n" + by_curvature)[Data::kinematics];
      EXPECT_EQ(k[first[n]], 1);
      EXPECT_EQ(k[f == 0 ? "CKSI" : "FX"], 2);
      EXPECT_EQ(k[f == 2 ? "FY" : "CETA"], 3);
      EXPECT_EQ(k.number("SPINXO", -1), -1);
    }
  const auto k =
      only("3", {"203100", "022020"},
           " 1 2 3 4 5 6 SPINXO, SPINYO\n 0.3 0.3\n" + rolling_ball + by_curvature)[Data::kinematics];
  EXPECT_EQ(k["SPINYO"], 6);
}

TEST(ContactBlocks, GReadsTheSolver) {
  const auto solver = [](char g, const std::string& more) {
    return only("3", {"203100", "022020", std::string("0") + g + "01111"},
                " 10 20 30 1 1e-5 7 NPOMAX\n" + more + ball)[Data::solver];
  };
  EXPECT_EQ(solver('0', "")["NPOMAX"], 7);
  EXPECT_EQ(solver('2', " 0.9 1. 1 0.5\n")["OMGSLP"], 0.5);
  EXPECT_EQ(solver('3', " 0.9 1. 1.0 0.5\n")["INISLP"], 1);
  EXPECT_EQ(solver('4', " 1 0.5\n")["OMGSLP"], 0.5);
  EXPECT_EQ(solver('5', " 1 2 3 4 5 6 7 8\n")["POW_S"], 8);
}

TEST(ContactBlocks, LAndVReadFriction) {
  const auto friction = [](const std::string& digits, const std::string& lines) {
    return only("1", {"1203100", digits}, lines + wheel.substr(wheel.find('\n') + 1));
  };
  EXPECT_THAT(friction("0022033", coulomb)[Data::friction].values, ElementsAre(0.3, 0.3));
  for (const char law : {'2', '3', '4'}) {
    const Block f =
        friction(std::string("0") + law + "22033", " 0.2 0.1 100. 0 0\n 0.5 7 MEMDST\n")[Data::friction];
    EXPECT_THAT(f.values, ElementsAre(0.2, 0.1, 100, 0, 0));
    EXPECT_EQ(f["MEM_S0"], 7);
  }
  EXPECT_EQ(friction("0622033", " 0.4 0 -0.2 200.\n 0 1\n")[Data::friction].columns, 4U);
  const Block by_angle = friction("1022033", " 2 NVF\n -30d 0.2 0.2\n -20d 0.35 0.35\n")[Data::friction];
  EXPECT_EQ(by_angle.rows(), 2U);
  EXPECT_DOUBLE_EQ(by_angle.at(0, 0), -std::numbers::pi / 6);
  EXPECT_EQ(by_angle.at(1, 2), 0.35);
  EXPECT_EQ(friction("2022033", " 1\n 5. 0.2 0.2\n")[Data::friction].at(0, 0), 5);
  const auto rows = only("3", {"203100", "3022020"},
                         load + rolling_ball + " -1\n 4 3 1 1 1.2\n 0.1 0.1\n 0.2 0.2\n 0.3 0.3\n");
  EXPECT_EQ(rows[Data::friction].rows(), 3U);
}

TEST(ContactBlocks, CReadsBodiesAndWhatBelongsToThem) {
  const auto bodies = [](const std::string& digits, const std::string& before, const std::string& after) {
    return only("3", {digits.substr(0, 6), digits.substr(6)},
                load + coulomb + " 0d 0.2 30000. 0.1 FACPHI\n" + before + " 0.28 0.27 82000. 81000.\n" +
                    after + by_curvature);
  };
  EXPECT_EQ(bodies("203100022020", "", "")[Data::rolling]["FACPHI"], 0.1);
  EXPECT_EQ(bodies("203100023020", "", "").effective['C'], 3);
  const Block inclinations = bodies("203100024020", " 1 2 2 NN\n -1 10d 1 -10d\n", "")[Data::inclinations];
  EXPECT_EQ(inclinations.rows(), 2U);
  EXPECT_DOUBLE_EQ(inclinations.at(1, 1), -std::numbers::pi / 18);
  EXPECT_EQ(bodies("203100029020", " 'file.txt'\n", "")[Data::influence_file].text, "file.txt");
  EXPECT_EQ(bodies("213100022020", "", " 1e-5\n")[Data::sheet]["FLX_Z"], 1e-5);
  EXPECT_EQ(bodies("203100022120", "", " 1 2 3 4\n")[Data::viscoelastic]["TC2"], 4);
  EXPECT_EQ(bodies("203100022220", "", " 1 2 3 4\n")[Data::simplified]["FLX"], 1);
  EXPECT_EQ(bodies("203100022320", "", " 1 2 3\n")[Data::simplified]["BETAMF"], 3);
  EXPECT_EQ(bodies("203100022520", "", " 1 2 3\n")[Data::simplified]["BETAMF"], 3);
  EXPECT_EQ(bodies("203100022420", "", " 8200. 0.05 0.1 2\n")[Data::layer]["K_TAU"], 2);
}

TEST(ContactBlocks, HReadsHeat) {
  const CaseState s =
      only("3", {"203100", "022420", "3101111"},
           load + coulomb + rolling_ball +
               " 8200. 0.05 0 0\n 20 450 50e-3 7.85e-6\n 30 460 5-2 7.8d-6\n 0.9 BETAPL\n" + by_curvature);
  EXPECT_EQ(s[Data::heat]["BKTEMP1"], 20);
  EXPECT_DOUBLE_EQ(s[Data::heat]["LAMBDA2"], 0.05);
  EXPECT_EQ(s[Data::plastic_heat]["BETAPL"], 0.9);
}

TEST(ContactBlocks, DReadsTheGridOfAPatch) {
  const auto grid = [](const std::string& lines) {
    return only("3", {"203100", "022020"}, load + coulomb + rolling_ball + lines)[Data::potential];
  };
  const std::string plane = " 1 1\n 1 0 1 0 0 0\n";
  EXPECT_EQ(grid(" 1\n 4 5 -2 -3 0.5 0.6\n" + plane)["XL"], -2);
  EXPECT_EQ(grid(" 2\n 4 5 -2 -3 0.5 0.6\n" + plane)["YH"], 0.6);
  EXPECT_EQ(grid(" 3\n 4 5 -2 -3 0.5 0.6\n" + plane)["XC1"], -2);
  EXPECT_EQ(grid(" 4\n 4 5 -2 -3 0.5 0.6\n" + plane)["XCM"], 0.5);
  EXPECT_EQ(grid(" -2\n 4 5 1 2 1.2\n")["AOB"], 2);
  EXPECT_EQ(grid(" -3\n 4 5 1 2 1.2\n")["BB"], 2);
  EXPECT_EQ(grid(" -4\n 4 5 1 2 1.2\n")["A1"], 1);
  EXPECT_EQ(grid(" -5\n 4 5 1 2 1.2\n")["AA"], 1);
  EXPECT_EQ(grid(" -6\n 4 5 1 2 3 1.2\n")["BPOS"], 3);
  EXPECT_THAT(error_of(case_of("3", {"203100", "022020"}, load + coulomb + rolling_ball + " 7\n")),
              HasSubstr("IPOTCN is 7"));
  EXPECT_THAT(error_of(case_of("3", {"203100", "022020"},
                               load + coulomb + rolling_ball + " -1\n 9999999 9999999 1 1 1\n")),
              HasSubstr("1 to 1000000 elements"));
}

TEST(ContactBlocks, ZReadsTheDistanceOfAPatch) {
  const auto distance = [](const std::string& lines) {
    return only("3", {"203100", "022020"},
                load + coulomb + rolling_ball + " 1\n 2 2 -1 -1 1 1\n" + lines)[Data::distance];
  };
  EXPECT_THAT(distance(" 1 1\n 1 2 3 4\n 5 6\n").values, ElementsAre(1, 2, 3, 4, 5, 6));
  const Block by_points =
      distance(" 2 1\n 3 0 500 -1 0.5\n 1 2 3\n"); // NN, XM, RM, Y1, DY1, and then the points
  EXPECT_EQ(by_points["DY1"], 0.5);
  EXPECT_EQ(by_points.values.size(), 3U);
  EXPECT_EQ(distance(" 3 1\n 1 2 3 4 5 6 7 8\n").values.size(), 8U);
  EXPECT_EQ(distance(" 9 1\n 1 2 3 4\n").values.size(), 4U);
  EXPECT_EQ(distance(" 1 2\n 1 2 3 4 5 6\n 1 2 3 4 5 6\n")["IPLAN"], 2);
  EXPECT_EQ(distance(" 1 3\n 1 2 3 4 5 6\n 1 2 3 4 5 6 7 8\n")["IPLAN"], 3);
  EXPECT_EQ(distance(" 1 4\n 1 2 3 4 5 6\n 2 NPATCH\n 1 2 3 4 5 6 7 8\n 0.5\n")["IPLAN"], 4);
  EXPECT_THAT(error_of(case_of("3", {"203100", "022020"},
                               load + coulomb + rolling_ball + " 1\n 2 2 -1 -1 1 1\n 4 1\n")),
              HasSubstr("IBASE is 4"));
}

TEST(ContactBlocks, EReadsKeepsAndRemovesSlip) {
  const std::string grid = " 1\n 2 1 -1 -1 1 1\n 1 1\n 1 0 1 0 0 0\n", same = load;
  const auto cases =
      cases_of(case_of("3", {"203100", "022029"}, load + coulomb + rolling_ball + grid + " 1 2 3 4\n") +
               case_of("3", {"203100", "100001"}, same) + case_of("3", {"203100", "100000"}, same));
  EXPECT_THAT(cases[0][Data::slip].values, ElementsAre(1, 2, 3, 4));
  EXPECT_EQ(cases[1][Data::slip].at(1, 1), 4);
  EXPECT_FALSE(cases[2].has(Data::slip));
  EXPECT_THAT(error_of(case_of("3", {"203100", "022021"}, ball)),
              HasSubstr("E = 1 keeps the extra rigid slip of the case before"));
}

TEST(ContactBlocks, AWheelOnARail) {
  const CaseState s = cases_of(wheel_case)[0];
  EXPECT_DOUBLE_EQ(s[Data::elements]["A_SEP"], std::numbers::pi / 2);
  EXPECT_EQ(s[Data::track]["GAUGWD"], 1435);
  EXPECT_EQ(s[Data::track].number("CURV", 0), 0);
  EXPECT_EQ(s[Data::rail_profile].text, "rail.prr");
  EXPECT_EQ(s[Data::rail_deviation]["ROLL"], 0.003);
  EXPECT_EQ(s[Data::wheelset]["FBPOS"], -70);
  EXPECT_EQ(s[Data::wheelset].number("YTAPE", 1000), 1000);
  EXPECT_EQ(s[Data::position]["FZ"], 60000);
  EXPECT_EQ(s[Data::velocity]["VPITCH"], -4.348);
}

/// Numbers that stand where a remark may stand are read.
TEST(ContactBlocks, NumbersWhereARemarkMayStand) {
  std::string lines = wheel;
  const auto put = [&](const std::string& from, const std::string& to) {
    lines.replace(lines.find(from), from.size(), to);
  };
  put("0.025 GAUGHT", "0.025 6.6667e-6 CURV");
  put("460.0 FBDIST", "460.0 1.5 YTAPE");
  put("'rail.prr' 0 1.0 0.0", "'rail.prr' 1 1000. 0.1 -1 1\n 1 150d 30d 6d 2.0");
  put("'wheel.prw' 0 1.0 0.0", "'wheel.prw' 0 1. 0.1 1 2\n 2 150d 30d 6d 2.0\n 1 0.5");
  put("8.0 4.0 DX", "8.0 4.0 12. 0.1 D_TURN, G_MISS");
  const CaseState s = only("1", {"1203100", "0022033"}, lines);
  EXPECT_EQ(s[Data::track]["CURV"], 6.6667e-6);
  EXPECT_EQ(s[Data::wheelset]["YTAPE"], 1.5);
  EXPECT_EQ(s[Data::rail_profile]["SCALE"], 1000);
  EXPECT_EQ(s[Data::rail_profile]["MIRRORZ"], -1);
  EXPECT_EQ(s[Data::rail_profile]["KINKWID"], 2);
  EXPECT_EQ(s[Data::wheel_profile]["MAXOMIT"], 0.5);
  EXPECT_EQ(s[Data::elements]["G_MISS"], 0.1);
}

TEST(ContactBlocks, OneAndFAndNAndEOfAWheelset) {
  const CaseState roller = only("1", {"5203000", "0022035"}, wheel + " 1 2 3 4d 5 6\n 1 2 3 4 5 6\n");
  EXPECT_EQ(roller[Data::track]["NOMRADR"], 0.025);
  EXPECT_EQ(roller[Data::velocity]["RPITCH"], 2000);
  EXPECT_EQ(roller[Data::position]["Z"], 60000);
  EXPECT_DOUBLE_EQ(roller[Data::wheel_deviation]["DROLL"], 4 * std::numbers::pi / 180);
  EXPECT_EQ(roller[Data::wheel_deviation]["VPITCH"], 6);
  EXPECT_EQ(only("1", {"1203110", "0022033"}, wheel)[Data::velocity]["FX"], -4.348);
  std::string springs = wheel;
  springs.insert(springs.find(" 1360.0"), " 1 2 3 4 KY, FY, KZ, FZ\n");
  EXPECT_EQ(only("1", {"1203130", "0022033"}, springs)[Data::rail_springs]["FZ"], 4);
}

/// Z and E of a wheel on a rail: what each reads anew, and what stays.
TEST(ContactBlocks, ZAndEKeep) {
  const auto second = [](const std::string& ze, const std::string& data) {
    return cases_of(wheel_case + case_of("1", {"1203100", "01110" + ze}, data)).at(1);
  };
  const std::string position = " 0 7. 50000. 0 0 0\n", velocity = " 100 0 0 0 0 -1\n";
  const CaseState all_kept = second("00", "");
  EXPECT_EQ(all_kept[Data::position]["Y"], 2);
  EXPECT_EQ(all_kept[Data::track].line, cases_of(wheel_case)[0][Data::track].line);
  EXPECT_EQ(second("01", position)[Data::position]["Y"], 7);
  EXPECT_EQ(second("01", position)[Data::velocity]["VS"], 2000);
  EXPECT_EQ(second("02", position + velocity)[Data::velocity]["VS"], 100);
  const CaseState moved = second("04", position + velocity + " 0 1 2 3 4 5\n 0 0 0 0 0 0\n");
  EXPECT_EQ(moved[Data::wheel_deviation]["DYAW"], 4);
  EXPECT_EQ(moved[Data::wheel_profile].text, "wheel.prw");
  EXPECT_EQ(second("10", " -1. 756. 0 0\n")[Data::track]["GAUGHT"], -1);
  EXPECT_EQ(second("10", " -1. 756. 0 0\n")[Data::rail_deviation]["DZ"], 0.2);
  EXPECT_EQ(second("20", " 9 0 0 0 0 0\n")[Data::rail_deviation]["DY"], 9);
  EXPECT_EQ(second("20", " 9 0 0 0 0 0\n")[Data::rail_profile].text, "rail.prr");
}

TEST(ContactBlocks, SReadsPoints) {
  const auto next = [](const std::string& points) {
    return cases_of(case_of("3", {"203103", "022020"}, ball + points) + ball_case).size();
  };
  EXPECT_EQ(next(" 1 0 MATFIL\n 1 ISUBS\n 11 1e-6 0.1 NZ\n 0 ISUBS\n"), 2U);
  EXPECT_EQ(next(" 1 0\n 2\n 1 1 5\n 1 1 5\n 3 0 0.1\n 3\n 2 1\n 4 5\n 6\n 3 0 0.1\n 0\n"), 2U);
  EXPECT_EQ(next(" 1 0\n 5\n 2\n 0.1 0.2\n 6\n 1 1 5\n 1 1 5\n 1\n 0.1\n 7\n 1 1\n 4\n 6\n 1\n 0.1\n 0\n"),
            2U);
  EXPECT_EQ(next(" 1 0\n 9\n 2 1 3\n 1 2\n 3\n 4 5 6\n 0\n"), 2U);
  const auto kept = cases_of(case_of("3", {"203103", "022020"}, ball + " 1 0\n 1\n 11 1e-6 0.1\n 0\n") +
                             case_of("3", {"203102", "100000"}, load + " 1 0\n") +
                             case_of("3", {"203101", "100000"}, load));
  EXPECT_EQ(kept[2][Data::stresses].values.size(), 1U);
}

/// The table is whole: each value of a digit that governs data reads, keeps or removes them, or is known not
/// to.
TEST(ContactBlocks, TheTableNamesEveryBlock) {
  std::vector<bool> read(static_cast<std::size_t>(Data::wheel_deviation) + 1, false);
  for (const DataRule& rule : data_rules()) {
    if (rule.effect == Effect::reads) {
      read[static_cast<std::size_t>(rule.data)] = true;
      EXPECT_TRUE(rule.read != nullptr || !rule.format.empty()) << name_of(rule.data);
    }
  }
  for (std::size_t k = 0; k < read.size(); ++k)
    EXPECT_TRUE(read[k]) << name_of(static_cast<Data>(k));
}

} // namespace
