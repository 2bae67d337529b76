#include "bem_contact/base/error.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "bem_contact/uses/table/scene_table.hpp"
#include "tests/base/message.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <fmt/core.h>

namespace {

using namespace bem_contact;
using namespace bem_contact::table;
using ::testing::HasSubstr;
using ::testing::StartsWith;

SceneTable described(const std::string& lists, const std::string& more = "") {
  return parse_scene_table(
      {"rail.profile = \"60E1\"\nwheel.profile = \"S1002\"\nsolver.model = \"halfspace\"\n"
       "motion.xi = 1e-3\nmotion.free_rolling = false\n"
       "grid.dx = 1\ngrid.ds = 1\nposition.rail_inclination = 0.025\n" +
           more + "[table]\n" + lists,
       "scene"});
}

/// Values are those of the scenes, and hold in between.
TEST(SceneTable, IsWhatItsScenesGive) {
  const SceneTable order = described("position.lateral = { from = -3, to = -1, count = 3 }\n"
                                     "load.force = [ 4e4, 6e4, 8e4 ]\nhold = [ \"Fx\", \"Fy\", \"area\" ]\n");
  ContactTable t = table_of(order);
  const PointSolver solve = scene_point_solver(order);
  refine(t, one_by_one(solve), {.tolerance = 0.05, .rescale = rescale});
  EXPECT_EQ(t.axes[1].unit, "N");
  EXPECT_NEAR(t.column("Fx").scale, 8e4, 1);
  EXPECT_FALSE(t.column("pmax").held);
  SceneFile alone = first_scene(order);
  alone.position.lateral = -2;
  alone.load.force = 6e4;
  const SceneResult r = Sequence().solve(alone);
  EXPECT_NEAR(interpolate(t, t.column("Fx"), Point{-2, 6e4}), r.result.totals.Fx, 1e-5 * 6e4);
  EXPECT_NEAR(interpolate(t, t.column("patch_semi_axis_a"), Point{-2, 6e4}), r.result.patches[0].semi_axis_a,
              1e-3);
  for (const Point& p : {Point{-2.7, 4.3e4}, Point{-1.4, 7.2e4}, Point{-1.1, 5.5e4}}) {
    const std::vector<double> solved = solve(p).values;
    for (std::size_t c = 0; c < t.columns.size(); ++c)
      if (const Column& column = t.columns[c]; column.held) {
        EXPECT_NEAR(interpolate(t, column, p), solved[c], 0.06 * column.scale) << column.name << p[0];
      }
  }
}

TEST(SceneTable, SaysWhatIsWrong) {
  const auto refused = [](const std::string& lists, const char* word, const std::string& more = "") {
    try {
      table_of(described(lists, more));
      ADD_FAILURE() << lists;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(word)) << lists;
    }
  };
  refused("", "describes no table");
  refused("load.force = 1e5\n", "table.load.force is a single value");
  refused("load.force = [ 1e5 ]\n", "or there is only one");
  refused("load.force = [ 1e5, 5e4 ]\n", "do not grow");
  refused("load.forse = [ 1e4, 5e4 ]\n", "load.force");
  refused("load.force = [ -1e4, 5e4 ]\n", "load.force");
  refused("load.force = [ 1e4, 5e4 ]\nrail.profile = [ \"60E1\" ]\n", "no number");
  refused("load.force = [ 1e4, 5e4 ]\nhold = [ \"Fq\" ]\n", "The table has no 'Fq'");
  refused("hold = [ \"Fx\" ]\n", "no axis", "load.force = 1e4\n");
  refused("load.force = { from = 1, to = 2, steps = 3 }\n", "range of table.load.force");
  // Two bodies that do not meet: the point is named.
  const SceneTable apart = described("position.lateral = [ 0, 200 ]\n", "load.force = 1e5\n");
  EXPECT_THAT(message_of([&] { scene_point_solver(apart)({200}); }),
              StartsWith("The table has no value at position.lateral = 200: "));
}

} // namespace
