#include "bem_contact/base/error.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "tests/hard_cases/hard_case.hpp"

/// A patch that touches the edge of the potential contact: it grows and is solved again.
namespace bem_contact {
namespace {

SceneFile wheel_on_rail() {
  SceneFile scene;
  scene.rail.profile = "60E1";
  scene.wheel.profile = "S1002";
  scene.rail.material = scene.wheel.material = scenes::steel;
  scene.position.lateral = 0;
  scene.load.force = 80000;
  scene.motion.xi = 5e-4;
  scene.grid.dx = 0.8;
  scene.grid.ds = 0.8;
  scene.solver.model = Model::halfspace;
  return scene;
}

TEST(HardCases, EdgeOfTheGrid) {
  const SceneResult free = Sequence().solve(wheel_on_rail());
  SceneFile tight = wheel_on_rail();
  tight.grid.mx = 6;
  tight.grid.rows = {free.motion.reference.s - 1.5, free.motion.reference.s + 1};
  const SceneResult grown = Sequence().solve(tight);
  hard::print_line("edge of the potential contact",
                   "6 x 4 elements asked for: the grid grows until the contact lies inside", grown.result);
  EXPECT_TRUE(grown.result.certified());
  EXPECT_FALSE(grown.result.trust.touches_border);
  EXPECT_THAT(grown.warnings.texts(), testing::Contains(testing::HasSubstr("it grew to")));
  EXPECT_GT(grown.problem.grid.mx, 6);
  EXPECT_NEAR(grown.result.totals.approach, free.result.totals.approach, 2e-2 * free.result.totals.approach);
  EXPECT_NEAR(grown.result.totals.Fx, free.result.totals.Fx, 2e-2 * std::abs(free.result.totals.Fx));
}

/// A force that no head of a rail can carry is refused after a bounded number of growths.
TEST(HardCases, NoGridIsLargeEnough) {
  SceneFile scene = wheel_on_rail();
  scene.load.force = 1e8;
  scene.grid.dx = scene.grid.ds = 4;
  try {
    const SceneResult result = Sequence().solve(scene);
    hard::print_line("1e8 N on a rail", "the patch leaves the head", result.result);
    EXPECT_TRUE(result.result.certified());
    EXPECT_FALSE(result.result.trust.touches_border);
  } catch (const Error& error) {
    hard::print_refusal("1e8 N on a rail", "the patch leaves the head", error.what());
    EXPECT_THAT(error.what(), testing::HasSubstr("("));
  }
}

} // namespace
} // namespace bem_contact
