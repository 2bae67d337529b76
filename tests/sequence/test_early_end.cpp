// Solutions that end early, because a rough one already says that its elements are too large; and what
// further solutions of a case take from those before.
#include "bem_contact/sequence/solution/solve_on_grid.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/contact/solve.hpp"
#include "bem_contact/sequence/asked_error.hpp"
#include "bem_contact/sequence/plan/element_size.hpp"
#include "bem_contact/sequence/sequence.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace {

using namespace bem_contact;

SceneFile halfspace_scene(const std::string& more) {
  return parse_scene_file(
      fmt::format("rail.profile = '60E1'\nwheel.profile = 'S1002'\nsolver.model = 'halfspace'\n"
                  "motion.free_rolling = false\n{}",
                  more));
}

const std::string with_given_elements =
    "position.lateral = 5.3\nposition.yaw = 0.004\nload.force = 1e5\ngrid = { dx = 0.5, ds = 0.4 }\n";

/// Of a scene whose elements are given.
GridSolution solve_scene(const SceneFile& scene, const EarlyEnd* early_end) {
  SequenceFiles files;
  const ContactCase asked = prepare_case(scene, files);
  WorkBudget work;
  return solve_on_grid(asked, asked.setup.on(first_plan(asked, scene.grid, false)), {Model::halfspace},
                       {.work = work, .early_end = early_end});
}

TEST(EarlyEnd, ARoughSolutionKnowsItsErrors) {
  const SceneFile scene = halfspace_scene(with_given_elements);
  const GridSolution whole = solve_scene(scene, nullptr);
  const ContactResult& precise = whole.result;
  ASSERT_TRUE(precise.certified());
  int looks = 0;
  const EarlyEnd early_end{2e-3, [&](const ContactProblem& problem, const ContactResult& rough) {
                             ++looks;
                             EXPECT_FALSE(rough.certified());
                             EXPECT_EQ(problem.grid.size(), whole.contact.problem.grid.size());
                             return true;
                           }};
  const ContactResult rough = solve_scene(scene, &early_end).result;
  EXPECT_EQ(looks, 1);
  EXPECT_TRUE(rough.trust.ended_early);
  EXPECT_FALSE(rough.certified());
  EXPECT_FALSE(rough.trust.certificate.holds());
  EXPECT_LT(rough.effort.outer_iterations, precise.effort.outer_iterations);
  EXPECT_NEAR(rough.totals.Fz, precise.totals.Fz, 3e-3 * precise.totals.Fz);
  EXPECT_NEAR(rough.totals.Fx, precise.totals.Fx, 3e-3 * precise.totals.Fz);
  EXPECT_NEAR(rough.totals.Fy, precise.totals.Fy, 3e-3 * precise.totals.Fz);
  ASSERT_TRUE(rough.trust.discretisation) << rough.trust.why_no_errors;
  for (const auto number : {&ContactTotals::Fx, &ContactTotals::Fy, &ContactTotals::pmax,
                            &ContactTotals::area, &ContactTotals::adhesion_share, &ContactTotals::approach})
    EXPECT_NEAR((rough.totals.*number).error, (precise.totals.*number).error,
                0.1 * (precise.totals.*number).error);
  EXPECT_NEAR(asked_error(scene.grid, rough), asked_error(scene.grid, precise),
              0.1 * precise.trust.certificate.discretisation);
}

TEST(EarlyEnd, ALookThatDoesNotEndChangesNothing) {
  const SceneFile scene = halfspace_scene(with_given_elements);
  int looks = 0;
  const EarlyEnd early_end{2e-3, [&](const ContactProblem&, const ContactResult&) {
                             ++looks;
                             return false;
                           }};
  const ContactResult looked = solve_scene(scene, &early_end).result,
                      precise = solve_scene(scene, nullptr).result;
  EXPECT_EQ(looks, 1);
  EXPECT_TRUE(looked.certified());
  EXPECT_FALSE(looked.trust.ended_early);
  EXPECT_EQ(looked.pn, precise.pn);
  EXPECT_EQ(looked.px, precise.px);
  EXPECT_EQ(looked.ps, precise.ps);
  ASSERT_TRUE(looked.trust.discretisation); // its companion began from the rough solution
  EXPECT_NEAR(looked.trust.certificate.discretisation, precise.trust.certificate.discretisation,
              1e-3 * precise.trust.certificate.discretisation);
}

/// Nothing is rough where one outer iteration solves the problem.
TEST(EarlyEnd, WithoutCouplingThereIsNoLook) {
  const EarlyEnd early_end{1.0, [](const ContactProblem&, const ContactResult&) -> bool {
                             throw InputError("It looked", "one outer iteration is enough", "");
                           }};
  const SceneFile scene = halfspace_scene(with_given_elements + "motion.frictionless = true\n");
  EXPECT_TRUE(solve_scene(scene, &early_end).result.certified());
}

/// A case that is solved several times ends with a precise solution, on elements that nobody ended early.
TEST(EarlyEnd, OnlyTheLastSolutionOfACaseIsPrecise) {
  Sequence sequence;
  for (const double accuracy : {0.02, 0.01, 0.005}) {
    const int before = sequence.counts().solves;
    const SceneResult r = sequence.solve(halfspace_scene(
        fmt::format("position.lateral = 5.35\nload.force = 5e4\ngrid.accuracy = {}\n", accuracy)));
    EXPECT_TRUE(r.result.certified()) << accuracy;
    EXPECT_FALSE(r.result.trust.ended_early) << accuracy;
    EXPECT_TRUE(r.result.trust.certificate.holds()) << accuracy;
    EXPECT_LE(r.result.trust.certificate.discretisation, accuracy);
    EXPECT_GT(sequence.counts().solves, before + 1) << "the case says nothing";
  }
}

/// On the flange shear bears against the load so much that the force on the rail is 20 times the load. The
/// second time the case starts from its own solution, and must not look for that balance anew.
TEST(EarlyEnd, AStartOnTheFlangeKnowsTheBalance) {
  Sequence sequence;
  const SceneFile scene =
      halfspace_scene("position.lateral = 6.9\nposition.yaw = -0.01\nmotion.friction = 0.33\n"
                      "load.force = 3400\ngrid = { dx = 0.6, ds = 0.5 }\n");
  const SceneResult first = sequence.solve(scene), second = sequence.solve(scene);
  ASSERT_TRUE(first.result.certified() && second.result.certified());
  EXPECT_GT(first.result.totals.Fy, 15 * first.result.totals.Fz);
  EXPECT_NEAR(second.result.totals.Fy, first.result.totals.Fy, 1e-6 * first.result.totals.Fy);
  EXPECT_LT(second.result.effort.outer_iterations, first.result.effort.outer_iterations);
  EXPECT_LE(second.result.effort.outer_iterations, 2);
}

} // namespace
