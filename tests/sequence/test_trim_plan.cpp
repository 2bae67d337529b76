// Large grids that are cut down to what a rough solution says: the contact must be the one of the whole grid.
#include "bem_contact/sequence/solution/trim_plan.hpp"

#include "bem_contact/sequence/numbers/sequence_files.hpp"
#include "bem_contact/sequence/numbers/settings.hpp"
#include "bem_contact/sequence/plan/contact_case.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "bem_contact/sequence/solution/grow_grid.hpp"
#include "bem_contact/sequence/solution/settings.hpp"
#include "bem_contact/sequence/solution/solve_on_grid.hpp"
#include "tests/sanitized.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace {

using namespace bem_contact;

const std::string influence_files = CONFORMAL_SOURCE_DIR "/data/influence/";

SceneFile s1002_on_60e1(Model model, const std::string& more) {
  return with_model(
      parse_scene_file(
          fmt::format("rail.profile = '60E1'\nwheel.profile = 'S1002'\nrail.influence = '{0}small_rail.h5'\n"
                      "wheel.influence = '{0}small_wheel.h5'\nmotion.free_rolling = false\n{1}",
                      influence_files, more)),
      model);
}

struct TrimmedAndWhole {
  ContactCase asked;
  GridPlan plan;
  TrimmedPlan needed;
  SolveTask task;

  GridSolution solved_on(const GridPlan& on) const {
    WorkBudget work;
    return solve_on_grid(asked, asked.setup.on(on), task, {.work = work});
  }
};

/// `wider`: rows and columns that the plan has more on each side.
TrimmedAndWhole trim(const SceneFile& scene, const FormerSolution* start = nullptr, int wider = 0) {
  SequenceFiles of_scene;
  const SolveTask task{*scene.solver.model};
  const bool on_strips = task.model == Model::fem;
  const ContactCase asked = prepare_case(scene, of_scene);
  GridPlan plan = first_plan(asked, scene.grid, on_strips);
  plan.first -= wider;
  plan.rows += 2 * wider;
  plan.columns += 2 * wider;
  WorkBudget work;
  return {asked, plan, trimmed(asked, plan, task, {.work = work, .start = start}, on_strips), task};
}

/// Of the result's elements that are elements of `whole` too, every one that is in contact in either.
void expect_same_tractions(const GridSolution& part, const GridSolution& whole) {
  ASSERT_TRUE(whole.result.trust.certificate.holds());
  ASSERT_TRUE(part.result.trust.certificate.holds());
  EXPECT_FALSE(part.result.trust.touches_border);
  const GridPlan &few = part.contact.plan, &all = whole.contact.plan;
  const int row = few.first - all.first, column = (all.columns - few.columns) / 2;
  ASSERT_GE(row, 0);
  ASSERT_LE(row + few.rows, all.rows);
  const double pmax = std::ranges::max(whole.result.pn);
  double outside = 0;
  for (int is = 0; is < all.rows; ++is)
    for (int ix = 0; ix < all.columns; ++ix) {
      const int i = is * all.columns + ix, is_part = is - row, ix_part = ix - column;
      if (is_part < 0 || is_part >= few.rows || ix_part < 0 || ix_part >= few.columns) {
        outside = std::max(outside, whole.result.pn[i]);
        continue;
      }
      const int k = is_part * few.columns + ix_part;
      ASSERT_NEAR(part.contact.problem.gap[k], whole.contact.problem.gap[i], 1e-12);
      EXPECT_NEAR(part.result.pn[k], whole.result.pn[i], 2e-6 * pmax);
      EXPECT_NEAR(part.result.px[k], whole.result.px[i], 2e-6 * pmax);
      EXPECT_NEAR(part.result.ps[k], whole.result.ps[i], 2e-6 * pmax);
    }
  EXPECT_EQ(outside, 0);
}

const std::string at_the_gauge_corner =
    "position.lateral = 7.1\nload.force = 1e5\ngrid = { dx = 0.5, ds = 0.1 }\n";

