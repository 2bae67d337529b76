#include "bem_contact/geometry/undeformed_distance.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/geometry/contact_search.hpp"
#include "bem_contact/geometry/rail_rows.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "tests/geometry/shapes.hpp"
#include "tests/geometry/with_own_locus.hpp"

#include <gtest/gtest.h>

namespace {

using namespace bem_contact;

std::vector<ContactRow> rows_of(const WheelOnRail& pair, double from, double to, double ds) {
  std::vector<ContactRow> rows;
  for (double s = from; s <= to + 1e-9; s += ds) {
    const CurvePoint p = pair.rail_at(s);
    rows.push_back({p.s, p.position, p.delta});
  }
  return rows;
}

/// Distance along the direction -n from p to the sphere about c.
double distance_to_sphere(double x, Point2 p, double delta, Point2 c, double radius) {
  const Point2 d = p - c;
  const double across = dot(d, normal_of(delta));
  return across - std::sqrt(across * across - dot(d, d) - x * x + radius * radius);
}

TEST(UndeformedDistance, OfASphericalWheelIsThatOfTheSphere) {
  // A wheel whose profile is an arc of its own radius is a ball about (0, 0, -20).
  const WheelOnRail pair = shapes::arcs(80, 20, 20);
  const std::vector<ContactRow> rows = rows_of(pair, -8, 8, 0.8);
  const std::vector<double> x{-3, -1, 0, 0.5, 6};
  const std::vector<double> gap = undeformed_distance(pair, rows, x);
  for (std::size_t is = 0; is < rows.size(); ++is)
    for (std::size_t ix = 0; ix < x.size(); ++ix)
      EXPECT_NEAR(gap[is * x.size() + ix],
                  distance_to_sphere(x[ix], rows[is].position, rows[is].delta, {0, -20}, 20), 2e-7)
          << rows[is].s << " " << x[ix];
}

TEST(UndeformedDistance, OfARolledSphereIsTheSame) {
  WheelOnRail pair = shapes::arcs(80, 20, 20);
  // Rolled about the ball's centre: the surface stays where it was.
  pair.wheel_pose.angle = 0.3;
  pair.wheel_pose.origin = {-20 * std::sin(0.3), -20 + 20 * std::cos(0.3)};
  const std::vector<ContactRow> rows = rows_of(pair, -6, 6, 1.5);
  const std::vector<double> x{0, 4};
  const std::vector<double> gap = undeformed_distance(pair, rows, x);
  for (std::size_t is = 0; is < rows.size(); ++is)
    for (std::size_t ix = 0; ix < x.size(); ++ix)
      EXPECT_NEAR(gap[is * 2 + ix],
                  distance_to_sphere(x[ix], rows[is].position, rows[is].delta, {0, -20}, 20), 2e-7);
}

TEST(UndeformedDistance, AlongXHasTheCurvatureOfTheWheel) {
  // Cylindrical tread on the top of the rail: h = R - sqrt(R^2 - x^2), to rounding, not x^2 / 2R.
  const WheelOnRail pair = shapes::arcs(80, 1000, 460, 0.05);
  const std::vector<ContactRow> rows = rows_of(pair, 0, 0, 1);
  const std::vector<double> x{-10, -5, 0, 5, 20};
  const std::vector<double> gap = undeformed_distance(pair, rows, x);
  for (std::size_t ix = 0; ix < x.size(); ++ix)
    EXPECT_NEAR(gap[ix], 460 - std::sqrt(460.0 * 460.0 - x[ix] * x[ix]), 1e-9);
}

TEST(UndeformedDistance, ConformalArcsAreTheirDifferenceOfRadii) {
  // Wheel groove R 10.2 on a rail corner R 10 that touch at s = 0: far from it the gap is
  // exactly the circle about (0, 10.2) seen from the circle about (0, 10).
  const WheelOnRail pair = shapes::arcs(10, -10.2, 460);
  const std::vector<ContactRow> rows = rows_of(pair, -8, 8, 1);
  const std::vector<double> gap = undeformed_distance(pair, rows, std::vector<double>{0.0});
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double t = rows[i].s / 10;
    const double exact = std::sqrt(10.2 * 10.2 - std::pow(0.2 * std::sin(t), 2)) - 10 - 0.2 * std::cos(t);
    EXPECT_NEAR(gap[i], exact, 2e-7) << rows[i].s;
  }
}

