#include "bem_contact/scene/sweep_file.hpp"

#include "tests/base/message.hpp"
#include "tests/base/temporary_folder.hpp"

#include <fstream>
#include <gmock/gmock.h>

namespace {

using namespace bem_contact;
using ::testing::AllOf;
using ::testing::HasSubstr;

const std::string uneven_wheel = "rail.profile = '60E1'\nwheel.profile = 'S1002'\nload.force = 1e5\n"
                                 "wheel.flat.depth = 0.5\n";

SweepFile passage_of(const std::string& table, const std::string& path = "", const std::string& more = "") {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "run.csv") << path;
  SceneText text{uneven_wheel + more + "[passage]\n" + table, "passage.toml"};
  text.folder = folder.path();
  return parse_sweep_file(text);
}

TEST(Passage, IsAListOfPlaces) {
  const SweepFile sweep = passage_of("from = -10\nto = 20\nstep = 5\n");
  ASSERT_EQ(sweep.size(), 7u);
  EXPECT_EQ(sweep.scene(0).position.uneven.along, -10);
  EXPECT_EQ(sweep.scene(6).position.uneven.along, 20);
  EXPECT_EQ(sweep.describe(1), "position.along = -5");
  EXPECT_EQ(passage_of("from = 0\nto = 1\ncount = 3\n").scene(1).position.uneven.along, 0.5);
  EXPECT_EQ(passage_of("from = 8\nto = 0\nstep = -4\n").scene(1).position.uneven.along, 4);
}

/// What a vehicle program says between its own places is interpolated, whichever way it ran.
TEST(Passage, FollowsAPath) {
  const std::string columns =
      "columns = { s = 'position.along', y = 'position.lateral' }\npath = 'run.csv'\n";
  for (const char* path : {"s,y,load.force,note.time\n0,1,80000,a\n10,3,90000,b\n20,3.5,100000,c\n",
                           "s,y,load.force\n20,3.5,100000\n10,3,90000\n0,1,80000\n"}) {
    const SweepFile sweep = passage_of("from = 0\nto = 20\nstep = 5\n" + columns, path);
    ASSERT_EQ(sweep.size(), 5u);
    EXPECT_DOUBLE_EQ(sweep.scene(1).position.lateral, 2);
    EXPECT_DOUBLE_EQ(*sweep.scene(3).load.force, 95000);
    EXPECT_DOUBLE_EQ(*sweep.scene(4).load.force, 100000);
    EXPECT_EQ(sweep.tables.size(), 1u);
  }
  const SweepFile own = passage_of(columns, "s,y\n20,3.5\n7,3\n0,1\n");
  ASSERT_EQ(own.size(), 3u);
  EXPECT_EQ(own.scene(0).position.uneven.along, 20);
  EXPECT_EQ(own.scene(1).position.lateral, 3);
  const SweepFile whole = passage_of(columns + "count = 5\n", "s,y\n20,3.5\n7,3\n0,1\n");
  ASSERT_EQ(whole.size(), 5u);
  EXPECT_EQ(whole.scene(1).position.uneven.along, 15);
  EXPECT_EQ(passage_of(columns + "step = 10\n", "s,y\n0,1\n25,3\n").size(), 3u);
}

TEST(Passage, OfSeveralWheelsIsAProduct) {
  const SweepFile sweep =
      passage_of("from = 0\nto = 10\nstep = 5\n", "", "sweep.wheel.profile = [ 'S1002', 'P8' ]\n");
  ASSERT_EQ(sweep.size(), 6u);
  EXPECT_EQ(sweep.scene(2).wheel.profile, "S1002");
  EXPECT_EQ(sweep.scene(3).wheel.profile, "P8");
  EXPECT_EQ(sweep.scene(3).position.uneven.along, 0);
}

TEST(Passage, SaysWhatIsWrong) {
  const auto message = [](const std::string& table, const std::string& path = "") {
    return message_of([&] { passage_of(table, path).scene(0); });
  };
  EXPECT_THAT(message(""), HasSubstr("neither places nor a path"));
  EXPECT_THAT(message("from = 0\nto = 10\n"),
              HasSubstr("passage.toml:5: the range of passage is not complete"));
  EXPECT_THAT(message("from = 0\nto = 10\nstep = -1\n"), HasSubstr("never ends"));
  EXPECT_THAT(message("from = 0\nto = 10\nstep = 1\nstepp = 1\n"), HasSubstr("Did you mean passage.step"));
  for (const auto& [table, meant] : {std::pair{"from = 0\nto = 10\nstp = 1\n", "passage.step"},
                                     {"form = 0\nto = 10\nstep = 1\n", "passage.from"},
                                     {"from = 0\nto = 10\ncont = 3\n", "passage.count"},
                                     {"pth = 'run.csv'\n", "passage.path"},
                                     {"path = 'run.csv'\ncolums = { s = 'position.along' }\n",
                                      "passage.columns"}}) // before what is missing without it
    EXPECT_THAT(message(table, "s\n0\n20\n"), HasSubstr(std::string("Did you mean ") + meant)) << table;
  EXPECT_THAT(message("path = 3\n"), HasSubstr("names no file"));
  EXPECT_THAT(message("from = 0\nto = 9\nstep = 1\ncolumns = { s = 'note' }\n"), HasSubstr("without a path"));
  EXPECT_THAT(message("path = 'gone.csv'\n"), HasSubstr("gone.csv"));
  EXPECT_THAT(message("path = 'run.csv'\n", "load.force\n1e4\n"), HasSubstr("has no column position.along"));
  EXPECT_THAT(message("path = 'run.csv'\n", "position.alng,load.force\n0,1e4\n"),
              HasSubstr("Is it the column position.alng?"));
  EXPECT_THAT(message("path = 'run.csv'\n", "x,position.lateral\n0,1\n"),
              HasSubstr("say which it is: passage.columns")); // a key of its own is no misspelt one
  EXPECT_THAT(message_of([] {
                parse_sweep_file(SceneText{uneven_wheel + "[pasage]\nfrom = 0\n", "passage.toml"});
              }),
              HasSubstr("Did you mean passage"));
  EXPECT_THAT(message("path = 'run.csv'\n", "position.along\n0\n5\n5\n"),
              AllOf(HasSubstr("run.csv:4"), HasSubstr("stands still or turns back")));
  EXPECT_THAT(message("path = 'run.csv'\nfrom = 0\nto = 30\nstep = 10\n", "position.along\n0\n20\n"),
              HasSubstr("The passage is at 30 mm"));
  EXPECT_THAT(message("path = 'run.csv'\n", "position.along,motion.frictionless\n0,true\n20,false\n"),
              AllOf(HasSubstr("run.csv:2"), HasSubstr("is no number")));
  EXPECT_THAT(message_of([] {
                parse_sweep_file(SceneText{uneven_wheel + "passage = 3\n", "passage.toml"});
              }),
              HasSubstr("passage is no table"));
}

} // namespace
