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
  ASSERT_TRUE(precise.converged);
  int looks = 0;
  const EarlyEnd early_end{2e-3, [&](const ContactProblem& problem, const ContactResult& rough) {
                             ++looks;
                             EXPECT_FALSE(rough.converged);
                             EXPECT_EQ(problem.grid.size(), whole.contact.problem.grid.size());
                             return true;
                           }};
  const ContactResult rough = solve_scene(scene, &early_end).result;
  EXPECT_EQ(looks, 1);
  EXPECT_TRUE(rough.ended_early);
  EXPECT_FALSE(rough.converged);
  EXPECT_FALSE(rough.certificate.holds());
  EXPECT_LT(rough.outer_iterations, precise.outer_iterations);
  EXPECT_NEAR(rough.Fz, precise.Fz, 3e-3 * precise.Fz);
  EXPECT_NEAR(rough.Fx, precise.Fx, 3e-3 * precise.Fz);
  EXPECT_NEAR(rough.Fy, precise.Fy, 3e-3 * precise.Fz);
  ASSERT_TRUE(rough.discretisation) << rough.why_no_errors;
  const TotalErrors &a = rough.discretisation->errors, &b = precise.discretisation->errors;
  for (const auto error : {&TotalErrors::Fx, &TotalErrors::Fy, &TotalErrors::pmax, &TotalErrors::area,
                           &TotalErrors::adhesion_share, &TotalErrors::approach})
    EXPECT_NEAR(a.*error, b.*error, 0.1 * b.*error);
  EXPECT_NEAR(asked_error(scene.grid, whole.contact.problem, rough),
              asked_error(scene.grid, whole.contact.problem, precise),
              0.1 * precise.certificate.discretisation);
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
  EXPECT_TRUE(looked.converged);
  EXPECT_FALSE(looked.ended_early);
  EXPECT_EQ(looked.pn, precise.pn);
  EXPECT_EQ(looked.px, precise.px);
  EXPECT_EQ(looked.ps, precise.ps);
  ASSERT_TRUE(looked.discretisation); // its companion began from the rough solution
  EXPECT_NEAR(looked.certificate.discretisation, precise.certificate.discretisation,
              1e-3 * precise.certificate.discretisation);
}

/// Nothing is rough where one outer iteration solves the problem.
TEST(EarlyEnd, WithoutCouplingThereIsNoLook) {
  const EarlyEnd early_end{1.0, [](const ContactProblem&, const ContactResult&) -> bool {
                             throw InputError("It looked", "one outer iteration is enough", "");
                           }};
  const SceneFile scene = halfspace_scene(with_given_elements + "motion.frictionless = true\n");
  EXPECT_TRUE(solve_scene(scene, &early_end).result.converged);
}

/// A case that is solved several times ends with a precise solution, on elements that nobody ended early.
TEST(EarlyEnd, OnlyTheLastSolutionOfACaseIsPrecise) {
  Sequence sequence;
  for (const double accuracy : {0.02, 0.01, 0.005}) {
    const int before = sequence.counts().solves;
    const SceneResult r = sequence.solve(halfspace_scene(
        fmt::format("position.lateral = 5.35\nload.force = 5e4\ngrid.accuracy = {}\n", accuracy)));
    EXPECT_TRUE(r.result.converged) << accuracy;
    EXPECT_FALSE(r.result.ended_early) << accuracy;
    EXPECT_TRUE(r.result.certificate.holds()) << accuracy;
    EXPECT_LE(r.result.certificate.discretisation, accuracy);
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
  ASSERT_TRUE(first.result.converged && second.result.converged);
  EXPECT_GT(first.result.Fy, 15 * first.result.Fz);
  EXPECT_NEAR(second.result.Fy, first.result.Fy, 1e-6 * first.result.Fy);
  EXPECT_LT(second.result.outer_iterations, first.result.outer_iterations);
  EXPECT_LE(second.result.outer_iterations, 2);
}

} // namespace
