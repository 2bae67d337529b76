#include "bem_contact/sequence/sequence.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/contact/history.hpp"
#include "bem_contact/sequence/plan/element_size.hpp"
#include "bem_contact/sequence/plan/settings.hpp"
#include "bem_contact/sequence/solution/warm_start.hpp"
#include "tests/base/message.hpp"
#include "tests/base/temporary_folder.hpp"

#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace bem_contact;
using ::testing::AllOf;
using ::testing::HasSubstr;

SceneFile rolling(double lateral, double force = 1e5, const std::string& grid = "dx = 1.0\nds = 0.6\n") {
  return parse_scene_file(
      fmt::format("kind = \"wheel_rail\"\nrail.profile = \"60E1\"\nwheel.profile = \"S1002\"\n"
                  "position.lateral = {}\nload.force = {}\nsolver.model = \"halfspace\"\n[grid]\n{}",
                  lateral, force, grid));
}

int in_contact(const SceneResult& r) {
  return count_elements(r.result).contact;
}

/// Two certified results on the same elements.
void expect_same(const SceneResult& a, const SceneResult& b) {
  ASSERT_TRUE(a.result.trust.certificate.holds());
  ASSERT_TRUE(b.result.trust.certificate.holds());
  const double scale = std::abs(a.result.totals.Fz);
  EXPECT_NEAR(a.result.totals.Fx, b.result.totals.Fx, 1e-5 * scale);
  EXPECT_NEAR(a.result.totals.Fy, b.result.totals.Fy, 1e-5 * scale);
  EXPECT_NEAR(a.result.totals.approach, b.result.totals.approach, 1e-6 * a.result.totals.approach);
  EXPECT_EQ(in_contact(a), in_contact(b));
}

/// A file cannot say so; a program can.
TEST(Sequence, AnAccuracyOfNothingIsRefused) {
  SceneFile no_error = rolling(0), no_model = rolling(0);
  no_error.grid.accuracy_of.clear();
  no_model.solver.model_tolerance_of.clear();
  EXPECT_THAT(message_of([&] { Sequence().solve(no_error); }),
              HasSubstr("grid.accuracy_of is empty (an accuracy is of something)"));
  EXPECT_THAT(message_of([&] { Sequence().solve(no_model); }),
              HasSubstr("solver.model_tolerance_of is empty (an accuracy is of something)"));
}

TEST(Sequence, FindsWhatEachCaseAloneIs) {
  Sequence sequence;
  for (const double lateral : {0.0, 0.4, 0.8, 1.2, 4.0, 6.6})
    for (const double force : {4e4, 1e5}) {
      const SceneFile scene = rolling(lateral, force);
      expect_same(Sequence().solve(scene), sequence.solve(scene));
    }
  EXPECT_EQ(sequence.counts().cases, 12);
  EXPECT_EQ(sequence.counts().solves, 12);
  EXPECT_GE(sequence.counts().starts, 6);
}

TEST(Sequence, ComparesOnTheElementsThatTheSceneAsksFor) {
  const std::vector<SceneChange> changes{{"grid.elements", SchemaValue(std::int64_t{150}), 0}};
  const SceneFile scene = read_scene_file(CONFORMAL_SOURCE_DIR "/data/scenes/conformal_small.toml", changes);
  const Comparison both = Sequence().compare(scene);
  const SceneResult alone = Sequence().solve(with_model(scene, Model::fem));
  const SceneResult &halfspace = both.at_position[0], &fem = both.at_position[1];
  EXPECT_EQ(fem.problem.grid.dx, alone.problem.grid.dx);
  EXPECT_EQ(halfspace.problem.grid.ds, alone.problem.grid.ds);
  EXPECT_EQ(both.at_forces[0].problem.grid.ds, alone.problem.grid.ds);
  EXPECT_NE(fem.problem.grid.dx, scene.grid.dx) << "that is what nobody asked for";
  EXPECT_EQ(in_contact(fem), in_contact(alone));
}

