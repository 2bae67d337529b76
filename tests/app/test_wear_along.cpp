// `bem_contact wear` and `bem_contact fatigue` of a passage along the track.
#include "bem_contact/h5/table.hpp"
#include "tests/app/run_program.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace {

using namespace bem_contact;
using ::testing::HasSubstr;

class WearAlongTheTrack : public ProgramTest {
protected:
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string text(const std::string& name) const {
    std::ifstream in(folder_ / name);
    return {std::istreambuf_iterator<char>(in), {}};
  }
};

/// Wing and nose wear where they bear the wheel, section by section; the scene of a step is the passage over
/// what is left, and a study goes on where it ended.
TEST_F(WearAlongTheTrack, ACrossingWearsWhereTheWheelComesDown) {
  ASSERT_EQ(run("new --crossing 9 --wheel S1002 --rail 60E1 -o " + path("crossing.toml")).code, 0);
  std::string whole = text("crossing.toml");
  whole.insert(whole.find("friction ="), "free_rolling = false\n");
  const std::string table = "[passage]\n";
  const std::size_t first = whole.find(table), last = whole.find("\n\n", first);
  const std::string crossing =
      write("crossing.toml",
            whole.substr(0, first) + table + "from = 140\nto = 260\nstep = 40" + whole.substr(last))
          .string();
  const std::string wear = "wear " + crossing + " -o " + path("worn") + " --smoothing 1 --depth ";
  const Outcome worn = run(wear + "0.02");
  ASSERT_EQ(worn.code, 0) << worn.err;
  EXPECT_THAT(worn.out, HasSubstr("Along the rail that is at "));
  const auto stretch = [&](const char* file, const char* column) {
    return read_h5(path(file)).datasets.at(std::string("stretch/") + column).values;
  };
  const std::vector<double> at = stretch("worn/wear.h5", "at"), depth = stretch("worn/wear.h5", "depth");
  ASSERT_GT(at.size(), 10u);
  const std::size_t deepest = std::ranges::max_element(depth) - depth.begin();
  EXPECT_GT(at[deepest], 150);
  EXPECT_LT(at[deepest], 290);
  EXPECT_NEAR(depth[deepest], 0.02, 1e-6);
  for (std::size_t i = 0; i < at.size(); ++i)
    if (at[i] < 60 || at[i] > 320) {
      EXPECT_EQ(depth[i], 0) << at[i];
    }
  const Outcome next = run("sweep " + path("worn/scene_0001.toml") + " -o " + path("next.h5"));
  ASSERT_EQ(next.code, 0) << next.err;
  EXPECT_THAT(next.out, HasSubstr("4 of 4 cases are certified"));
  const Outcome on = run(wear + "0.03 --jobs 2");
  ASSERT_EQ(on.code, 0) << on.err;
  EXPECT_THAT(on.out, HasSubstr("continued after step 1"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "worn/rail_0002_001.txt"));
  EXPECT_THAT(text("worn/stretch.csv"), HasSubstr("at"));
  EXPECT_NEAR(stretch("worn/wear.h5", "depth")[deepest], 0.03, 1e-6);
  // Fatigue says where, too.
  const Outcome cracks = run("fatigue " + crossing + " --csv " + path("cracks.csv"));
  ASSERT_EQ(cracks.code, 0) << cracks.err;
  EXPECT_THAT(cracks.out, HasSubstr("Along the track the surface suffers most at "));
  EXPECT_THAT(text("cracks.csv"), HasSubstr("along_mm"));
}

} // namespace
