#include "bem_contact/geometry/rigid_slip.hpp"

#include "bem_contact/geometry/contact_search.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "tests/geometry/shapes.hpp"

#include <gtest/gtest.h>

namespace {

using namespace bem_contact;

struct Rolling {
  WheelOnRail pair;
  std::vector<ContactRow> rows;
  std::vector<double> x; // 21 columns, the middle one at the deepest point
  RigidSlip slip;
  ReferencePoint reference;
  double radius = 0;
};

/// S1002 on 60E1 with rows of ds about the deepest point; row 10 is the deepest point itself.
Rolling rolling(double lateral, double roll, const Creepage& creepage, double ds = 0.05, double yaw = 0) {
  WheelsetPosition position;
  position.yaw = yaw;
  position.lateral = lateral;
  position.roll = roll;
  Rolling r{
      place(position, named_profile("60E1", ProfileKind::rail), named_profile("S1002", ProfileKind::wheel)),
      {},
      {},
      {},
      {},
      0};
  const TouchPoint touch = lower_to_touch(r.pair).front();
  r.reference = {touch.position, touch.rail_s, touch.delta, touch.x};
  r.radius = dot(touch.position - r.pair.wheel_pose.to_track({0, -r.pair.wheel_radius}), normal_of(roll));
  for (int i = -10; i <= 10; ++i) {
    const CurvePoint p = r.pair.rail_at(touch.rail_s + i * ds);
    r.rows.push_back({p.s, p.position, p.delta});
    r.x.push_back(touch.x + 0.1 * i);
  }
  r.slip = rigid_slip(r.pair, r.reference, creepage, r.rows, r.x);
  return r;
}

double slip_x(const Rolling& r, int ix, int is) {
  return r.slip.x[is * r.x.size() + ix];
}
double slip_s(const Rolling& r, int ix, int is) {
  return r.slip.s[is * r.x.size() + ix];
}

TEST(RigidSlip, AtTheReferencePointIsTheCreepage) {
  for (const double lateral : {0.0, 6.3, 7.2}) {
    const Rolling r = rolling(lateral, 0, {1e-3, -2e-3, 0.4e-3});
    EXPECT_NEAR(slip_x(r, 10, 10), 1e-3, 1e-12);
    EXPECT_NEAR(slip_s(r, 10, 10), -2e-3, 1e-12);
  }
}

TEST(RigidSlip, AGivenRollingRadiusHoldsWhereverTheBodiesTouch) {
  // 1 - r / R_roll: a wheel that turns as if it rolled on 460 mm slides back where its radius is larger.
  for (const double lateral : {0.0, 6.3, 7.2}) {
    const Rolling r = rolling(lateral, 0, {0, 0, 0, 460.0});
    EXPECT_NEAR(slip_x(r, 10, 10), 1 - r.radius / 460, 1e-12);
  }
  EXPECT_LT(slip_x(rolling(7.2, 0, {0, 0, 0, 460.0}), 10, 10), -0.01);
}

TEST(RigidSlip, GeometricSpinIsSineOfInclinationOverRadius) {
  // Classical check: w_x = -phi s, w_s = phi x with phi = sin(delta) / R: negative at the gauge corner.
  const Rolling r = rolling(7.2, 0, {});
  ASSERT_LT(r.reference.delta, -0.5);
  const double phi = std::sin(r.reference.delta) / r.radius;
  const double across = (slip_x(r, 10, 11) - slip_x(r, 10, 9)) / (r.rows[11].s - r.rows[9].s);
  const double along = (slip_s(r, 11, 10) - slip_s(r, 9, 10)) / 0.2;
  EXPECT_NEAR(-across, phi, 1e-3 * std::abs(phi));
  EXPECT_NEAR(along, phi, 1e-9);
  EXPECT_LT(phi, 0);
}

TEST(RigidSlip, SpinOfTheSceneIsAddedToTheGeometry) {
  const Rolling r = rolling(7.2, 0, {0, 0, 2e-4}), zero = rolling(7.2, 0, {});
  EXPECT_NEAR(slip_s(r, 20, 10) - slip_s(zero, 20, 10), 2e-4, 1e-12); // x = 1 mm
  const double s = r.rows[12].s - r.rows[10].s;
  EXPECT_NEAR(slip_x(r, 10, 12) - slip_x(zero, 10, 12), -2e-4 * s, 1e-6 * s);
}

TEST(RigidSlip, ARolledAxleTurnsTheSpin) {
  // With the axle inclined by roll the spin is sin(delta - roll) / R.
  const double roll = 0.02;
  const Rolling r = rolling(0, roll, {});
  const double along = (slip_s(r, 11, 10) - slip_s(r, 9, 10)) / 0.2;
  EXPECT_NEAR(along, std::sin(r.reference.delta - roll) / r.radius, 1e-9);
}

TEST(RigidSlip, AYawedWheelSlidesToTheLeft) {
  // Its front turned to the right, it would roll there: going straight on it slides to the left, by tan(yaw)
  // times the cosine of the inclination, plus the spin from the wheel's centre to the reference point.
  for (const double lateral : {0.0, 7.5}) {
    const double yaw = 0.01;
    const Rolling r = rolling(lateral, 0, {}, 0.05, yaw);
    const WheelFrame frame = r.pair.wheel_frame();
    const double ahead = (r.reference.x - frame.centre[0]) * std::cos(yaw) +
                         (r.reference.position.y - frame.centre[1]) * std::sin(yaw);
    EXPECT_NEAR(slip_x(r, 10, 10), 0, 1e-12);
    EXPECT_NEAR(slip_s(r, 10, 10),
                -std::tan(yaw) * std::cos(r.reference.delta) +
                    std::sin(r.reference.delta) * ahead / (r.radius * std::cos(yaw)),
                1e-12)
        << lateral;
    EXPECT_LT(slip_s(r, 10, 10), -0.009);
  }
}

TEST(RigidSlip, RatesMoveTheWheelAsItsPlacementDoes) {
  // A point fixed to the wheelset, that does not turn about its axle, at two instants; central differences.
  const auto at = [](double t, double lateral, double roll, double yaw) {
    WheelsetPosition position;
    position.lateral = 6.3 + lateral * t;
    position.roll = 0.01 + roll * t;
    position.yaw = 0.02 + yaw * t;
    return place(position, named_profile("60E1", ProfileKind::rail),
                 named_profile("S1002", ProfileKind::wheel));
  };
  constexpr double step = 1e-4, vertical = 3e-3;
  struct Rates {
    double lateral, roll, yaw;
  };
  for (const Rates& rates :
       {Rates{2e-3, 0, 0}, Rates{0, 3e-6, 0}, Rates{0, 0, -5e-6}, Rates{1e-3, 2e-6, 4e-6}}) {
    const WheelOnRail now = at(0, 0, 0, 0);
    const WheelFrame before = at(-step, rates.lateral, rates.roll, rates.yaw).wheel_frame(),
                     frame = now.wheel_frame(),
                     after = at(step, rates.lateral, rates.roll, rates.yaw).wheel_frame();
    const std::vector<ContactRow> rows{{0, {720, 3}, -0.6}};
    const std::vector<double> columns{4.0};
    const Vector3 point{4.0, 720, 3};
    const auto place_of = [](const WheelFrame& f, const Vector3& own, int k) {
      return f.centre[k] + own[0] * f.forward[k] + own[1] * f.axle[k] + own[2] * f.down[k];
    };
    Vector3 own{};
    for (int k = 0; k < 3; ++k) {
      const double r = point[k] - frame.centre[k];
      own[0] += r * frame.forward[k], own[1] += r * frame.axle[k], own[2] += r * frame.down[k];
    }
    Vector3 velocity{};
    for (int k = 0; k < 3; ++k)
      velocity[k] = (place_of(after, own, k) - place_of(before, own, k)) / (2 * step);
    velocity[2] += vertical;

    const ReferencePoint reference{{718, 2}, 0, -0.5, 1.0};
    Creepage creepage{0, 0, 0, 460};
    const RigidSlip still = rigid_slip(now, reference, creepage, rows, columns);
    const double x = still.x[0], s = still.s[0];
    creepage.velocity = {0, rates.lateral, vertical};
    creepage.roll = rates.roll;
    creepage.yaw = rates.yaw;
    const RigidSlip moving = rigid_slip(now, reference, creepage, rows, columns);
    EXPECT_NEAR(moving.x[0] - x, velocity[0], 1e-9);
    EXPECT_NEAR(moving.s[0] - s, dot(Point2{velocity[1], velocity[2]}, tangent_of(-0.6)), 1e-9);
    EXPECT_GT(std::hypot(moving.x[0] - x, moving.s[0] - s), 1e-5);
  }
}

/// A wheel of a flexible wheelset: its deviation, made by turns about axes one after the other, and its rates
/// as the difference of two such placements.
TEST(RigidSlip, RatesOfAFlexibleWheelMoveItAsItsDeviationDoes) {
  WheelsetPosition position;
  position.lateral = 3;
  position.roll = 4e-3;
  position.yaw = 9e-3;
  position.deviation = {0.7, -0.4, 2e-3, -5e-3};
  const auto placed = [](const WheelsetPosition& p) {
    return place(p, named_profile("60E1", ProfileKind::rail), named_profile("S1002", ProfileKind::wheel));
  };
  const WheelOnRail pair = placed(position);
  const auto turned_y_z = [](double a, Vector3 v) {
    return Vector3{v[0], std::cos(a) * v[1] - std::sin(a) * v[2], std::sin(a) * v[1] + std::cos(a) * v[2]};
  };
  const auto turned_x_y = [](double a, Vector3 v) {
    return Vector3{std::cos(a) * v[0] - std::sin(a) * v[1], std::sin(a) * v[0] + std::cos(a) * v[1], v[2]};
  };
  // Where a point of the wheel is, given from its centre: own roll, own yaw, its place on the rolled axle
  // with the displacement, yaw of the wheelset.
  const auto in_space = [&](const WheelsetPosition& p, Vector3 of_wheel) {
    const WheelDeviation& d = p.deviation;
    Vector3 v = turned_x_y(d.yaw, turned_y_z(p.roll + d.roll, of_wheel));
    const Vector3 on_axle = turned_y_z(p.roll, {0, 750, 0});
    v = {v[0], v[1] + on_axle[1] + d.lateral, v[2] + on_axle[2] + d.vertical};
    v = turned_x_y(p.yaw, v);
    return Vector3{v[0], v[1] + p.lateral, v[2] - 460};
  };
  const WheelFrame frame = pair.wheel_frame();
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(frame.centre[i], in_space(position, {0, 0, 0})[i], 1e-10);
    EXPECT_NEAR(frame.axle[i], in_space(position, {0, 1, 0})[i] - frame.centre[i], 1e-10);
    EXPECT_NEAR(frame.down[i], in_space(position, {0, 0, 1})[i] - frame.centre[i], 1e-10);
  }
  const Vector3 of_wheel{3, -20, 462};
  const Vector3 p = in_space(position, of_wheel);
  const std::vector<ContactRow> row{{0, {p[1], p[2]}, -0.3}};
  const ReferencePoint reference{{p[1], p[2]}, 0, -0.3, p[0]};
  Creepage still, moving;
  still.rolling_radius = moving.rolling_radius = 460;
  moving.wheel_velocity = {0, 2e-3, 1e-3};
  moving.wheel_rates = {3e-6, 0, -2e-6};
  const double t = 1e-2;
  WheelsetPosition after = position, before = position;
  for (const auto& [sign, state] : {std::pair(1.0, &after), std::pair(-1.0, &before)}) {
    state->deviation.lateral += sign * t * 2e-3;
    state->deviation.vertical += sign * t * 1e-3;
    state->deviation.roll += sign * t * 3e-6;
    state->deviation.yaw += sign * t * -2e-6;
  }
  const Vector3 there = in_space(after, of_wheel), here = in_space(before, of_wheel);
  const std::vector<double> x{p[0]};
  const RigidSlip a = rigid_slip(pair, reference, still, row, x),
                  b = rigid_slip(pair, reference, moving, row, x);
  EXPECT_NEAR(b.x[0] - a.x[0], (there[0] - here[0]) / (2 * t), 1e-5 * 2e-3);
  EXPECT_NEAR(b.s[0] - a.s[0],
              (std::cos(-0.3) * (there[1] - here[1]) + std::sin(-0.3) * (there[2] - here[2])) / (2 * t),
              1e-5 * 2e-3);
  moving.wheel_velocity = {1e-3, 0, 0};
  moving.wheel_rates = {0, 1e-3 / 460, 0}; // rolls off what it moves forwards
  EXPECT_NEAR(rigid_slip(pair, reference, moving, row, x).x[0] - a.x[0], 0, 1e-5);
}

