#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/movable_points.hpp"
#include "bem_contact/profile/profile_curve.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "tests/base/message.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace bem_contact {
namespace {

using std::numbers::pi;

/// Points of a circle of radius r about the origin, walked as an upper body over its lower part.
std::vector<Point2> arc_points(double r, double half_angle, int intervals) {
  std::vector<Point2> points;
  for (int i = 0; i <= intervals; ++i) {
    const double phi = half_angle * (2.0 * i / intervals - 1);
    points.push_back({-r * std::sin(phi), r * std::cos(phi)});
  }
  return points;
}

double spline_error(int intervals) {
  const ProfileCurve curve = ProfileCurve::through_points("arc", arc_points(10, 1, intervals));
  double worst = 0;
  for (double f = 0; f <= 1; f += 1e-3)
    worst = std::max(
        worst,
        std::abs(norm(curve.at(curve.s_begin() + f * (curve.s_end() - curve.s_begin())).position) - 10));
  return worst;
}

/// An upper body over a lower part with a corner: all points but one stay where they are, and corners stay.
TEST(MovablePoints, OnePointMovesAlongItsNormal) {
  std::vector<Point2> points = arc_points(10, 1, 20);
  for (const double y : {-9.5, -10.5, -11.5})
    points.push_back({y, points[20].z});
  const ProfileCurve curve = ProfileCurve::through_points("arc", points, std::vector<std::size_t>{20});
  const MovablePoints movable(curve);
  ASSERT_EQ(movable.points().size(), points.size());
  for (const std::size_t k : {0, 7, 20, 23}) {
    const ProfileCurve moved = movable.moved(k, 0.01);
    const std::vector<double> joints = moved.joints();
    ASSERT_EQ(joints.size(), points.size());
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const Point2 wanted = i == k ? points[i] + 0.01 * movable.outwards(k) : points[i];
      EXPECT_NEAR(norm(moved.at(joints[i]).position - wanted), 0, 1e-12) << k << " " << i;
    }
  }
  const Point2 out = movable.outwards(7), from = points[7]; // out of the body, which lies above the arc
  EXPECT_NEAR(dot(out, from) / 10, 1, 1e-4);
  EXPECT_NEAR(norm(movable.moved(7, 0).at(curve.joints()[10]).position - points[10]), 0, 1e-12);
  EXPECT_THROW(MovablePoints(standard_profile("60E1")), InputError);
}

TEST(ThroughPoints, converges_with_the_fourth_power_of_the_spacing) {
  const double coarse = spline_error(20), fine = spline_error(40);
  EXPECT_LT(fine, 1e-5);
  EXPECT_GT(std::log2(coarse / fine), 3.7);
}

TEST(ThroughPoints, an_arc_has_its_length_inclination_and_curvature) {
  const ProfileCurve curve = ProfileCurve::through_points("arc", arc_points(10, 1, 200));
  EXPECT_NEAR(curve.s_end() - curve.s_begin(), 20, 1e-7);
  EXPECT_NEAR(curve.s_begin(), -10, 1e-7); // s = 0 where the curve passes y = 0
  const CurvePoint lowest = curve.at(0);
  EXPECT_NEAR(lowest.position.y, 0, 1e-12);
  EXPECT_NEAR(lowest.delta, pi, 1e-7);
  EXPECT_NEAR(lowest.curvature, 0.1, 1e-5);
  EXPECT_NEAR(curve.at(5).delta, pi + 0.5, 1e-6);
}

TEST(ThroughPoints, three_points_make_a_parabola) {
  const std::vector<Point2> points{{-1, 0}, {0, -1}, {1, 0}};
  const ProfileCurve curve = ProfileCurve::through_points("parabola", points, 2.0);
  for (double s = curve.s_begin(); s < curve.s_end(); s += 0.1) {
    const Point2 p = curve.at(s).position;
    EXPECT_NEAR(p.z, p.y * p.y - 1, 1e-12);
  }
}

TEST(ThroughPoints, a_kink_stays_a_corner_and_a_coarse_arc_is_none) {
  std::vector<Point2> roof;
  for (int i = -10; i <= 10; ++i)
    roof.push_back({static_cast<double>(i), std::abs(static_cast<double>(i))});
  const ProfileCurve curve = ProfileCurve::through_points("roof", roof);
  EXPECT_NEAR(curve.at(-0.01).delta, -pi / 4, 1e-12);
  EXPECT_NEAR(curve.at(0.01).delta, pi / 4, 1e-12);
  EXPECT_NEAR(curve.s_end(), 10 * std::sqrt(2.0), 1e-12);

  const ProfileCurve arc = ProfileCurve::through_points("coarse arc", arc_points(3, 1.4, 7)); // turns of 0.4
  for (double s = arc.s_begin() + 0.05; s + 0.1 < arc.s_end(); s += 0.05)
    EXPECT_LT(std::abs(arc.at(s + 0.05).delta - arc.at(s).delta), 0.03) << s;
}

