#include "bem_contact/sequence/plan/plan_grid.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/scene/contact_centre.hpp"
#include "tests/geometry/shapes.hpp"

#include <gtest/gtest.h>

namespace {

using namespace bem_contact;

ContactEstimate estimate_of(const WheelOnRail& pair, const Material& steel, double force) {
  return estimate_contact(slice_rail(pair, ContactLocus(pair)), contact_compliance(steel, steel),
                          {LoadKind::force, force});
}

TEST(Estimate, OfASphereIsNearHertz) {
  // Ball R 50 on a rail that is all but flat: Hertz for a sphere on a plane (Johnson 1985, eq. 4.22), E
  // 210000, nu 0.3.
  const Material steel{210000 / 2.6, 0.3};
  const WheelOnRail pair{shapes::rail_arc(1e5, 1e-4), shapes::wheel_arc(50, 0.5), {}, {}, 50};
  const ContactEstimate estimate = estimate_of(pair, steel, 1000);
  EXPECT_NEAR(estimate.approach, 0.0094540719, 0.1 * 0.0094540719);
  EXPECT_NEAR(estimate.force, 1000, 1);
}

TEST(GridPlan, CoversTheContactSymmetrically) {
  const Material steel{};
  const WheelOnRail pair = shapes::arcs(80, -300, 460, 0.2);
  const ContactEstimate estimate = estimate_of(pair, steel, 5e4);
  SceneFile::Grid grid;
  grid.dx = 0.5;
  grid.ds = 0.25;
  const GridPlan plan = plan_grid(estimate, grid, 0.1);
  EXPECT_LT(plan.s_from(), -1);
  EXPECT_GT(plan.s_to(), 1);
  EXPECT_NEAR(plan.s_from(), -plan.s_to(), 0.5);
  EXPECT_EQ(plan.columns % 2, 0);
  EXPECT_NEAR(std::remainder(plan.s(3) - 0.1, 0.25), 0, 1e-12);
  grid.rows = {-2, 3};
  const GridPlan wanted = plan_grid(estimate, grid, 0);
  EXPECT_NEAR(wanted.s_from(), -2, 0.125);
  EXPECT_NEAR(wanted.s_to(), 3, 0.125);
}

} // namespace
