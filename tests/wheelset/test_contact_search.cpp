#include "bem_contact/wheelset/contact_search.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "tests/wheelset/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <random>

namespace {

using namespace bem_contact;
using ::testing::HasSubstr;

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The vertical distance over (x, y) without any contact locus: the wheel's surface from two angles, the rail
/// as a height. Independent of what it checks but for the curves and the rail's pose.
class BruteForce {
public:
  BruteForce(const TabulatedProfile& rail, const TabulatedProfile& wheel, double reach)
      : angles(2 * static_cast<int>(reach / dangle) + 1), wheel_(wheel) {
    const int n = static_cast<int>(std::ceil((rail.s_end() - rail.s_begin()) / 2e-3));
    for (int i = 0; i <= n; ++i)
      rail_.push_back(rail.at(std::min(rail.s_begin() + 2e-3 * i, rail.s_end())).position);
    for (double s = wheel.s_begin(); s <= wheel.s_end(); s += ds)
      profile_.push_back(wheel.at(s));
    for (const TabulatedProfile::Node& node : wheel.nodes())
      if (dot(node.before, node.after) < 0.99) // at an edge the angle of the least distance leaps with s
        profile_.push_back(wheel.at(node.s));
    std::ranges::sort(profile_, {}, &CurvePoint::s);
  }

  struct Minimum {
    double distance = infinite, s = 0, y = 0, x = 0, theta = 0;
  };
  /// Local minima, those within `band` of the lowest.
  std::vector<Minimum> search(const SceneFile::Position& position, const WheelOnRail& pair, double band) {
    stand(position, pair);
    const int n = static_cast<int>(profile_.size());
    std::vector<double> h(static_cast<std::size_t>(n) * angles, infinite);
    double lowest = infinite;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < angles; ++j) {
        double& value = h[static_cast<std::size_t>(i) * angles + j];
        value = distance(profile_[i].position, angle(j)).distance;
        lowest = std::min(lowest, value);
      }
    std::vector<Minimum> out;
    for (int i = 1; i + 1 < n; ++i)
      for (int j = 1; j + 1 < angles; ++j) {
        const double value = h[static_cast<std::size_t>(i) * angles + j];
        if (!(value < lowest + band))
          continue;
        bool least = true;
        for (int di = -1; di <= 1; ++di)
          for (int dj = -1; dj <= 1; ++dj)
            least &= value <= h[static_cast<std::size_t>(i + di) * angles + j + dj];
        if (!least)
          continue;
        const Minimum m = refined(profile_[i].s, angle(j));
        if (m.distance < infinite)
          out.push_back(m);
      }
    std::ranges::sort(out, {}, &Minimum::distance);
    return out;
  }

  /// How far the distance rises between a minimum and the next lower place of the profile.
  double barrier(const Minimum& m) const {
    double least = infinite;
    for (const double step : {-0.02, 0.02}) {
      double rise = 0, s = m.s + step;
      for (; s > wheel_.s_begin() && s < wheel_.s_end(); s += step) {
        const double h = least_over_angle(s, m.theta).distance;
        if (h < m.distance)
          break;
        rise = std::max(rise, h - m.distance);
      }
      least = std::min(least, rise);
    }
    return least;
  }

  /// What may differ there: 1e-6 mm and what the chords of the raster miss of the rail.
  static double tolerance(const WheelOnRail& pair, double rail_s) {
    const CurvePoint p = pair.rail_at(rail_s);
    return 1e-6 + dy * dy / 8 * std::abs(p.curvature / std::pow(std::cos(p.delta), 3));
  }
  bool is_minimum(const TouchPoint& p, double theta, double tolerance) const {
    const auto excess = [&](double s) { return least_over_angle(s, theta).distance - p.distance; };
    return std::abs(excess(p.wheel_s)) < tolerance && excess(p.wheel_s - 0.02) > -tolerance &&
           excess(p.wheel_s + 0.02) > -tolerance;
  }

private:
  static constexpr double ds = 0.25, dangle = 2e-3;
  int angles; ///< of the raster
  double angle(int j) const { return dangle * (j - angles / 2); }