TEST(ThroughPoints, refuses_what_is_no_curve) {
  const auto refuse = [](std::vector<Point2> points, const char* message) {
    EXPECT_THAT(message_of([&] { ProfileCurve::through_points("bad", points); }),
                testing::HasSubstr(message));
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refuse({}, "Profile 'bad' has 0 points (a curve needs at least 3)");
  refuse({{0, 0}}, "has 1 point (");
  refuse({{0, 0}, {1, 0}}, "has 2 points");
  refuse({{0, 0}, {nan, 0}, {2, 0}}, "Point 2 of profile 'bad' is not a number");
  refuse({{0, 0}, {1, 1}, {1, 1}, {2, 0}}, "Points 2 and 3 of profile 'bad' coincide");
}

class Curves : public testing::TestWithParam<std::string> {
protected:
  ProfileCurve curve = GetParam() == "spline" ? ProfileCurve::through_points("spline", arc_points(9, 1.2, 60))
                                              : standard_profile(GetParam());
  double at_fraction(double f) const { return curve.s_begin() + f * (curve.s_end() - curve.s_begin()); }
};

TEST_P(Curves, s_is_the_arc_length) {
  // Chords of a fine division miss kappa^2 h^3/24 each.
  constexpr int steps = 20000;
  double length = 0;
  Point2 last = curve.at(curve.s_begin()).position;
  for (int i = 1; i <= steps; ++i) {
    const Point2 p = curve.at(at_fraction(static_cast<double>(i) / steps)).position;
    length += norm(p - last);
    last = p;
  }
  EXPECT_NEAR(length, curve.s_end() - curve.s_begin(), 1e-6);
}

TEST_P(Curves, the_tangent_is_the_derivative_of_the_position_and_curvature_that_of_delta) {
  constexpr double h = 1e-4;
  int compared = 0;
  for (double f = 0.0031; f < 1; f += 0.0173) {
    const double s = at_fraction(f);
    const CurvePoint a = curve.at(s - h), b = curve.at(s), c = curve.at(s + h);
    const Point2 derivative = (1 / (2 * h)) * (c.position - a.position);
    if (std::abs(a.curvature - c.curvature) > 1e-3)
      continue; // a joint of two arcs lies between
    EXPECT_NEAR(derivative.y, std::cos(b.delta), 1e-8) << s;
    EXPECT_NEAR(derivative.z, std::sin(b.delta), 1e-8) << s;
    EXPECT_NEAR((c.delta - a.delta) / (2 * h), b.curvature, 1e-5) << s;
    ++compared;
  }
  EXPECT_GT(compared, 50);
}

TEST_P(Curves, nearest_inverts_an_offset_along_the_normal) {
  for (double f = 0.001; f < 1; f += 0.00917)
    for (const double offset : {-1.0, -1e-3, 0.0, 1e-3, 0.5}) {
      const CurvePoint p = curve.at(at_fraction(f));
      const CurvePoint q = curve.nearest(p.position + offset * normal_of(p.delta));
      // At a joint with a small jump of slope the foot point may lie that jump times the offset aside.
      EXPECT_NEAR(q.s, p.s, 1e-10 + 1e-3 * std::abs(offset)) << "offset " << offset;
      EXPECT_NEAR(norm(q.position - p.position), 0, 1e-10 + 1e-3 * std::abs(offset));
    }
}

TEST_P(Curves, nearest_is_global) {
  constexpr int samples = 4000;
  for (double y = -90; y <= 90; y += 12.7)
    for (double z = -40; z <= 60; z += 11.3) {
      const Point2 p{y, z};
      double least = std::numeric_limits<double>::infinity();
      for (int i = 0; i <= samples; ++i)
        least = std::min(least, norm(curve.at(at_fraction(static_cast<double>(i) / samples)).position - p));
      EXPECT_LE(norm(curve.nearest(p).position - p), least + 1e-12) << y << " " << z;
    }
}

TEST_P(Curves, ends_are_reached_and_not_passed) {
  EXPECT_NO_THROW(curve.at(curve.s_begin() - 5e-10));
  EXPECT_NO_THROW(curve.at(curve.s_end() + 5e-10));
  EXPECT_THROW(curve.at(curve.s_begin() - 1e-6), InputError);
  EXPECT_THROW(curve.at(curve.s_end() + 1e-6), InputError);
  EXPECT_THROW(curve.at(std::numeric_limits<double>::quiet_NaN()), InputError);
  EXPECT_THROW(curve.nearest({std::numeric_limits<double>::infinity(), 0}), InputError);
}

TEST_P(Curves, the_digest_tells_geometry_not_name) {
  for (const StandardEntry& other : standard_entries())
    EXPECT_EQ(curve.digest() == standard_profile(other.name).digest(), other.name == GetParam())
        << other.name;
}

INSTANTIATE_TEST_SUITE_P(All, Curves, testing::Values("60E1", "60E2", "54E1", "46E3", "S1002", "spline"),
                         [](const auto& p) { return p.param; });

TEST(Digest, changes_with_a_micrometre_and_not_with_the_name) {
  std::vector<Point2> points = arc_points(9, 1.2, 60);
  const auto digest = ProfileCurve::through_points("a", points).digest();
  EXPECT_EQ(ProfileCurve::through_points("b", points).digest(), digest);
  points[30].z += 1e-3;
  EXPECT_NE(ProfileCurve::through_points("a", points).digest(), digest);
}

} // namespace
} // namespace bem_contact