TEST(RigidSlip, OfALeftWheelIsTheMirrorImage) {
  // The same motion seen in a mirror: the yaw that pushes the right wheel's flange pulls the left one's.
  const auto at = [](WheelSide side, double yaw) {
    WheelsetPosition position;
    position.side = side;
    position.yaw = yaw;
    WheelOnRail pair =
        place(position, named_profile("60E1", ProfileKind::rail), named_profile("S1002", ProfileKind::wheel));
    const TouchPoint touch = lower_to_touch(pair).front();
    const std::vector<ContactRow> rows{{touch.rail_s, touch.position, touch.delta}};
    const RigidSlip slip = rigid_slip(pair, {touch.position, touch.rail_s, touch.delta, touch.x},
                                      {0, 0, 0, 460}, rows, std::vector<double>{touch.x});
    return std::pair(slip.x[0], slip.s[0]);
  };
  EXPECT_EQ(at(WheelSide::left, -0.01), at(WheelSide::right, 0.01));
  // Positive: towards its own side. Both wheels of one wheelset slide to the track's left.
  EXPECT_LT(at(WheelSide::right, 0.01).second, 0);
  EXPECT_GT(at(WheelSide::left, 0.01).second, 0);
}

TEST(RigidSlip, OfAPatchIsThatOfAPlane) {
  const std::vector<ContactRow> rows{{-2, {}, 0}, {5, {}, 0}};
  const RigidSlip slip = planar_slip({0.1, 0.2, 0.01}, rows, std::vector<double>{3, 4});
  EXPECT_DOUBLE_EQ(slip.x[0], 0.12);
  EXPECT_DOUBLE_EQ(slip.x[2], 0.05);
  EXPECT_DOUBLE_EQ(slip.s[0], 0.23);
  EXPECT_DOUBLE_EQ(slip.s[3], 0.24);
}

} // namespace
