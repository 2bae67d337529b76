#include "bem_contact/scene/case_table.hpp"
#include "bem_contact/scene/sweep_check.hpp"

#include "tests/base/message.hpp"
#include "tests/base/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

namespace {

using namespace bem_contact;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A CSV file of this test's own.
std::filesystem::path csv(const std::string& text) {
  static const TemporaryFolder folder;
  return folder.write(std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".csv",
                      text);
}

const std::string wheel_rail =
    "rail.profile = \"60E1\"\nwheel.profile = \"S1002\"\nload.force = 8e4\n[sweep]\n";

SweepFile sweep_of(const std::string& text, const std::string& more = "") {
  const std::filesystem::path file = csv(text);
  return parse_sweep_file(
      {wheel_rail + "table = \"" + file.filename().string() + "\"\n" + more, "s.toml", file.parent_path()});
}

TEST(CaseTable, HasPositionsLoadsFrictionAndWeights) {
  const SweepFile sweep = sweep_of("# measured\nposition.lateral, load.force, motion.friction, weight\n"
                                   "0.5, 8e4, 0.3, 6\n-1, 90000, 0.25, 2.5\n\n");
  ASSERT_EQ(sweep.size(), 2U);
  EXPECT_THAT(sweep.weights, ElementsAre(6, 2.5));
  EXPECT_EQ(sweep.scene(0).position.lateral, 0.5);
  EXPECT_EQ(sweep.scene(1).position.lateral, -1);
  EXPECT_EQ(sweep.scene(1).load.force, 9e4);
  EXPECT_EQ(sweep.scene(1).motion.friction, 0.25);
}

/// A table of lists says the same.
TEST(CaseTable, IsAZipOfItsColumns) {
  const SweepFile lists = parse_sweep_file(
      wheel_rail + "mode = \"zip\"\nposition.lateral = [0.5, 1.5]\nrail.profile = [\"60E1\", \"60E2\"]\n");
  const SweepFile table = sweep_of("position.lateral,rail.profile\n0.5,\"60E1\"\n1.5,\"60E2\"\n");
  ASSERT_EQ(table.size(), lists.size());
  EXPECT_TRUE(table.weights.empty());
  for (std::size_t i = 0; i < lists.size(); ++i)
    EXPECT_TRUE(SceneFile(table.scene(i)).rail == lists.scene(i).rail) << i;
  EXPECT_EQ(table.describe(1), lists.describe(1));
}

/// Results, and reasons with commas in quotes, are no keys.
TEST(CaseTable, TakesTheKeysOfASweepsTable) {
  const SweepFile sweep = sweep_of("case,position.lateral,motion.frictionless,weight,status,Fx,pmax,reason\n"
                                   "0,0.5,false,3,certified,12.5,900,\n"
                                   "1,1.5,true,1,refused,,,\"no, \"\"not\"\" here\"\n");
  ASSERT_EQ(sweep.axes.size(), 2U);
  EXPECT_THAT(sweep.weights, ElementsAre(3, 1));
  EXPECT_TRUE(sweep.scene(1).motion.frictionless);
}

/// Its lines are read as those of tables of numbers are (csv_table.hpp).
TEST(CaseTable, HasCommentsBehindItsCells) {
  const SweepFile sweep = sweep_of("position.lateral, rail.profile # mm\n+0.5, \"60E1\" # the first\n");
  EXPECT_EQ(sweep.scene(0).position.lateral, 0.5);
  EXPECT_EQ(sweep.scene(0).rail.profile, "60E1");
  EXPECT_THAT(message_of([] { read_case_table(csv("rail.profile\n\"a # b\",1\n")); }),
              HasSubstr("it has 2 cells"));
}

TEST(CaseTable, WhatIsWrongIsSaidWithItsLine) {
  const auto message = [](const std::string& text) {
    return message_of([&] { read_case_table(csv(text)); });
  };
  EXPECT_THAT(message("position.lateral,weight\n0,1\n1\n"),
              HasSubstr("csv' is wrong (it has 1 cell, and 2 columns have names) Give each line one cell"));
  EXPECT_THAT(message("position.lateral,weight\n0,1\n1\n"), HasSubstr("Line 3 of the table"));
  EXPECT_THAT(
      message("position.lateral;weight\n0,5;1\n"),
      AllOf(HasSubstr("Line 1 of the table"), HasSubstr("(semicolons separate its names) Separate cells by "
                                                        "commas, and write numbers with a decimal point.")));
  EXPECT_THAT(message("position.lateral,weight\n0.5;1\n"),
              HasSubstr("(it has 1 cell, and 2 columns have names) Give each line one cell for each column, "
                        "separated by commas, not semicolons."));
  EXPECT_THAT(message("position.lateral\n0,5\n"),
              HasSubstr("(it has 2 cells, and 1 column has a name) Give each line one cell for each column"));
  EXPECT_THAT(message("position.lateral,weight\n0,5,1\n"),
              HasSubstr("(it has 3 cells, and 2 columns have names) Give each line one cell for each column; "
                        "numbers have a decimal point, because a comma separates cells."));
  EXPECT_THAT(message("position.lateral,weight\n0,0\n"), HasSubstr("the weight '0' is not positive"));
  EXPECT_THAT(message("position.lateral,weight\n0,often\n"), HasSubstr("'often' is no value of weight"));
  EXPECT_THAT(message("position.lateral\nnan\n"), HasSubstr("'nan' is no value of position.lateral"));
  EXPECT_THAT(message("wheel.profile\nS1002\n"), HasSubstr("a text in quotes"));
  EXPECT_THAT(message("load.force,load.force\n1,1\n"), HasSubstr("two columns have the name 'load.force'"));
  EXPECT_THAT(message("weight\n1\n"), HasSubstr("none of its columns has the name of a key"));
  EXPECT_THAT(message("load.force,weight\n"), HasSubstr("it has no line below the names"));
  EXPECT_THAT(message(""), HasSubstr("has no cases"));
}

TEST(CaseTable, OfASweepIsCheckedLikeLists) {
  const auto message = [](const std::string& text, const std::string& more = "") {
    return message_of([&] { sweep_of(text, more).scene(0); });
  };
  EXPECT_THAT(message("position.latteral\n0\n"), HasSubstr("unknown key 'position.latteral'"));
  EXPECT_THAT(message("load.force\n-1\n"), HasSubstr("out of range"));
  EXPECT_THAT(message("load.force\n1e4\n", "weight = [1]\n"), HasSubstr("beside lists, weights or a mode"));
  EXPECT_THAT(message("load.force\n1e4\n", "position.lateral = [1]\n"),
              HasSubstr("Give either the table or lists"));
  EXPECT_THAT(message_of([] { parse_sweep_file(wheel_rail + "table = 3\n"); }), HasSubstr("names no file"));
  EXPECT_THAT(message_of([] { parse_sweep_file(wheel_rail + "table = \"gone.csv\"\n"); }),
              HasSubstr("gone.csv"));
}

/// Excel writes three bytes in front of the names, and line ends of its own.
TEST(CaseTable, MayHaveAByteOrderMark) {
  const SweepFile sweep = sweep_of("\xef\xbb\xbfposition.lateral, load.force\r\n0.5, 8e4\r\n1.5, 9e4\r\n");
  EXPECT_EQ(sweep.axes.front().key, "position.lateral");
  EXPECT_EQ(sweep.scene(1).load.force, 9e4);
}

/// What is no key is carried along: by its name, or because the scene says so.
TEST(CaseTable, CarriesNotesAlong) {
  const SweepFile sweep = sweep_of("time,y [mm],note.place\n0.1,0.5,km 3\n0.2,1.5,km 4\n",
                                   "columns = { time = \"note\", \"y [mm]\" = \"position.lateral\" }\n");
  EXPECT_EQ(sweep.scene(1).position.lateral, 1.5);
  EXPECT_EQ(sweep.describe(1), "note.time = 0.2, position.lateral = 1.5, note.place = \"km 4\"");
  EXPECT_EQ(sweep.changes(0).size(), 1U);
  const auto message = [](const std::string& columns) {
    return message_of([&] { sweep_of("time,position.lateral\n0,1\n", columns); });
  };
  EXPECT_THAT(message("columns = { tine = \"note\" }\n"),
              AllOf(HasSubstr("no column has the name 'tine'"), HasSubstr("time, position.lateral")));
  EXPECT_THAT(message("columns = 3\n"), HasSubstr("sweep.columns cannot be that"));
  EXPECT_THAT(
      message_of([] { parse_sweep_file(wheel_rail + "columns = { a = \"note\" }\nload.force = [1, 2]\n"); }),
      HasSubstr("without a table"));
}

/// A wheel that lifts in a history: that line is refused, with its place, and the others are cases.
TEST(CaseTable, ALineMayBeNoScene) {
  const SweepFile sweep = sweep_of("position.lateral,load.force\n0,0\n1,8e4\n2,0\n");
  EXPECT_THAT(message_of([&] { sweep.scene(2); }),
              AllOf(HasSubstr("ALineMayBeNoScene.csv:4: load.force = 0"), HasSubstr("out of range")));
  EXPECT_EQ(message_of([&] { check_cases(sweep, sweep.all()); }), "no error");
  EXPECT_EQ(message_of([&] { check_cases(sweep, {0, 1}); }), "no error"); // a part of it
  EXPECT_EQ(sweep.first_scene().position.lateral, 1);
  EXPECT_THAT(message_of([&] { check_values(sweep); }), HasSubstr(".csv:2: load.force"));
  const SweepFile none = sweep_of("load.force\n0\n-1\n");
  EXPECT_THAT(message_of([&] { check_cases(none, none.all()); }), HasSubstr(".csv:2: load.force"));
}

} // namespace