  void stand(const SceneFile::Position& position, const WheelOnRail& pair) {
    const double side = position.side == "left" ? -1 : 1;
    roll_ = side * position.roll, yaw_ = side * position.yaw, lateral_ = side * position.lateral;
    arm_ = position.back_to_back / 2 + 70, radius_ = position.wheel_radius;
    // As a height on a regular raster of y, from the points that are seen from above.
    std::vector<Point2> p;
    for (const Point2& q : rail_)
      p.push_back(pair.rail_pose.to_track(q));
    const auto [lo, hi] = std::ranges::minmax(p, {}, &Point2::y);
    y0_ = lo.y;
    height_.assign(static_cast<std::size_t>((hi.y - lo.y) / dy) + 1, infinite);
    for (std::size_t k = 0; k + 1 < p.size(); ++k) {
      const Point2 a = p[k].y <= p[k + 1].y ? p[k] : p[k + 1], b = p[k].y <= p[k + 1].y ? p[k + 1] : p[k];
      for (int i = static_cast<int>(std::ceil((a.y - y0_) / dy)); y0_ + i * dy <= b.y; ++i) {
        const double t = b.y > a.y ? (y0_ + i * dy - a.y) / (b.y - a.y) : 0;
        height_[i] = std::min(height_[i], a.z + t * (b.z - a.z));
      }
    }
  }

  Minimum distance(Point2 section, double theta) const {
    const double r = radius_ + section.z;
    const double x = r * std::sin(theta), y = arm_ + section.y, z = r * std::cos(theta);
    const double rolled_y = y * std::cos(roll_) - z * std::sin(roll_);
    const double down = y * std::sin(roll_) + z * std::cos(roll_) - radius_;
    const double across = lateral_ + x * std::sin(yaw_) + rolled_y * std::cos(yaw_);
    const double at = (across - y0_) / dy;
    const auto k = static_cast<std::ptrdiff_t>(std::floor(at));
    if (k < 0 || k + 1 >= static_cast<std::ptrdiff_t>(height_.size()))
      return {};
    const double t = at - static_cast<double>(k);
    return {(1 - t) * height_[k] + t * height_[k + 1] - down, 0, across,
            x * std::cos(yaw_) - rolled_y * std::sin(yaw_)};
  }

  template <class F> static double golden(double a, double b, double tolerance, const F& f) {
    const double g = 0.5 * (std::sqrt(5.0) - 1);
    double c = b - g * (b - a), d = a + g * (b - a), fc = f(c), fd = f(d);
    while (b - a > tolerance) {
      if (fc < fd) {
        b = d, d = c, fd = fc, c = b - g * (b - a), fc = f(c);
      } else {
        a = c, c = d, fc = fd, d = a + g * (b - a), fd = f(d);
      }
    }
    return 0.5 * (a + b);
  }

  Minimum least_over_angle(double s, double theta0) const {
    const Point2 p = wheel_.at(std::clamp(s, wheel_.s_begin(), wheel_.s_end())).position;
    const double theta = golden(theta0 - 2 * dangle, theta0 + 2 * dangle, 1e-8,
                                [&](double t) { return distance(p, t).distance; });
    Minimum m = distance(p, theta);
    m.s = s, m.theta = theta;
    return m;
  }

  /// Over the angle inside, over the arc length outside; nothing where it runs out of the cells around it.
  Minimum refined(double s0, double theta0) const {
    const double s = golden(s0 - 2 * ds, s0 + 2 * ds, 1e-6,
                            [&](double t) { return least_over_angle(t, theta0).distance; });
    const Minimum m = least_over_angle(s, theta0);
    return std::abs(m.s - s0) > 1.9 * ds || std::abs(m.theta - theta0) > 1.9 * dangle ? Minimum{} : m;
  }

  static constexpr double dy = 1e-3;
  TabulatedProfile wheel_;
  std::vector<Point2> rail_;
  std::vector<CurvePoint> profile_;
  double roll_ = 0, yaw_ = 0, lateral_ = 0, arm_ = 0, radius_ = 0, y0_ = 0;
  std::vector<double> height_;
};

struct Tally {
  int cases = 0, refused = 0, several = 0;
  double worst = 0;
};