TEST(Sequence, AHalfSpaceMayHaveMoreElementsThanOtherModels) {
  const auto asked = [](int elements, std::optional<Model> model) {
    return with_model(
        rolling(0, 1e5, fmt::format("elements = {}\n[motion]\nfrictionless = true\n", elements)), model);
  };
  const double count = in_contact(Sequence().solve(asked(10000, Model::halfspace)));
  EXPECT_TRUE(count > 8000 && count < 13000) << count;
  EXPECT_NO_THROW(Sequence().check(asked(12000, Model::hertz)));
  for (const std::optional<Model> model : {std::optional(Model::tangent_plane), std::optional<Model>()}) {
    EXPECT_NO_THROW(Sequence().check(asked(4000, model)));
    EXPECT_THAT(message_of([&] { Sequence().check(asked(4001, model)); }),
                AllOf(HasSubstr("grid.elements = 4001"), HasSubstr("at most 4000")));
  }
}

TEST(Sequence, EachSwitchChangesTheWayAndNotTheResult) {
  for (const SequenceAblation off :
       {SequenceAblation{.keep_files = false}, SequenceAblation{.keep_numbers = false},
        SequenceAblation{.keep_start = false}, SequenceAblation{.learn = false}}) {
    Sequence sequence({.ablation = off});
    sequence.solve(rolling(1.0));
    expect_same(Sequence().solve(rolling(1.1)), sequence.solve(rolling(1.1)));
    EXPECT_EQ(sequence.counts().starts, off.keep_start ? 1 : 0);
  }
}

TEST(Sequence, ComputesTheNumbersOfAGridOnce) {
  Sequence sequence({.ablation = {.learn = false}});
  SceneFile scene = rolling(1.0);
  scene.motion.free_rolling = false; // one solution a case
  for (const double friction : {0.1, 0.2, 0.3}) {
    scene.motion.friction = friction;
    sequence.solve(scene);
  }
  EXPECT_EQ(sequence.counts().numbers_kept, 2);
}

TEST(Sequence, ReadsAProfileOnce) {
  const TemporaryFolder folder;
  const auto file = folder / "rail.txt";
  std::filesystem::copy_file(std::filesystem::path(CONFORMAL_SOURCE_DIR) / "data/bodies/worn_rail.txt", file);
  SceneFile scene = rolling(0.0);
  scene.rail.profile = file.string();
  Sequence keeps, reads({.ablation = {.keep_files = false}});
  EXPECT_NO_THROW(keeps.solve(scene));
  EXPECT_NO_THROW(reads.solve(scene));
  std::filesystem::remove(file);
  EXPECT_NO_THROW(keeps.solve(scene));
  EXPECT_THROW(reads.solve(scene), InputError);
}

TEST(Sequence, HoldsTheNumberOfElementsWhateverTheForce) {
  Sequence sequence;
  for (const double lateral : {-2.0, 1.0})
    for (const double force : {1e3, 2e4, 1.5e5}) {
      const int contact = in_contact(sequence.solve(rolling(lateral, force, "elements = 200\n")));
      EXPECT_GE(contact, 130) << lateral << " " << force;
      EXPECT_LE(contact, 320) << lateral << " " << force;
    }
}

TEST(Sequence, AnAccuracyIsReachedWithMoreElementsTheFinerItIs) {
  int before = 0;
  for (const double accuracy : {0.05, 0.01}) {
    Sequence sequence;
    int most = 0;
    for (const double lateral : {-1.0, -0.8, 4.2}) {
      const SceneResult r = sequence.solve(rolling(lateral, 1e5, fmt::format("accuracy = {}\n", accuracy)));
      EXPECT_TRUE(r.result.trust.certificate.holds());
      EXPECT_GT(r.result.trust.certificate.discretisation, 0);
      EXPECT_LE(r.result.trust.certificate.discretisation, accuracy) << lateral;
      most = std::max(most, in_contact(r));
    }
    EXPECT_GT(most, before);
    before = most;
  }
}

