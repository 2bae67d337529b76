#include "bem_contact/base/error.hpp"
#include "bem_contact/geometry/rigid_slip.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "tests/geometry/brute_force.hpp"
#include "tests/geometry/shapes.hpp"
#include "tests/geometry/with_own_locus.hpp"

#include <gtest/gtest.h>

#include <random>

namespace {

using namespace bem_contact;

const TabulatedProfile& rail_60e1() {
  static const TabulatedProfile rail(named_profile("60E1", ProfileKind::rail));
  return rail;
}
const TabulatedProfile& wheel_s1002() {
  static const TabulatedProfile wheel(named_profile("S1002", ProfileKind::wheel));
  return wheel;
}

WheelsetPosition rig(double roller_radius, double lateral, double yaw, double roll = 0) {
  WheelsetPosition position;
  position.roller_radius = roller_radius;
  position.lateral = lateral;
  position.yaw = yaw;
  position.roll = roll;
  position.rail_inclination = 0.025;
  return position;
}

std::vector<ContactRow> rows_around(const WheelOnRail& pair, double s) {
  std::vector<ContactRow> rows;
  for (int i = -3; i <= 3; ++i) {
    const CurvePoint p = pair.rail_at(s + 0.7 * i);
    rows.push_back({p.s, p.position, p.delta});
  }
  return rows;
}

/// The first touch of random rigs, tread and flange, is that of a search over both angles of the wheel above
/// the circles of the roller. It knows nothing of the locus.
TEST(Roller, TwentyRandomRigsTouchWhereBruteForceTouches) {
  BruteForce brute(rail_60e1(), wheel_s1002(), 0.1);
  std::mt19937 random(53);
  const auto uniform = [&](double a, double b) { return std::uniform_real_distribution(a, b)(random); };
  double worst = 0, farthest = 0;
  for (int i = 0; i < 20; ++i) {
    WheelsetPosition position =
        rig(uniform(200, 1500), uniform(-6, 8), uniform(-0.03, 0.03), uniform(-0.01, 0.01));
    position.side = i % 2 ? WheelSide::left : WheelSide::right;
    position.rail_lateral = uniform(-1, 1);
    position.rail_vertical = uniform(-2, 2);
    WheelOnRail pair = place(position, rail_60e1(), wheel_s1002());
    const auto minima = brute.search(position, pair, 0.5);
    ASSERT_FALSE(minima.empty());
    const double before = pair.wheel_pose.origin.z;
    const std::vector<TouchPoint> touch = lower_to_touch(pair);
    const double drop = pair.wheel_pose.origin.z - before;
    const double tolerance = BruteForce::tolerance(pair, touch.front().rail_s);
    worst = std::max(worst, std::abs(drop - minima.front().distance));
    EXPECT_NEAR(drop, minima.front().distance, tolerance) << "rig " << i;
    EXPECT_NEAR(touch.front().distance, 0, 1e-9);
    const Vector3 at = pair.roller->in_space(touch.front().x, touch.front().position);
    farthest = std::max(farthest, std::abs(at[0]));
    const bool alone = minima.size() == 1 || minima[1].distance > minima[0].distance + 1e-4;
    if (alone) {
      EXPECT_NEAR(at[0], minima.front().x, 0.05) << "rig " << i;
      EXPECT_NEAR(at[1], minima.front().y, 0.05) << "rig " << i;
    }
  }
  std::printf("20 rigs: worst difference %.1e mm, touch points up to %.2f mm beside the axle\n", worst,
              farthest);
  EXPECT_GT(farthest, 1) << "yaw moves them";
}

/// The end of each gap lies on the wheel: turned back by the roller's angle, yaw and roll it is on the
/// profile.
TEST(Roller, TheGapEndsOnTheWheel) {
  for (const double yaw : {-0.024, 0.01})
    for (const double lateral : {-3.0, 6.6}) {
      WheelOnRail pair = place(rig(400, lateral, yaw), rail_60e1(), wheel_s1002());
      const TouchPoint touch = lower_to_touch(pair).front();
      const std::vector<ContactRow> rows = rows_around(pair, touch.rail_s);
      const std::vector<double> x{touch.x - 9, touch.x, touch.x + 4};
      const std::vector<double> gap = undeformed_distance(pair, rows, x);
      const WheelFrame f = pair.wheel_frame();
      for (std::size_t is = 0; is < rows.size(); ++is)
        for (std::size_t ix = 0; ix < x.size(); ++ix) {
          const double h = gap[is * x.size() + ix], phi = x[ix] / (400 - rows[is].position.z);
          ASSERT_LT(h, 5);
          const Point2 end = rows[is].position - h * normal_of(rows[is].delta);
          const Vector3 p{(400 - end.z) * std::sin(phi) - f.centre[0], end.y - f.centre[1],
                          400 - (400 - end.z) * std::cos(phi) - f.centre[2]};
          const auto along = [&](const Vector3& e) { return p[0] * e[0] + p[1] * e[1] + p[2] * e[2]; };
          const Point2 q{along(f.axle), std::hypot(along(f.forward), along(f.down)) - pair.wheel_radius};
          const CurvePoint nearest = pair.wheel.nearest(q);
          EXPECT_NEAR(norm(nearest.position - q), 0, 1e-8);
        }
      const std::size_t middle = 3 * x.size() + 1;
      EXPECT_NEAR(gap[middle], 0, 1e-8);
      // The curvature along x that estimates use is that of both bodies.
      const std::vector<ContactRow> row{rows[3]};
      const std::vector<double> around =
          undeformed_distance(pair, row, std::vector<double>{touch.x - 1, touch.x + 1});
      const RowOnLocus on = rows_on_locus(ContactLocus(pair), row).front();
      EXPECT_NEAR(on.x, touch.x, 1e-3);
      EXPECT_NEAR(on.half, 0.5 * (around[0] + around[1]), 0.02 * on.half);
      if (lateral < 0) { // on the tread
        EXPECT_NEAR(on.half, 0.5 / 400 + 0.5 / 460, 0.05 * on.half);
      }
    }
}

/// Both bodies turn by a small angle, and what was one place in the reference frame has moved apart: the
/// slip, of a wheel that is yawed and rolled, from turned points alone.
TEST(Roller, TheRigidSlipIsThatOfTwoTurningBodies) {
  WheelOnRail pair = place(rig(300, 6.0, 0.02, 2e-3), rail_60e1(), wheel_s1002());
  const TouchPoint touch = lower_to_touch(pair).front();
  const ReferencePoint reference{touch.position, touch.rail_s, touch.delta, touch.x};
  Creepage creepage;
  creepage.rolling_radius = 458;
  creepage.roller_speed = 1 / 297.0;
  const std::vector<ContactRow> rows = rows_around(pair, touch.rail_s);
  const std::vector<double> x{touch.x - 5, touch.x, touch.x + 5};
  const RigidSlip slip = rigid_slip(pair, reference, creepage, rows, x);
  const WheelFrame f = pair.wheel_frame();
  // Rodrigues' formula about a unit vector through a point.
  const auto turned_about = [](const Vector3& axis, const Vector3& centre, double angle, const Vector3& p) {
    const Vector3 r{p[0] - centre[0], p[1] - centre[1], p[2] - centre[2]};
    const double along = axis[0] * r[0] + axis[1] * r[1] + axis[2] * r[2];
    const Vector3 cross{axis[1] * r[2] - axis[2] * r[1], axis[2] * r[0] - axis[0] * r[2],
                        axis[0] * r[1] - axis[1] * r[0]};
    Vector3 out;
    for (int i = 0; i < 3; ++i)
      out[i] = centre[i] + std::cos(angle) * r[i] + std::sin(angle) * cross[i] +
               (1 - std::cos(angle)) * along * axis[i];
    return out;
  };
  const double t = 1e-3; // of the rolled distance, mm
  const double roller_at_reference = 300 - touch.position.z;
  const double wheel_at_reference = radius_at(pair, touch.x, touch.position);
  const double mean = 0.5 * (wheel_at_reference / 458 + roller_at_reference / 297);
  EXPECT_NEAR(mean_surface_speed(pair, reference, creepage), mean, 1e-12);
  for (std::size_t is = 0; is < rows.size(); ++is)
    for (std::size_t ix = 0; ix < x.size(); ++ix) {
      const double d = 300 - rows[is].position.z, phi = x[ix] / d;
      const Vector3 p{d * std::sin(phi), rows[is].position.y, 300 - d * std::cos(phi)};
      Vector3 moved{};
      for (const double sign : {-1.0, 1.0}) {
        const Vector3 wheel = turned_about(f.axle, f.centre, -sign * t / 458, p);
        const Vector3 roller = turned_about({0, 1, 0}, {0, 0, 300}, sign * t / 297, p);
        for (int i = 0; i < 3; ++i)
          moved[i] += sign * (wheel[i] - roller[i]) / (2 * t * mean);
      }
      const double delta = rows[is].delta;
      const double along = std::cos(phi) * moved[0] + std::sin(phi) * moved[2];
      const double across = std::cos(delta) * moved[1] +
                            std::sin(delta) * (std::cos(phi) * moved[2] - std::sin(phi) * moved[0]);
      EXPECT_NEAR(slip.x[is * x.size() + ix], along, 1e-8);
      EXPECT_NEAR(slip.s[is * x.size() + ix], across, 1e-8);
    }
}

/// As the roller grows it becomes the track: what is left of the difference falls with its curvature.
TEST(Roller, ALargeOneIsTheTrack) {
  Creepage creepage;
  creepage.rolling_radius = 460;
  const auto solved = [&](double roller_radius) {
    WheelOnRail pair = place(rig(roller_radius, 5.5, 8e-3), rail_60e1(), wheel_s1002());
    const TouchPoint touch = lower_to_touch(pair).front();
    const std::vector<ContactRow> rows = rows_around(pair, 0);
    const std::vector<double> x{-6, 0, 6};
    const ReferencePoint reference{touch.position, touch.rail_s, touch.delta, touch.x};
    const RigidSlip slip = rigid_slip(pair, reference, creepage, rows, x);
    std::vector<double> out = undeformed_distance(pair, rows, x);
    for (const std::vector<double>& component : {slip.x, slip.s})
      for (const double w : component) // over the forward speed, as on a track
        out.push_back(w * mean_surface_speed(pair, reference, creepage));
    out.push_back(pair.wheel_pose.origin.z);
    return out;
  };
  const std::vector<double> track = solved(0);
  std::vector<double> differences;
  for (const double radius : {1e4, 1e6, 1e8}) {
    const std::vector<double> roller = solved(radius);
    double most = 0;
    for (std::size_t i = 0; i < track.size(); ++i)
      most = std::max(most, std::abs(roller[i] - track[i]));
    differences.push_back(most);
  }
  EXPECT_LT(differences[1], 2e-4); // of distances up to 1 mm: x^2 / 2e6, x up to 20 mm
  EXPECT_LT(differences[1], 0.02 * differences[0]);
  EXPECT_LT(differences[2], 0.02 * differences[1] + 2e-8);
}

TEST(Roller, ItsAxisIsBelowTheRail) {
  EXPECT_THROW(place(rig(20, 0, 0), rail_60e1(), wheel_s1002()), InputError);
}

} // namespace