TEST(TrimPlan, TheContactIsThatOfTheWholeGrid) {
  const TrimmedAndWhole t = trim(s1002_on_60e1(Model::fem, at_the_gauge_corner));
  EXPECT_LT(t.needed.plan.rows, 0.75 * t.plan.rows);
  expect_same_tractions(t.solved_on(t.needed.plan), t.solved_on(t.plan));
}

TEST(TrimPlan, ASecondAreaStays) {
  NEEDS_NO_SANITIZER();
  const SceneFile scene = s1002_on_60e1(
      Model::tangent_plane,
      "position.lateral = 4.8\nposition.roll = 0.001\nload.force = 2.4e4\ngrid = { dx = 0.2, ds = 0.15 }\n");
  const TrimmedAndWhole t = trim(scene, nullptr, 20);
  const GridSolution whole = t.solved_on(t.plan);
  EXPECT_EQ(whole.result.patches.size(), 2u);
  EXPECT_LT(t.needed.plan.rows, t.plan.rows);
  EXPECT_LT(t.needed.plan.columns, t.plan.columns);
  expect_same_tractions(t.solved_on(t.needed.plan), whole);
}

TEST(TrimPlan, EveryStepOfAHistoryFits) {
  const TrimmedAndWhole t = trim(s1002_on_60e1(
      Model::fem, at_the_gauge_corner +
                      "motion.kind = 'shift'\nmotion.xi = 0.01\nmotion.eta = -0.02\nmotion.steps = 3\n"));
  EXPECT_LT(t.needed.plan.rows, 0.75 * t.plan.rows);
  const GridSolution part = t.solved_on(t.needed.plan), whole = t.solved_on(t.plan);
  ASSERT_EQ(part.history.size(), 3u);
  for (const ContactResult& step : part.history)
    EXPECT_FALSE(step.trust.touches_border);
  expect_same_tractions(part, whole);
}

TEST(TrimPlan, AFormerSolutionOfTheSameContactSavesTheRoughOne) {
  const SceneFile scene = s1002_on_60e1(Model::fem, at_the_gauge_corner);
  const TrimmedAndWhole t = trim(scene);
  const GridSolution solved = t.solved_on(t.needed.plan);
  FormerSolution former =
      former_of(Model::fem, solved.contact.problem, solved.result, *t.asked.estimate).value();
  former.first_s += scene.grid.ds; // where no rough solution would put it
  --former.grid.ms;
  const GridPlan again = trim(scene, &former).needed.plan;
  EXPECT_EQ(again.first, t.needed.plan.first + 1);
  EXPECT_EQ(again.rows, t.needed.plan.rows - 1);
  former.model = Model::tangent_plane; // its contact may be smaller
  EXPECT_EQ(trim(scene, &former).needed.plan.rows, t.needed.plan.rows);
}

/// A wheel that moves aside step by step: each case is solved on fewer elements than it would be alone, with
/// the same result.
TEST(FittedPlan, FollowsTheContactOfTheFormerCase) {
  const auto scene_at = [](double lateral, double force) {
    return s1002_on_60e1(Model::fem, fmt::format("position.lateral = {}\nload.force = {}\n"
                                                 "grid = {{ dx = 0.6, ds = 0.3 }}\n",
                                                 lateral, force));
  };
  Sequence sequence;
  sequence.solve(scene_at(6.9, 8e4));
  int fewer = 0;
  for (const auto& [lateral, force] :
       {std::pair(6.91, 8e4), {6.95, 8e4}, {7.0, 8e4}, {7.0, 1e5}, {7.1, 4e4}, {7.05, 1.2e5}}) {
    const SceneFile scene = scene_at(lateral, force);
    const SceneResult after = sequence.solve(scene), alone = Sequence().solve(scene);
    ASSERT_TRUE(after.result.trust.certificate.holds()) << lateral;
    ASSERT_TRUE(alone.result.trust.certificate.holds()) << lateral;
    EXPECT_FALSE(after.result.trust.touches_border) << lateral;
    EXPECT_LE(after.problem.grid.size(), alone.problem.grid.size()) << lateral;
    fewer += after.problem.grid.ms < alone.problem.grid.ms ? 1 : 0;
    EXPECT_EQ(count_elements(after.result).contact, count_elements(alone.result).contact) << lateral;
    EXPECT_NEAR(after.result.totals.approach, alone.result.totals.approach,
                1e-6 * alone.result.totals.approach)
        << lateral;
    EXPECT_NEAR(after.result.totals.Fy, alone.result.totals.Fy, 1e-6 * force) << lateral;
    EXPECT_NEAR(after.result.totals.Fx, alone.result.totals.Fx, 1e-6 * force) << lateral;
    EXPECT_NEAR(after.result.totals.pmax, alone.result.totals.pmax, 1e-6 * 1e3) << lateral;
  }
  EXPECT_GE(fewer, 4);
}

