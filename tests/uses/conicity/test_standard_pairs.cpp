#include "bem_contact/profile/standard_profiles.hpp"
#include "bem_contact/uses/conicity/wheelset_conicity.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <gmock/gmock.h>
#include <limits>

/// Conicity of each standard against a search that knows neither touch points nor the closed integral: all
/// points of the wheel over the rail as a height, and Klingel's equation integrated step by step.
namespace bem_contact {
namespace {

constexpr double fine = 0.04; // mm: of points

/// Points over rising y, and their values between.
struct Curve {
  std::vector<double> y, z;
  double at(double where) const {
    const auto k = std::ranges::upper_bound(y, where) - y.begin();
    if (k == 0 || k == static_cast<std::ptrdiff_t>(y.size()))
      return std::numeric_limits<double>::infinity();
    return z[k - 1] + (z[k] - z[k - 1]) * (where - y[k - 1]) / (y[k] - y[k - 1]);
  }
};

/// The rail as it is seen from above: where it overhangs the upper part counts.
Curve rail_from_above(const ProfileCurve& rail, const Pose& pose) {
  Curve out;
  std::vector<Point2> points;
  for (double s = rail.s_begin(); s <= rail.s_end(); s += fine)
    points.push_back(pose.to_track(rail.at(s).position));
  const std::size_t top = std::ranges::min_element(points, {}, &Point2::z) - points.begin();
  std::vector<Point2> seen{points[top]};
  for (std::size_t k = top; k-- > 0;)
    if (points[k].y < seen.back().y)
      seen.push_back(points[k]);
  std::ranges::reverse(seen);
  for (std::size_t k = top + 1; k < points.size(); ++k)
    if (points[k].y > seen.back().y)
      seen.push_back(points[k]);
  for (const Point2 p : seen)
    out.y.push_back(p.y), out.z.push_back(p.z);
  return out;
}

/// z of the wheel's profile where it touches, its tape circle at y = 750 + lateral.
double touch_height(const std::vector<Point2>& wheel, const Curve& rail, double lateral) {
  std::vector<double> gap;
  for (const Point2 p : wheel)
    gap.push_back(rail.at(750 + lateral + p.y) - p.z);
  const std::size_t k = std::ranges::min_element(gap) - gap.begin();
  return wheel[k].z;
}

/// tan gamma of a motion from -amplitude to amplitude of an antisymmetric function, given from 0 on.
double klingel(const std::vector<double>& difference, double step, double amplitude) {
  const double er = 1500.0 * 460;
  const auto at = [&](double y) {
    const double k = std::abs(y) / step;
    const auto i = std::min(static_cast<std::size_t>(k), difference.size() - 2);
    return std::copysign(difference[i] + (difference[i + 1] - difference[i]) * (k - static_cast<double>(i)),
                         y);
  };
  // Velocity and position are half a step apart (leapfrog).
  double y = amplitude, x = 0;
  const double h = 0.25; // mm along the track
  double v = -0.5 * h * at(y) / er;
  while (y > 0) {
    const double before = y;
    y += h * v;
    v -= h * at(y) / er;
    x += y > 0 ? h : h * before / (before - y);
  }
  const double k = std::acos(0.0) / x; // a quarter of a wave
  return 0.5 * k * k * er;
}

TEST(StandardPairs, HaveTheConicityOfABruteForceSearch) {
  int compared = 0;
  for (const StandardEntry& entry : standard_entries()) {
    const bool is_rail = entry.kind == ProfileKind::rail;
    const std::string rail_name = is_rail ? entry.name : "60E1", wheel_name = is_rail ? "S1002" : entry.name;
    const TabulatedProfile rail = standard_profile(rail_name), wheel = standard_profile(wheel_name);
    const double inclination = is_rail && entry.part == StandardEntry::Part::curve ? 0 : 0.025;
    const WheelsetOnTrack pair{.right_rail = rail,
                               .right_wheel = wheel,
                               .left_rail = rail,
                               .left_wheel = wheel,
                               .position = {.rail_inclination = inclination}};
    const WheelsetConicity found = wheelset_conicity(pair, {.largest = 4, .step = 1});

    const Curve height = rail_from_above(rail.curve(), place(pair.position, rail, wheel).rail_pose);
    std::vector<Point2> points;
    for (double s = wheel.s_begin(); s <= wheel.s_end(); s += fine)
      points.push_back(wheel.at(s).position);
    std::vector<double> difference;
    constexpr double step = 0.05;
    for (int i = 0; i <= 80; ++i)
      difference.push_back(touch_height(points, height, i * step) - touch_height(points, height, -i * step));
    for (const double amplitude : {3.0, 4.0}) {
      const auto& motion = found.values[static_cast<std::size_t>(amplitude) - 1].motion;
      if (!motion || std::abs(motion->from + amplitude) > 1e-3) // a motion beside the middle
        continue;
      const double brute = klingel(difference, step, amplitude);
      EXPECT_NEAR(motion->tan_gamma, brute, 0.03 * brute + 1e-3)
          << rail_name << " " << wheel_name << " " << amplitude;
      ++compared;
    }
  }
  fmt::print("{} conicities compared\n", compared);
  EXPECT_GT(compared, 80);
}

/// EN 15302's wheels on its rail A: the wheels of the tables, and conicities as printed in public sources
/// (A, B). Gauge of the reference: 1435.16 mm. At 3 mm wheel B stands on a jump of the contact, where 0.1 mm
/// of displacement decide: the printed value lies between those of 2.9 and 3.1 mm.
TEST(ReferenceWheels, AAndBOfTheTablesHaveThePrintedConicity) {
  const TabulatedProfile rail = standard_profile("EN15302-rail-A");
  const auto conicity = [&](const char* name, double step = 1) {
    const TabulatedProfile wheel = standard_profile(name);
    return wheelset_conicity({.right_rail = rail,
                              .right_wheel = wheel,
                              .left_rail = rail,
                              .left_wheel = wheel,
                              .position = {.gauge = 1435.16}},
                             {.largest = 6, .step = step});
  };
  for (const auto& [name, printed] :
       {std::pair{"EN15302-A", std::vector{.1248, .1548, .1879, .2160, .2543, .3027}},
        {"EN15302-B", std::vector{.025, .025, .0576, .2413, .2827, .3017}}}) {
    const WheelsetConicity found = conicity(name);
    for (int k = 0; k < 6; ++k) {
      const auto& motion = found.values[k].motion;
      ASSERT_TRUE(motion) << name << " " << k + 1;
      fmt::print("{} {} mm: {:.4f}, printed {:.4f}\n", name, k + 1, motion->tan_gamma, printed[k]);
      if (name == std::string("EN15302-B") && k == 2)
        continue;
      EXPECT_NEAR(motion->tan_gamma, printed[k], std::min(0.05, 0.5 * printed[k])) << name << " " << k + 1;
    }
    EXPECT_NEAR(found.nonlinearity, (printed[3] - printed[1]) / 2, 0.01) << name;
  }
  const WheelsetConicity b = conicity("EN15302-B", 0.1);
  EXPECT_LT(b.values[28].motion->tan_gamma, .0576);
  EXPECT_GT(b.values[30].motion->tan_gamma, .0576);
  // Where H touches with its cone of 1:40 alone, and beyond the kink with that of 1:5.
  const WheelsetConicity h = conicity("EN15302-H");
  EXPECT_NEAR(h.values[0].motion->tan_gamma, 0.025, 2e-4);
  EXPECT_GT(h.values[5].motion->tan_gamma, 0.1);
  for (const char* name : {"EN15302-C", "EN15302-I"})
    EXPECT_TRUE(conicity(name).values[2].motion) << name;
}

/// A cone between two others: its nonlinearity is 0. Travel on a cone: as far as the wheelset moves.
TEST(Nonlinearity, OfAConeIsZeroAndItsTravelIsTheWholeWay) {
  const ProfileCurve cone =
      ProfileCurve::through_points("cone", std::vector<Point2>{{60, -3}, {0, 0}, {-30, 1.5}, {-60, 3}});
  const TabulatedProfile rail = standard_profile("60E1");
  const WheelsetConicity found = wheelset_conicity(
      {.right_rail = rail, .right_wheel = cone, .left_rail = rail, .left_wheel = cone, .position = {}},
      {.largest = 5, .step = 1});
  EXPECT_NEAR(found.nonlinearity, 0, 1e-6);
  EXPECT_TRUE(std::isnan(found.play)); // it has no flange
  EXPECT_EQ(found.rated_amplitude, 3);
  for (const WheelsetConicity::Value& v : found.values) {
    EXPECT_NEAR(v.wheel_travel, 2 * v.amplitude, 1e-4); // upright, it touches at one place of the rail
    EXPECT_NEAR(v.rail_travel, 0, 1e-4);
  }
}

/// The flange of S1002 is 32.5 mm thick 10 mm below the tape circle (EN 13715): 1360 + 65 = 1425.
TEST(Nonlinearity, TakesItsAmplitudesByThePlay) {
  const TabulatedProfile rail = standard_profile("60E1"), wheel = standard_profile("S1002");
  const auto found = [&](double gauge) {
    return wheelset_conicity({.right_rail = rail,
                              .right_wheel = wheel,
                              .left_rail = rail,
                              .left_wheel = wheel,
                              .position = {.gauge = gauge, .rail_inclination = 0.025}},
                             {.largest = 5, .step = 1});
  };
  for (const auto& [gauge, amplitude] :
       {std::pair{1435.0, 3.0}, {1432.5, 3.0}, {1431.0, 2.5}, {1429.0, 2.0}}) {
    const WheelsetConicity c = found(gauge);
    EXPECT_NEAR(c.play, gauge - 1425, 0.02) << gauge;
    EXPECT_NEAR(c.rated_amplitude, amplitude, 0.01) << gauge;
  }
  const WheelsetConicity c = found(1435);
  EXPECT_DOUBLE_EQ(c.nonlinearity, (c.values[3].motion->tan_gamma - c.values[1].motion->tan_gamma) / 2);
  ASSERT_EQ(c.conformity.size(), 2u);
  EXPECT_EQ(c.conformity[0].lateral, 0);
  EXPECT_GT(c.conformity[1].lateral, 4);
}

} // namespace
} // namespace bem_contact