TEST(Sequence, OtherScenesAreSolvedByThemselves) {
  const SceneFile patch =
      parse_scene_file("kind = \"patch\"\nload.force = 1e4\nmotion.xi = 1e-3\n[grid]\ndx = 0.5\nds = "
                       "0.5\nmx = 16\nms = 16\n[gap]\na = 1e-3\nb = 1e-3\n");
  Sequence sequence;
  sequence.solve(rolling(1.0));
  EXPECT_EQ(sequence.solve(patch).result.totals.Fx, Sequence().solve(patch).result.totals.Fx);
  EXPECT_EQ(sequence.counts().starts, 0);
}

/// On the few elements that come first pmax changes by a quarter from larger ones: no error can be told.
TEST(Sequence, AnAccuracyIsReachedWherePmaxDoesNotConvergeAtFirst) {
  const std::string scene =
      "rail.profile = \"60E1\"\nwheel.profile = \"S1002\"\nposition.rail_inclination = 0.025\n"
      "load.force = 8e4\nsolver.model = \"halfspace\"\n";
  const double exact =
      Sequence().solve(parse_scene_file(scene + "grid.dx = 0.25\ngrid.ds = 0.1\n")).result.totals.pmax;
  for (const double accuracy : {0.05, 0.02}) {
    const SceneResult r =
        Sequence().solve(parse_scene_file(scene + fmt::format("grid.accuracy = {}\n", accuracy)));
    ASSERT_TRUE(r.result.certified() && r.result.trust.discretisation);
    EXPECT_TRUE(r.result.trust.discretisation->converges);
    EXPECT_LE(r.result.totals.pmax.error, accuracy * exact);
    EXPECT_NEAR(r.result.totals.pmax, exact, accuracy * exact);
  }
}

TEST(Sequence, TheShortestElementOfTheFilesIsKept) {
  ContactEstimate estimate;
  estimate.slices = {RailSlice{.s = 0, .half = 1e-3, .position = {}},
                     RailSlice{.s = 0.1, .half = 1e-3, .position = {}}};
  estimate.approach = 0.1;
  const auto [dx, ds] = size_of_elements(estimate, 3000, 1.0, {.shortest = 0.5, .longest = 1.1});
  EXPECT_EQ(dx, 0.5);
  EXPECT_LT(size_of_elements(estimate, 3000, 1.0, {.longest = 1.1}).first, 0.5);
  EXPECT_EQ(ds, 0.125);
  const double area = contact_extent(estimate).area;
  const auto [free_dx, free_ds] = size_of_elements(estimate, 3000, 1.0, {.longest = 1.1});
  EXPECT_LE(free_dx * free_ds, 1.001 * area / 3000);
}

/// Where the files have no shorter elements, rows are as narrow as beside shorter ones: narrower rows leave
/// the error of the length, and numbers of files cost the square of the rows.
TEST(Sequence, RowsDoNotMakeUpForTheLengthOfElements) {
  ContactEstimate estimate;
  for (int i = 0; i < 60; ++i)
    estimate.slices.push_back(RailSlice{.s = 0.1 * i, .half = 1e-3, .position = {}});
  estimate.approach = 0.1;
  const ContactExtent extent = contact_extent(estimate);
  const auto size = [&](int elements, const ElementLimits& limits) {
    return size_of_elements(estimate, elements, 1.0, limits);
  };
  const auto [free_dx, free_ds] = size(1000, {});
  const auto [dx, ds] = size(1000, {.shortest = 1.5 * free_dx});
  EXPECT_EQ(dx, 1.5 * free_dx);
  EXPECT_NEAR(ds / free_ds, 1, 0.19); // one size of the ladder
  // An estimate needs a number of elements, and a scene may ask for one.
  for (const int fewest : {180, 300}) {
    const double shortest = 1.5 * size(fewest, {}).first;
    const auto [length, width] = size(fewest, {.shortest = shortest, .fewest = fewest});
    EXPECT_EQ(length, shortest);
    EXPECT_GE(extent.area / length / width, 0.999 * fewest);
  }
}

TEST(Sequence, ElementsAreGivenInOneWay) {
  EXPECT_THROW(rolling(0.0, 1e5, "elements = 100\nmx = 20\n"), InputError);
  EXPECT_THROW(rolling(0.0, 1e5, "accuracy = 0.6\n"), InputError);
}