/// The solution of a case whose potential contact is another one by a hair: of the same, the plan would be
/// kept.
FormerSolution nearly_the_same(const TrimmedAndWhole& t, const GridSolution& solved) {
  FormerSolution former =
      former_of(t.task.model, solved.contact.problem, solved.result, *t.asked.estimate).value();
  former.areas.front().s_from -= 1e-6;
  return former;
}

/// The former case says nothing useful: its contact ends where the next one has most of its own.
TEST(FittedPlan, GrowsWhereTheContactIsLargerThanExpected) {
  const SceneFile scene = s1002_on_60e1(Model::fem, at_the_gauge_corner);
  const TrimmedAndWhole t = trim(scene);
  const GridSolution whole = t.solved_on(t.plan);
  FormerSolution former = nearly_the_same(t, whole);
  const int mx = former.grid.mx, rows = former.grid.ms;
  int last = 0;
  for (int i = 0; i < former.grid.size(); ++i)
    if (former.pn[i] > 0)
      last = i / mx;
  std::fill(former.pn.begin() + static_cast<std::ptrdiff_t>(last - 6) * mx, former.pn.end(), 0.0);
  const GridPlan few = fitted(t.asked, t.plan, Model::fem, &former);
  EXPECT_TRUE(few.cropped);
  EXPECT_LT(few.rows, rows);
  EXPECT_NEAR(few.first + few.rows - 1, t.plan.first + last - 7 + cropped_margin, 1); // whole rows
  WorkBudget work;
  const GridSolution grown =
      solve_on_growing_grid(t.asked, t.asked.setup.on(few), t.task, {.work = work, .start = &former}, true);
  EXPECT_GT(grown.contact.plan.rows, few.rows);
  expect_same_tractions(grown, whole);
}

TEST(FittedPlan, IsForNumbersOfBothRowsAndOpenGrids) {
  const SceneFile scene = s1002_on_60e1(Model::fem, at_the_gauge_corner);
  const TrimmedAndWhole t = trim(scene);
  const GridSolution whole = t.solved_on(t.plan);
  const FormerSolution former = nearly_the_same(t, whole);
  EXPECT_TRUE(fitted(t.asked, t.plan, Model::tangent_plane, &former).cropped);
  EXPECT_FALSE(fitted(t.asked, t.plan, Model::halfspace, &former).cropped) << "those are translational";
  EXPECT_FALSE(fitted(t.asked, t.plan, Model::fem, nullptr).cropped);
  ContactCase by_rows = t.asked;
  by_rows.scene.grid.rows = {t.plan.s_from(), t.plan.s_to()};
  EXPECT_FALSE(fitted(by_rows, t.plan, Model::fem, &former).cropped) << "rows that are asked for are solved";
}