void compare_with_brute_force(const TabulatedProfile& rail, const TabulatedProfile& wheel, int cases,
                              unsigned seed, Tally& tally, double reach = 0.1) {
  BruteForce brute(rail, wheel, reach);
  std::mt19937 random(seed);
  const auto uniform = [&](double a, double b) { return std::uniform_real_distribution(a, b)(random); };
  for (int i = 0; i < cases; ++i) {
    SceneFile::Position position;
    position.side = i % 2 ? "left" : "right";
    position.lateral = uniform(-10, 10);
    position.yaw = uniform(-0.024, 0.024);
    position.roll = uniform(-0.01, 0.01);
    position.cant = 0.025 * (i % 3);
    position.rail_lateral = uniform(-2, 2);
    position.rail_vertical = uniform(-2, 2);
    position.rail_roll = uniform(-0.01, 0.01);
    ++tally.cases;
    WheelOnRail pair = place(position, rail, wheel);
    std::vector<TouchPoint> found;
    try {
      found = find_touch_points(pair);
    } catch (const InputError&) {
      ++tally.refused;
      continue;
    }
    const auto minima = brute.search(position, pair, 0.5);
    ASSERT_FALSE(minima.empty());
    tally.worst = std::max(tally.worst, std::abs(found.front().distance - minima.front().distance));
    tally.several += found.size() > 1 && found[1].distance < found[0].distance + 0.5;
    EXPECT_NEAR(found.front().distance, minima.front().distance,
                BruteForce::tolerance(pair, found.front().rail_s))
        << "case " << i << ": y " << position.lateral << " yaw " << position.yaw << " brute at x "
        << minima.front().x << " y " << minima.front().y << ", found x " << found.front().x << " y "
        << found.front().position.y;
    // Every minimum is there, unless less than a barrier tells it from a lower one.
    for (const BruteForce::Minimum& m : minima) {
      const bool known = std::ranges::any_of(found, [&](const TouchPoint& p) {
        return std::abs(p.distance - m.distance) < BruteForce::tolerance(pair, p.rail_s);
      });
      if (!known) {
        EXPECT_LT(brute.barrier(m), flat_distance)
            << "case " << i << ": " << m.distance << " at x " << m.x << " y " << m.y;
      }
    }
    const WheelFrame frame = pair.wheel_frame();
    for (const TouchPoint& p : found) {
      const Point2 section = wheel.at(p.wheel_s).position;
      const double forward = p.x - frame.centre[0] - section.y * frame.axle[0];
      EXPECT_TRUE(brute.is_minimum(p, std::asin(forward / (position.wheel_radius + section.z)),
                                   BruteForce::tolerance(pair, p.rail_s)))
          << "case " << i << ": " << p.distance << " at x " << p.x << " y " << p.position.y;
    }
  }
}

void report(const char* what, const Tally& tally) {
  std::printf("%s: %d positions, %d refused, %d with several minima within .5 mm, worst difference %.1e mm\n",
              what, tally.cases, tally.refused, tally.several, tally.worst);
}

TEST(ContactSearch, FindsWhatBruteForceFindsInTwoDimensions) {
  Tally tally;
  compare_with_brute_force(named_profile("60E1", ProfileKind::rail),
                           named_profile("S1002", ProfileKind::wheel), 1000, 1, tally);
  report("S1002 on 60E1", tally);
  EXPECT_LT(tally.refused, 10);
  EXPECT_GT(tally.several, 20);
}

TEST(ContactSearch, FindsWhatBruteForceFindsOnWornProfiles) {
  const std::filesystem::path folder = std::filesystem::path(CONFORMAL_SOURCE_DIR) / "data/bodies";
  Tally tally;
  compare_with_brute_force(read_profile(folder / "worn_rail.txt", ProfileKind::rail),
                           read_profile(folder / "worn_wheel.txt", ProfileKind::wheel), 200, 2, tally);
  report("worn on worn", tally);
  EXPECT_LT(tally.refused, 20);
}

/// A folder of profile files, any number of each kind: the Manchester benchmark's, or one's own.
TEST(ContactSearch, FindsWhatBruteForceFindsOnSampleProfiles) {
  const char* folder = std::getenv("CONFORMAL_SAMPLE_PROFILES");
  if (!folder)
    GTEST_SKIP() << "set CONFORMAL_SAMPLE_PROFILES to a folder of .prr, .ban, .prw and .whl files";
  std::vector<TabulatedProfile> rails, wheels;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string kind = entry.path().extension().string();
    if (kind == ".prr" || kind == ".ban")
      rails.push_back(read_profile(entry.path(), ProfileKind::rail));
    else if (kind == ".prw" || kind == ".whl")
      wheels.push_back(read_profile(entry.path(), ProfileKind::wheel));
  }
  Tally tally;
  for (const TabulatedProfile& rail : rails)
    for (const TabulatedProfile& wheel : wheels)
      compare_with_brute_force(rail, wheel, 100, 3, tally);
  report("sample profiles", tally);
}