TEST(ElementCount, MoreWhereTheErrorIsTooLargeFewerWhereItIsNot) {
  ElementCount count(200, 0.02);
  EXPECT_TRUE(count.learn(200, 0.04));
  EXPECT_GT(count.wanted(), 260);
  EXPECT_LE(count.wanted(), 800);
  EXPECT_FALSE(count.learn(600, 0.002));
  EXPECT_GE(count.wanted(), 200);
  EXPECT_LT(count.wanted(), 0.35 * 600); // no less than 0.35 of the last, and from there towards the usual
  EXPECT_FALSE(count.learn(250, 1e-6));
  EXPECT_EQ(count.wanted(), fewest_elements);
}

TEST(ElementCount, ACaseThatNeededManySaysLittleOfTheNext) {
  ElementCount count(200, 0.02);
  EXPECT_FALSE(count.learn(800, 0.0199)); // 1.1 * 800 would serve the same case
  EXPECT_NEAR(count.wanted(), std::sqrt(200 * 1.1 * 800), 3);
}

TEST(ElementCount, WithoutAnEstimateTwiceAsMany) {
  ElementCount count(100, 0.02);
  EXPECT_TRUE(count.learn(90, -1));
  EXPECT_EQ(count.wanted(), 200);
}

TEST(ElementCount, NeverBeyondTheMost) {
  ElementCount count(0, 1e-6);
  for (int i = 0; i < 20 && count.learn(count.wanted(), 0.1); ++i) {
  }
  EXPECT_EQ(count.wanted(), count.most());
  EXPECT_FALSE(count.learn(count.most(), 0.1));
}

TEST(ElementCount, AFinerAccuracyMayHaveMoreElements) {
  EXPECT_LT(ElementCount(0, 0.05).most(), 2000);
  EXPECT_GT(ElementCount(0, 0.001, 100000).most(), 5 * ElementCount(0, 0.01).most());
  EXPECT_EQ(ElementCount(0, 0.001, 5000).most(), 5000);
  EXPECT_GT(ElementCount(0, 0.001).wanted(), ElementCount(0, 0.02).wanted());
}

TEST(ElementCount, AnotherContactStartsWithWhatIsUsual) {
  ElementCount count(0, 0.02);
  EXPECT_TRUE(count.learn(200, 0.1));
  EXPECT_GT(count.wanted(), 600);
  count.forget();
  EXPECT_EQ(count.wanted(), 200);
}

TEST(ElementCount, WithoutAnAccuracyItStays) {
  ElementCount count(300, 0);
  EXPECT_FALSE(count.learn(100, 0.5));
  EXPECT_EQ(count.wanted(), 300);
}

/// A smooth field on a grid: an ellipsoid of semi-axes a, b about (0, s0).
FormerSolution ellipsoid(double a, double b, double s0) {
  FormerSolution f;
  f.grid = {60, 60, 4 * a / 60, 4 * b / 60, -2 * a + 2 * a / 60};
  f.first_s = s0 - 2 * b + 2 * b / 60;
  f.areas = {{s0 - b, s0 + b, -a, a}};
  f.force = 1000;
  f.approach = 0.1;
  for (int i = 0; i < f.grid.size(); ++i) {
    const double x = f.grid.x(i % 60) / a, s = (f.first_s + (i / 60) * f.grid.ds - s0) / b;
    f.pn.push_back(std::exp(-x * x - s * s));
    f.px.push_back(0.1 * f.pn.back());
    f.ps.push_back(x * f.pn.back());
  }
  return f;
}

TEST(StartFrom, MovesWithTheAreaAndScalesWithTheForce) {
  const FormerSolution former = ellipsoid(4, 3, -10);
  ContactProblem problem;
  problem.grid = {50, 40, 0.3, 0.25, -7.2 + 1.5};
  for (int is = 0; is < 40; ++is)
    problem.rows.push_back({-8 + 0.25 * (is - 20), {}, 0});
  const std::vector<PotentialArea> areas{{-8 - 6, -8 + 6, 1.5 - 8, 1.5 + 8}}; // twice as large
  ASSERT_TRUE(alike(areas, former.areas));
  const StartingPoint start = start_from(former, problem, areas, 8000);
  EXPECT_DOUBLE_EQ(start.approach, 0.4);
  for (int i = 0; i < problem.grid.size(); ++i) {
    const double x = (problem.grid.x(i % 50) - 1.5) / 8, s = (problem.rows[i / 50].s + 8) / 6;
    if (std::hypot(x, s) < 0.9) {
      EXPECT_NEAR(start.pn[i], 2 * std::exp(-x * x - s * s), 0.02);
      EXPECT_NEAR(start.ps[i], 2 * x * std::exp(-x * x - s * s), 0.02);
    }
  }
}