/// A contact that reached beyond its plan does so again: the next plan covers it from the start.
TEST(FittedPlan, CoversAContactThatReachesBeyondIt) {
  const SceneFile scene = s1002_on_60e1(Model::halfspace, at_the_gauge_corner);
  const TrimmedAndWhole t = trim(scene);
  const GridSolution whole = t.solved_on(t.plan);
  const FormerSolution former = nearly_the_same(t, whole);
  const GridPlan same = fitted(t.asked, t.plan, Model::halfspace, &former);
  EXPECT_EQ(same.rows, t.plan.rows);
  EXPECT_EQ(same.columns, t.plan.columns);
  GridPlan small = t.plan; // a plan that is too small by some rows and columns
  small.first += small.rows / 3;
  small.rows /= 3;
  small.columns -= 10;
  const GridPlan fits = fitted(t.asked, small, Model::halfspace, &former);
  EXPECT_LT(fits.first, small.first);
  EXPECT_GT(fits.columns, small.columns);
  const GridSolution again = t.solved_on(fits);
  EXPECT_FALSE(again.result.trust.touches_border);
  expect_same_tractions(again, whole);
  ContactCase by_columns = t.asked;
  by_columns.scene.grid.mx = small.columns;
  EXPECT_EQ(fitted(by_columns, small, Model::halfspace, &former).columns, small.columns);
}

/// Where the contact just reaches the edge, its solution is nearly that of the larger grid.
TEST(FittedPlan, AGrownGridStartsFromTheSmallerOne) {
  const SceneFile scene = s1002_on_60e1(Model::halfspace, at_the_gauge_corner);
  const TrimmedAndWhole t = trim(scene);
  const GridSolution whole = t.solved_on(t.plan);
  const ContactGrid& grid = whole.contact.problem.grid;
  int outside = grid.mx; // columns beside the contact, on each side
  for (int i = 0; i < grid.size(); ++i)
    if (whole.result.pn[i] > 0)
      outside = std::min({outside, i % grid.mx, grid.mx - 1 - i % grid.mx});
  GridPlan tight = t.plan;
  tight.columns -= 2 * outside;
  WorkBudget work;
  const GridSolution grown =
      solve_on_growing_grid(t.asked, t.asked.setup.on(tight), t.task, {.work = work}, false);
  EXPECT_GT(grown.contact.plan.columns, tight.columns);
  EXPECT_LT(grown.result.effort.tangential_iterations, whole.result.effort.tangential_iterations);
  expect_same_tractions(grown, whole);
}

/// Numbers of at least large_numbers, and a second solution for free rolling that must find them kept.
TEST(TrimPlan, LargeNumbersAreOfTheContactAlone) {
  SceneFile scene =
      s1002_on_60e1(Model::fem, "position.lateral = 7.1\nload.force = 1e5\ngrid = { dx = 0.5, ds = 0.03 }\n");
  scene.motion.free_rolling = true;
  SequenceFiles of_scene;
  const ContactCase asked = prepare_case(scene, of_scene);
  const GridPlan plan = first_plan(asked, scene.grid, true);
  ASSERT_TRUE(has_large_numbers(asked, plan, Model::fem));
  EXPECT_FALSE(has_large_numbers(asked, plan, Model::halfspace)) << "those are translational";
  Sequence sequence;
  const SceneResult r = sequence.solve(scene);
  ASSERT_TRUE(r.result.trust.certificate.holds());
  EXPECT_TRUE(r.motion.free_rolling);
  EXPECT_EQ(sequence.counts().numbers_kept, 1);
  const auto megabytes = [](int rows, int columns) { return 72e-6 * rows * rows * (columns + 2); };
  EXPECT_LT(megabytes(r.problem.grid.ms, r.problem.grid.mx), 0.4 * megabytes(plan.rows, plan.columns));
  EXPECT_FALSE(r.result.trust.touches_border);

  ContactCase by_rows = asked;
  by_rows.scene.grid.rows = {plan.s_from(), plan.s_to()};
  EXPECT_FALSE(has_large_numbers(by_rows, plan, Model::fem)) << "rows that are asked for are solved";
}

} // namespace
