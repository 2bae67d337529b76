#include "bem_contact/scene/sweep_file.hpp"

#include "bem_contact/scene/sweep_check.hpp"

#include "tests/base/message.hpp"
#include "tests/base/temporary_folder.hpp"

#include <fmt/format.h>
#include <fstream>
#include <gmock/gmock.h>

namespace {

using namespace bem_contact;
using ::testing::HasSubstr;

const std::string scene =
    "kind = \"patch\"\n[motion]\nfriction = 0.3\n[grid]\ndx = 0.5\nds = 0.5\nmx = 16\nms = "
    "16\n[gap]\na = 1e-3\nb = 1e-3\n[sweep]\n";

TEST(SweepFile, AProductRunsThroughTheLastListFastest) {
  const SweepFile sweep = parse_sweep_file(scene + "load.force = [1e3, 2e3]\nmotion.xi = [0, 1e-3, 2e-3]\n");
  ASSERT_EQ(sweep.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(sweep.scene(i).load.force, i < 3 ? 1e3 : 2e3) << i;
    EXPECT_EQ(sweep.scene(i).motion.xi, double(i % 3) * 1e-3) << i;
    EXPECT_EQ(sweep.scene(i).gap.a, 1e-3);
  }
  EXPECT_EQ(sweep.describe(5), "load.force = 2000, motion.xi = 0.002");
}

TEST(SweepFile, TheOrderIsThatOfTheFileNotOfTheAlphabet) {
  const SweepFile sweep = parse_sweep_file(scene + "motion.xi = [0, 1e-3]\nload.force = [1e3, 2e3]\n");
  EXPECT_EQ(sweep.axes[0].key, "motion.xi");
  EXPECT_EQ(sweep.scene(1).load.force, 2e3);
  EXPECT_EQ(sweep.scene(1).motion.xi, 0);
}

TEST(SweepFile, AZipTakesOneOfEach) {
  const SweepFile sweep =
      parse_sweep_file(scene + "mode = \"zip\"\nload.force = [1e3, 2e3]\n\"motion.xi\" = [0, 1e-3]\n");
  ASSERT_EQ(sweep.size(), 2u);
  EXPECT_EQ(sweep.scene(1).load.force, 2e3);
  EXPECT_EQ(sweep.scene(1).motion.xi, 1e-3);
}

/// Profile and influence file of a body belong together: two rails and three wheels are six pairs, not 36.
TEST(SweepFile, ListsTogetherAreOneListOfTheProduct) {
  const SweepFile sweep = parse_sweep_file(scene + "load.force = [1e3, 2e3]\n"
                                                   "[[sweep.together]]\ngap.a = [1, 2]\ngap.b = [10, 20]\n"
                                                   "[[sweep.together]]\nmotion.xi = [0, 1e-3, 2e-3]\n"
                                                   "motion.eta = [0.0, 1e-4, 2e-4]\n");
  ASSERT_EQ(sweep.size(), 12u);
  for (std::size_t i = 0; i < 12; ++i) { // the bodies change slowest, wherever they stand in the file
    const SceneFile one = sweep.scene(i);
    EXPECT_EQ(one.gap.a, i < 6 ? 1 : 2) << i;
    EXPECT_EQ(one.gap.b, 10 * one.gap.a) << i;
    EXPECT_EQ(one.motion.xi, double(i / 2 % 3) * 1e-3) << i;
    EXPECT_DOUBLE_EQ(one.motion.eta, one.motion.xi / 10) << i;
    EXPECT_EQ(one.load.force, i % 2 == 0 ? 1e3 : 2e3) << i;
  }
}

TEST(SweepFile, ACollectiveIsSweptWithEachPairOfBodies) {
  const TemporaryFolder folder;
  std::ofstream(folder / "bodies.csv") << "gap.a,gap.b\n1,10\n2,20\n3,30\n";
  std::ofstream(folder / "collective.csv") << "load.force,motion.xi,weight\n1e3,0,5\n2e3,1e-3,7\n";
  const SweepFile sweep =
      parse_sweep_file({scene + "table = \"collective.csv\"\ntogether = [ { table = \"bodies.csv\" } ]\n",
                        "s.toml", folder.path()});
  ASSERT_EQ(sweep.size(), 6u);
  EXPECT_EQ(sweep.describe(3), "gap.a = 2, gap.b = 20, load.force = 2000, motion.xi = 0.001");
  EXPECT_EQ(sweep.weight(2), 5);
  EXPECT_EQ(sweep.weight(5), 7);
  ASSERT_EQ(sweep.tables.size(), 2u); // files that the results depend on
}

TEST(SweepFile, EachPairIsChecked) {
  const SweepFile sweep =
      parse_sweep_file(scene + "load.force = { from = 1, to = 1e6, count = 1000000 }\n"
                               "[[sweep.together]]\ngap.a = [1, -2, 3]\ngap.b = [0, 0, 0]\n");
  EXPECT_EQ(message_of([&] { check_values(sweep); }), "no error");
  const SweepFile wrong =
      parse_sweep_file(scene + "load.force = { from = 1, to = 1e6, count = 1000000 }\n"
                               "[[sweep.together]]\ngap.a = [1, 2]\ngrid.dx = [0.5, -1]\n");
  EXPECT_THAT(message_of([&] { check_values(wrong); }), HasSubstr("grid.dx = -1"));
}

TEST(SweepFile, ARangeHasBothEndsAndRoundNumbers) {
  const auto values = [](const std::string& range) {
    std::vector<double> out;
    const SweepFile sweep = parse_sweep_file(scene + "load.force = " + range + "\n");
    for (std::size_t i = 0; i < sweep.size(); ++i)
      out.push_back(*sweep.scene(i).load.force);
    return out;
  };
  EXPECT_EQ(values("{ from = 6.2, to = 6.5, step = 0.1 }"), (std::vector<double>{6.2, 6.3, 6.4, 6.5}));
  EXPECT_EQ(values("{ from = 3, to = 1, step = -1 }"), (std::vector<double>{3, 2, 1}));
  EXPECT_EQ(values("{ from = 1, to = 2, count = 5 }"), (std::vector<double>{1, 1.25, 1.5, 1.75, 2}));
  EXPECT_EQ(values("{ from = 1, to = 1.95, step = 0.5 }"), (std::vector<double>{1, 1.5})); // 2 is beyond
}

/// What other cases have is nothing to these.
TEST(SweepFile, OnlySomeCasesAreChecked) {
  const auto checked = [](const std::string& lists, CaseRange cases) {
    const SweepFile sweep = parse_sweep_file(scene + lists);
    return message_of([&] { check_values(sweep, cases); });
  };
  const std::string zip = "mode = \"zip\"\nload.force = [-1, 1e3, 2e3, -2]\nmotion.xi = [0, 0, 0, 0]\n";
  EXPECT_EQ(checked(zip, {1, 3}), "no error");
  EXPECT_THAT(checked(zip, {0, 2}), HasSubstr("load.force = -1"));
  EXPECT_THAT(checked(zip, {2, 4}), HasSubstr("load.force = -2"));
  // 0: -1, xi 0; 1: -1, xi 1e-3; 2: 1e3, xi 0 ...
  const std::string product = "load.force = [-1, 1e3, -2]\nmotion.xi = [0, 1e-3]\n";
  EXPECT_EQ(checked(product, {2, 4}), "no error");
  EXPECT_EQ(checked(product, {3, 4}), "no error");
  EXPECT_THAT(checked(product, {1, 4}), HasSubstr("load.force = -1"));
  EXPECT_THAT(checked(product, {3, 5}), HasSubstr("load.force = -2"));
  const std::string fast = "load.force = [1e3, 2e3]\nmotion.friction = [0.3, -1, 0.2]\n";
  EXPECT_EQ(checked(fast, {2, 4}), "no error"); // 0.2 and, of the next force, 0.3
  EXPECT_THAT(checked(fast, {2, 5}), HasSubstr("motion.friction = -1"));
}

TEST(SweepFile, FewCasesKeepTheirFields) {
  const auto keeps = [](const std::string& lists) { return parse_sweep_file(scene + lists).keeps_fields(); };
  const auto cases = [](int count) {
    return fmt::format("load.force = {{ from = 1e3, to = 2e3, count = {} }}\n", count);
  };
  EXPECT_TRUE(keeps(cases(1000)));
  EXPECT_FALSE(keeps(cases(1001)));
  EXPECT_TRUE(keeps("fields = true\n" + cases(1001)));
  EXPECT_FALSE(keeps("fields = false\n" + cases(2)));
}

/// A million scenes would take two minutes, without a word.
TEST(SweepFile, ARangeIsCheckedAtItsEnds) {
  const auto checked = [](const std::string& lists) {
    const SweepFile sweep = parse_sweep_file(scene + lists);
    return message_of([&] { check_values(sweep); });
  };
  const std::string million = "load.force = { from = 1, to = 1e6, count = 1000000 }\n";
  EXPECT_EQ(checked(million), "no error");
  EXPECT_EQ(checked("mode = \"zip\"\n" + million + "motion.xi = { from = 0, to = 1e-3, count = 1000000 }\n"),
            "no error");
  EXPECT_THAT(checked("load.force = { from = 1e3, to = -1e3, step = -1e-3 }\n"),
              HasSubstr("load.force = -1000"));
  EXPECT_THAT(checked("motion.friction = { from = -1, to = 1, count = 7 }\nload.force = [1e3]\n"),
              HasSubstr("motion.friction = -1"));
  EXPECT_THAT(checked("load.force = [1e3]\ngrid.mx = { from = 8, to = 16, count = 4 }\n"),
              HasSubstr("grid.mx"));
  EXPECT_THAT(checked("load.force = [1e3, 2e3, -1, 3e3]\n"), HasSubstr("load.force = -1")); // each of a list
  EXPECT_EQ(checked("load.force = { from = 1e3, to = 2e3, count = 2 }\n"), "no error");
  EXPECT_EQ(checked("load.force = { from = 1e3, to = 1e3, count = 1 }\n"), "no error");
}

TEST(SweepFile, WholeNumbersStayWhole) {
  const SweepFile sweep =
      parse_sweep_file(scene + "load.force = [1e3]\ngrid.mx = { from = 8, to = 16, step = 4 }\n");
  EXPECT_EQ(sweep.scene(2).grid.mx, 16);
}

TEST(SweepFile, WhatIsWrongIsSaidWithItsLine) {
  const auto message = [](const std::string& sweep, std::size_t index = 0) {
    return message_of([&] { parse_sweep_file({scene + sweep, "s.toml"}).scene(index); });
  };
  EXPECT_THAT(message("motion.xi = [0]\nload.forse = [1]\n"),
              HasSubstr("s.toml:14: unknown key 'load.forse'"));
  EXPECT_THAT(message("load.force = [1e3, -1]\n", 1),
              HasSubstr("s.toml:13: load.force = -1.0 (out of range)"));
  EXPECT_THAT(message("load.force = [1e3]\nposition.lateral = [1]\n"), HasSubstr("no meaning where kind is"));
  EXPECT_THAT(message("load.force = [\"a\"]\n"), HasSubstr("must be of type: number"));
  EXPECT_THAT(message("load.force = 3\n"), HasSubstr("needs a list or a range"));
  EXPECT_THAT(message("load.force = []\n"), HasSubstr("is empty"));
  EXPECT_THAT(message("load.force = {from = 1, to = 2}\n"), HasSubstr("is not complete"));
  EXPECT_THAT(message("load.force = {from = 1, to = 2, step = 1, count = 2}\n"),
              HasSubstr("is not complete"));
  EXPECT_THAT(message("load.force = {from = 1, to = 2, step = -1}\n"), HasSubstr("never ends"));
  EXPECT_THAT(message("load.force = {from = 1, to = 2, step = 0}\n"), HasSubstr("never ends"));
  EXPECT_THAT(message("load.force = {from = 1, to = 2, step = 1e-12}\n"), HasSubstr("never ends"));
  EXPECT_THAT(message("load.force = {from = 1, to = inf, count = 3}\n"), HasSubstr("finite"));
  EXPECT_THAT(message("load.force = {from = 1, to = 2, count = 1}\n"), HasSubstr("cannot have 1 value ("));
  EXPECT_THAT(message("load.force = {from = 1, to = 2, count = -3}\n"), HasSubstr("cannot have -3 values"));
  EXPECT_THAT(message("load.force = {from = 1, to = 2, stepp = 1}\n"), HasSubstr("unknown key 'stepp'"));
  EXPECT_THAT(message("mode = \"zipp\"\nload.force = [1]\n"), HasSubstr("known are product and zip"));
  EXPECT_THAT(message("mode = \"zip\"\nload.force = [1, 2]\nmotion.xi = [0]\n"),
              HasSubstr("load.force has 2 values and motion.xi has 1"));
  EXPECT_THAT(message("load.force = [1]\n\"load.force\" = [2]\n"), HasSubstr("given twice"));
  EXPECT_THAT(message("load.force = [1, 2]\nweight = [1]\n"), HasSubstr("has 1 weight (it has 2 cases)"));
  EXPECT_THAT(message("load.force = [1]\nweight = [-1]\n"), HasSubstr("weights are positive numbers"));
  EXPECT_THAT(message("load.force = [1]\nweight = 2\n"), HasSubstr("sweep.weight is no list"));
  EXPECT_THAT(message(""), HasSubstr("no table [sweep]"));
  // A misspelt key of the table is no list without values.
  for (const auto& [given, meant] : {std::pair{"mod = \"zip\"\nload.force = [1]\n", "mode"},
                                     {"tabel = \"a.csv\"\n", "table"},
                                     {"table = \"a.csv\"\ncolums = { a = \"note\" }\n", "columns"},
                                     {"load.force = [1]\nwieght = [2]\n", "weight"},
                                     {"[[sweep.togehter]]\ngap.a = [1]\n", "together"}})
    EXPECT_THAT(message(given), HasSubstr(fmt::format("Did you mean sweep.{}?", meant))) << given;
  EXPECT_THAT(message("load.force = {frm = 1, to = 2, step = 1}\n"), HasSubstr("Did you mean from?"));
  EXPECT_THAT(message("positon.lateral = [1]\n"), HasSubstr("unknown key 'positon.lateral'"));
  EXPECT_THAT(message("[[sweep.together]]\ngap.a = [1, 2]\ngap.b = [1]\n"),
              HasSubstr("gap.a has 2 values and gap.b has 1) Give lists of equal lengths."));
  EXPECT_THAT(message("gap.a = [1]\n[[sweep.together]]\ngap.a = [1, 2]\n"), HasSubstr("given twice"));
  EXPECT_THAT(message("[[sweep.together]]\ngap.a = 2\n"),
              HasSubstr("sweep.together.gap.a is a single value"));
  EXPECT_THAT(message("together = 3\n"), HasSubstr("sweep.together has no lists"));
  EXPECT_THAT(message("together = [ [1] ]\n"), HasSubstr("sweep.together has no lists"));
  EXPECT_THAT(message("load.force = [1, 2]\nweight = [1]\n[[sweep.together]]\ngap.a = [1, 2]\n"),
              HasSubstr("has 1 weight (a pair of bodies has 2 cases)"));
}

TEST(SweepFile, WeightsAreNoKeyOfAScene) {
  const SweepFile sweep = parse_sweep_file(scene + "load.force = [1e3, 2e3]\nweight = [3, 1.5]\n");
  EXPECT_EQ(sweep.size(), 2U);
  EXPECT_EQ(sweep.weights, (std::vector<double>{3, 1.5}));
  EXPECT_EQ(sweep.scene(1).load.force, 2e3);
}

TEST(SweepFile, ASceneWithASweepIsASceneToo) {
  std::string text = scene;
  text.replace(text.find("[motion]"), 8, "[load]\nforce = 5e3\n[motion]");
  EXPECT_EQ(parse_scene_file(text + "load.force = [1e3]\n").load.force, 5e3);
}

/// Else all cases would be the same, without a word.
TEST(SweepFile, AKeyThatAnotherOverrulesIsNotSwept) {
  const auto message = [](const std::string& more, const std::string& swept) {
    const SweepFile sweep = parse_sweep_file("rail.profile = '60E1'\nwheel.profile = 'S1002'\n" + more +
                                             "[sweep]\n" + swept + " = [0.01, 0.02]\n");
    return message_of([&] { check_values(sweep, sweep.all()); });
  };
  const std::string axle = "wheelset.force = 1.6e5\n", load = "load.force = 8e4\n";
  EXPECT_THAT(message(axle + "wheelset.force_y = 2e4\n", "position.lateral"),
              ::testing::AllOf(HasSubstr("wheelset.force_y is given"),
                               HasSubstr("all cases would be the same"),
                               HasSubstr("Sweep wheelset.force_y")));
  EXPECT_EQ(message(axle, "position.lateral"), "no error");
  EXPECT_THAT(message(load + "load.force_y = 1e3\n", "position.lateral"), HasSubstr("load.force_y is given"));
  EXPECT_THAT(message(load + "load.force_x = 1e3\n", "motion.xi"), HasSubstr("load.force_x is given"));
  EXPECT_THAT(message(load + "grid.accuracy = 0.02\n", "grid.dx"), HasSubstr("chooses the elements"));
  EXPECT_THAT(message(load + "solver.model = 'halfspace'\n", "solver.model_tolerance"),
              HasSubstr("solver.model is given"));
  EXPECT_EQ(message(load + "grid.accuracy = 0.02\n", "motion.xi"), "no error");
}

} // namespace