/// Two areas that move apart: each takes its own tractions along.
TEST(StartFrom, EachAreaMovesByItself) {
  FormerSolution former = ellipsoid(2, 2, 0);
  former.grid = {30, 100, 0.2, 0.2, -2.9};
  former.first_s = -9.9;
  former.areas = {{-8, -4, -2, 2}, {4, 8, -2, 2}};
  former.pn.clear();
  for (int i = 0; i < former.grid.size(); ++i) {
    const double s = former.first_s + (i / 30) * 0.2;
    former.pn.push_back(std::exp(-std::pow(s + 6, 2)) + 3 * std::exp(-std::pow(s - 6, 2)));
  }
  former.px = former.ps = former.pn;
  ContactProblem problem;
  problem.grid = {20, 100, 0.2, 0.2, -1.9};
  for (int is = 0; is < 100; ++is)
    problem.rows.push_back({-9.9 + 0.2 * is, {}, 0});
  const std::vector<PotentialArea> areas{{-9, -5, -2, 2}, {5, 9, -2, 2}};
  ASSERT_TRUE(alike(areas, former.areas));
  const StartingPoint start = start_from(former, problem, areas, 1000);
  for (int is = 10; is < 90; ++is) {
    const double s = problem.rows[is].s;
    const double expected = s < 0 ? std::exp(-std::pow(s + 7, 2)) : 3 * std::exp(-std::pow(s - 7, 2));
    EXPECT_NEAR(start.pn[is * 20 + 10], expected, 0.04) << s;
  }
}

TEST(ExpectedContact, MovesWithItsAreaAndAnAreaWithoutContactStaysWhole) {
  FormerSolution former = ellipsoid(2, 2, 0);
  former.grid = {30, 100, 0.2, 0.2, -2.9};
  former.first_s = -9.9;
  former.areas = {{-8, -4, -2, 2}, {4, 8, -2, 2}};
  for (int i = 0; i < former.grid.size(); ++i) { // a disc of radius 1 in the middle of the first
    const double s = former.first_s + (i / 30) * 0.2;
    former.pn.resize(former.grid.size());
    former.pn[i] = std::hypot(former.grid.x(i % 30), s + 6) < 1.001 ? 1 : 0;
  }
  const std::vector<PotentialArea> areas{{-11, -3, -4, 4}, {5, 9, -1, 3}}; // twice as large; moved
  const PotentialArea both = expected_contact(former, areas);
  EXPECT_NEAR(both.s_from, -7 - 2 * 0.9, 1e-12); // middles of the elements, 0.2 mm apart
  EXPECT_EQ(both.s_to, 9);
  EXPECT_NEAR(both.x_from, -2 * 0.9, 1e-12);
  EXPECT_EQ(both.x_to, 3);
}

TEST(StartFrom, OtherAreasAreNoStart) {
  const std::vector<PotentialArea> one{{0, 4, -3, 3}}, two{{0, 4, -3, 3}, {20, 22, 1, 5}};
  EXPECT_TRUE(alike(one, one));
  EXPECT_TRUE(alike(two, two));
  EXPECT_FALSE(alike(one, two));
  EXPECT_FALSE(alike(one, {{5, 9, -3, 3}}));                 // elsewhere along s
  EXPECT_FALSE(alike(one, {{0, 4, 7, 13}}));                 // elsewhere along x
  EXPECT_FALSE(alike(two, {{0, 4, -3, 3}, {30, 32, 1, 5}})); // only one of them
  EXPECT_FALSE(alike({}, one));
}

} // namespace