TabulatedProfile polyline(const char* name, std::vector<Point2> corners) {
  std::vector<Point2> points{corners.front()};
  for (std::size_t k = 0; k + 1 < corners.size(); ++k)
    for (int i = 1; i <= 10; ++i)
      points.push_back(corners[k] + 0.1 * i * (corners[k + 1] - corners[k]));
  return ProfileCurve::through_points(name, points);
}

TEST(ContactSearch, FindsWhatBruteForceFindsAtKinks) {
  // A tread with a square flange: a hollow corner and two sharp edges, on which a yawed wheel rides.
  Tally tally;
  compare_with_brute_force(named_profile("60E1", ProfileKind::rail),
                           polyline("square flange", {{60, -2}, {-32, 0}, {-34, 20}, {-55, 21}, {-70, 5}}),
                           60, 4, tally, 0.6);
  report("square flange on 60E1", tally);
  EXPECT_EQ(tally.refused, 0);
}

TEST(ContactSearch, AYawedFlangeTouchesInFront) {
  // Front to the right: the flange of the right wheel, which runs to the left of its rail, meets it in front
  // of the wheel's centre by r tan(yaw) tan(slope); the wheel itself has gone back by 750 mm sin(yaw).
  for (const double yaw : {0.01, -0.01}) {
    SceneFile::Position position;
    position.lateral = 9;
    position.yaw = yaw;
    WheelOnRail pair =
        place(position, named_profile("60E1", ProfileKind::rail), named_profile("S1002", ProfileKind::wheel));
    const TouchPoint touch = lower_to_touch(pair).front();
    ASSERT_LT(touch.delta, -1.0);
    const double radius = 460 + pair.wheel.at(touch.wheel_s).position.z;
    EXPECT_NEAR(touch.x, -750 * std::sin(yaw) + radius * std::tan(yaw) * std::tan(-touch.delta), 0.05 * 17);
    EXPECT_GT(yaw * (touch.x + 750 * std::sin(yaw)), 0);
  }
}

TEST(ContactSearch, AYawedBallTouchesBelowItsCentre) {
  // A ball of radius 20 about the axle, 700 mm from the vertical it is yawed about.
  WheelOnRail pair = shapes::arcs(80, 20, 20);
  pair.yaw = 0.3;
  pair.centre_y = -700;
  const TouchPoint touch = lower_to_touch(pair).front();
  const double y = -700 + 700 * std::cos(0.3);
  EXPECT_NEAR(touch.x, -700 * std::sin(0.3), 1e-5);
  EXPECT_NEAR(touch.delta, std::asin(y / 100), 1e-4);
}

TEST(ContactSearch, ALineContactIsOne) {
  // A conical wheel on a rail whose head has a flat of the same slope, 10 mm wide between arcs of 40 mm:
  // within flat_distance the arcs add sqrt(2 * 40 * 2e-5) on either side.
  const double slope = -0.05;
  std::vector<CurvePiece> head{arc_piece({0, 0}, slope - 1, 1 / 40.0, 40), arc_piece({0, 0}, slope, 0, 10),
                               arc_piece({0, 0}, slope, 1 / 40.0, 40)};
  const TabulatedProfile rail(ProfileCurve::from_pieces("flat head", head));
  const TabulatedProfile wheel(ProfileCurve::from_pieces(
      "cone", {line_piece({300, 300 * std::tan(slope)}, {-300, -300 * std::tan(slope)})}));
  WheelOnRail pair{rail, wheel, {}, {{rail.at(0).position.y, 0}, 0}, 460};
  const std::vector<TouchPoint> touch = lower_to_touch(pair);
  ASSERT_EQ(touch.size(), 1u);
  EXPECT_NEAR(touch[0].s_to - touch[0].s_from, 10 + 2 * std::sqrt(80 * flat_distance), 1e-3);
  // Yawed, the cone is round along x there and touches in a point or two, still reported once.
  pair.yaw = 0.02;
  EXPECT_EQ(lower_to_touch(pair).size(), 1u);
}

} // namespace