TEST(UndeformedDistance, OfAYawedAndRolledWheelEndsOnItsSurface) {
  // The point that far out along the normal, turned back by yaw and roll, lies on the profile at its radius,
  // and no point before it does.
  for (const double lateral : {-3.0, 6.6, 8.0})
    for (const double yaw : {-0.024, 0.01}) {
      WheelsetPosition position;
      position.lateral = lateral, position.yaw = yaw, position.roll = 0.005;
      WheelOnRail pair = place(position, named_profile("60E1", ProfileKind::rail),
                               named_profile("S1002", ProfileKind::wheel));
      const double before = pair.wheel_pose.origin.z;
      const TouchPoint touch = lower_to_touch(pair).front();
      const double height = -460 + pair.wheel_pose.origin.z - before; // of the wheelset's centre
      const auto above_profile = [&](double x, Point2 p) {
        const double across = (p.y - lateral) * std::cos(yaw) - x * std::sin(yaw);
        const double forward = x * std::cos(yaw) + (p.y - lateral) * std::sin(yaw);
        const double axial = across * std::cos(0.005) + (p.z - height) * std::sin(0.005);
        const double down = -across * std::sin(0.005) + (p.z - height) * std::cos(0.005);
        const Point2 q{axial - 750, std::hypot(forward, down) - 460};
        const CurvePoint nearest = pair.wheel.nearest(q);
        return dot(nearest.position - q, normal_of(nearest.delta)); // < 0: inside the wheel
      };
      const std::vector<ContactRow> rows = rows_of(pair, touch.rail_s - 6, touch.rail_s + 6, 1);
      const std::vector<double> x{touch.x - 15, touch.x - 4, touch.x, touch.x + 0.3, touch.x + 9};
      const std::vector<double> gap = undeformed_distance(pair, rows, x);
      for (std::size_t is = 0; is < rows.size(); ++is)
        for (std::size_t ix = 0; ix < x.size(); ++ix) {
          const double h = gap[is * x.size() + ix];
          if (h >= excluded_gap)
            continue;
          const auto at = [&](double t) { return rows[is].position - t * normal_of(rows[is].delta); };
          EXPECT_NEAR(above_profile(x[ix], at(h)), 0, 1e-8);
          for (double t = h - 0.01; t > -2; t -= 0.1)
            EXPECT_GT(above_profile(x[ix], at(t)), 0) << t << " before " << h;
        }
      // At the touch point it is zero and rises on all sides.
      const CurvePoint p = pair.rail_at(touch.rail_s);
      const std::vector<ContactRow> row{{p.s, p.position, p.delta}};
      const std::vector<double> around =
          undeformed_distance(pair, row, std::vector<double>{touch.x, touch.x - 1, touch.x + 1});
      EXPECT_NEAR(around[0], 0, 1e-8);
      EXPECT_GT(around[1], 2e-4);
      EXPECT_NEAR(around[1], around[2], 0.1 * around[1]);
      // The curvature that the estimate uses.
      const RowOnLocus on = rows_on_locus(ContactLocus(pair), row).front();
      EXPECT_NEAR(on.x, touch.x, 1e-3);
      EXPECT_NEAR(on.half, 0.5 * (around[1] + around[2]), 0.05 * on.half);
    }
}

TEST(UndeformedDistance, IsLargeWhereTheNormalMissesTheWheel) {
  const WheelOnRail pair = shapes::arcs(80, 20, 20, 0.5); // the ball spans y = +-9.6
  const std::vector<ContactRow> rows = rows_of(pair, -35, 35, 70);
  for (const double h : undeformed_distance(pair, rows, std::vector<double>{0, 50}))
    EXPECT_EQ(h, excluded_gap);
}

TEST(WheelStations, RunAgainstTheRail) {
  const WheelOnRail pair = shapes::arcs(10, -10.2, 460);
  const std::vector<ContactRow> rows = rows_of(pair, -5, 5, 0.5);
  const std::vector<double> s = wheel_stations(ContactLocus(pair), rows);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    // The nearest point lies on the ray from the groove's centre (0, 10.2) through the rail's point.
    const Point2 d = rows[i].position - Point2{0, 10.2};
    EXPECT_NEAR(s[i], -10.2 * std::atan2(d.y, -d.z), 1e-5);
  }
}

TEST(RailRows, BeyondTheProfileAreRefused) {
  const WheelOnRail pair = shapes::arcs(80, 20, 460, 0.1);
  EXPECT_THROW(rail_rows(pair, std::vector<double>{-50, 0, 49}, 0.5), InputError);
}

} // namespace
