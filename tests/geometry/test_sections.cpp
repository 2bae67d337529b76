#include "bem_contact/base/error.hpp"
#include "bem_contact/geometry/contact_search.hpp"
#include "bem_contact/geometry/rail_height.hpp"
#include "bem_contact/geometry/rail_rows.hpp"
#include "bem_contact/geometry/rigid_slip.hpp"
#include "bem_contact/geometry/undeformed_distance.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/profile/sections/slices_file.hpp"
#include "tests/base/temporary_folder.hpp"
#include "tests/geometry/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <string>

namespace {

using namespace bem_contact;
using shapes::standing;
using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr double absent = std::numeric_limits<double>::quiet_NaN();

/// A curve moved by (y, z), and scaled along z about its origin.
ProfileCurve moved(const ProfileCurve& curve, Point2 by, double scale = 1) {
  std::vector<Point2> points;
  for (const CurvePoint& p : points_along(curve, 0.25))
    points.push_back({p.position.y + by.y, scale * (p.position.z + by.z)});
  return ProfileCurve::through_points(curve.name(), points);
}

std::shared_ptr<const RailSurfaces> surface(std::vector<BodySection> sections) {
  return std::make_shared<const RailSurfaces>(
      std::vector{RailSurfaces::Body{std::make_shared<const SectionedSurface>(std::move(sections))}});
}

const ProfileCurve& s1002() {
  static const ProfileCurve curve = named_profile("S1002", ProfileKind::wheel);
  return curve;
}
const ProfileCurve& uic60() {
  static const ProfileCurve curve = named_profile("60E1", ProfileKind::rail);
  return curve;
}

/// The rail's head as points, so that all of them have the same corners.
const ProfileCurve& head() {
  static const ProfileCurve curve = moved(uic60(), {0, 0});
  return curve;
}

struct Placed {
  WheelOnRail pair;
  std::vector<TouchPoint> touch;
};
Placed placed(const WheelsetPosition& position, const std::shared_ptr<const RailSurfaces>& rail,
              const ProfileCurve& first = uic60()) {
  Placed out{place(position, first, s1002(), rail), {}};
  out.touch = lower_to_touch(out.pair);
  return out;
}

/// Undeformed distance on a grid about the first touch.
std::vector<double> gaps(const Placed& at) {
  std::vector<double> s, x;
  for (int i = -8; i <= 8; ++i) {
    s.push_back(at.touch.front().rail_s + 0.7 * i);
    x.push_back(at.touch.front().x + 1.1 * i);
  }
  const std::vector<ContactRow> rows = rail_rows(at.pair, s, 0.1);
  const ContactLocus locus(at.pair);
  return undeformed_distance(at.pair, rows_on_locus(locus, rows), rows, x);
}

TEST(RailSections, ThatAreAllEqualAreTheProfile) {
  const auto rail = surface({{-300, uic60()}, {-20, uic60()}, {110, uic60()}, {400, uic60()}});
  for (const auto& [lateral, yaw] : {std::pair{0.0, 0.0}, {3.0, 0.01}, {6.0, -0.005}}) {
    const Placed profile = placed(standing(lateral, yaw), nullptr),
                 sections = placed(standing(lateral, yaw, 17), rail);
    EXPECT_NEAR(sections.pair.wheel_pose.origin.z, profile.pair.wheel_pose.origin.z, 1e-9) << lateral;
    ASSERT_EQ(sections.touch.empty(), false);
    EXPECT_NEAR(sections.touch.front().rail_s, profile.touch.front().rail_s, 1e-5) << lateral;
    EXPECT_NEAR(sections.touch.front().x, profile.touch.front().x, 1e-5) << lateral;
    Placed same = sections;
    same.touch = profile.touch;
    const std::vector<double> a = gaps(profile), b = gaps(same);
    for (std::size_t i = 0; i < a.size(); ++i)
      EXPECT_NEAR(a[i], b[i], 1e-9) << lateral << " " << i;
    EXPECT_NEAR(sections.pair.sinking, 0, 1e-12);
    EXPECT_NEAR(sections.pair.surface_speed, 1, 1e-12);
  }
}

TEST(RailSections, AStretchThatIsMovedIsTheSame) {
  std::vector<BodySection> sections, later;
  for (int i = 0; i < 5; ++i) {
    sections.push_back({100.0 * i, moved(head(), {0.05 * i * i, -0.3 * i * i})});
    later.push_back({100.0 * i + 1234.5, sections.back().profile});
  }
  const Placed a = placed(standing(2, 0, 230), surface(sections)),
               b = placed(standing(2, 0, 230 + 1234.5), surface(later));
  EXPECT_NEAR(a.pair.wheel_pose.origin.z, b.pair.wheel_pose.origin.z, 1e-8);
  EXPECT_NEAR(a.touch.front().x, b.touch.front().x, 1e-5);
}

/// A rail that is bent to a circle along x, by its sections; at the top the wheel lies above it as two
/// circles do. The fourth power of the distance of sections is that of cubic splines.
TEST(RailSections, OfACircleAlongXConvergeToIt) {
  constexpr double circle = 500, radius = 460;
  const ProfileCurve arc = shapes::rail_arc(300, 0.1);
  const auto error_of = [&](double spacing) {
    std::vector<BodySection> sections;
    for (int i = -4; i <= 5; ++i) { // the wheel stands in the middle between two
      const double u = spacing * (i - 0.5);
      sections.push_back({u, moved(arc, {0, circle - std::sqrt(circle * circle - u * u)})});
    }
    WheelOnRail pair = shapes::arcs(300, 600, radius, 0.1);
    WheelsetPosition position;
    position.rail_origin = Point2{0, 0};
    position.wheel_origin = Point2{0, 0};
    position.wheel_radius = radius;
    Placed at{place(position, sections.front().profile, pair.wheel, surface(sections)), {}};
    at.touch = lower_to_touch(at.pair);
    const CurvePoint top = at.pair.rail_at(at.touch.front().rail_s);
    const std::vector<ContactRow> rows{{top.s, top.position, top.delta}};
    std::vector<double> x; // at the same places between the sections
    for (const double share : {-0.45, -0.3, -0.1, 0.0, 0.15, 0.25, 0.4})
      x.push_back(share * spacing);
    const ContactLocus locus(at.pair);
    const std::vector<double> gap = undeformed_distance(at.pair, rows_on_locus(locus, rows), rows, x);
    double worst = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double exact = radius - std::sqrt(radius * radius - x[i] * x[i]) + circle -
                           std::sqrt(circle * circle - x[i] * x[i]);
      worst = std::max(worst, std::abs(gap[i] - exact));
    }
    return worst;
  };
  const double coarse = error_of(40), middle = error_of(20), fine = error_of(10);
  EXPECT_LT(coarse, 1e-3);
  EXPECT_GT(coarse / middle, 10);
  EXPECT_GT(middle / fine, 10);
}

/// Over all points of the wheel, at each the height of the rail at its x; refined about the nearest ones.
struct Nearest {
  double distance = std::numeric_limits<double>::infinity(), x = 0, y = 0;
};
template <class Height>
Nearest nearest_by_brute_force(const WheelFrame& frame, double radius, const Height& height) {
  Nearest best;
  double s_at = 0, theta_at = 0;
  const auto look = [&](double s_from, double s_to, double s_step, double from, double to, double step) {
    for (double s = s_from; s <= s_to; s += s_step) {
      const Point2 p = s1002().at(s).position;
      for (double theta = from; theta <= to; theta += step) {
        const auto at = [&](int i) {
          return frame.centre[i] + p.y * frame.axle[i] +
                 (radius + p.z) * (std::cos(theta) * frame.down[i] + std::sin(theta) * frame.forward[i]);
        };
        const double d = height(at(0), at(1)) - at(2);
        if (d < best.distance)
          best = {d, at(0), at(1)}, s_at = s, theta_at = theta;
      }
    }
  };
  look(-50, 50, 0.25, -0.2, 0.2, 2e-3);
  const double s = s_at, theta = theta_at;
  look(s - 0.5, s + 0.5, 4e-3, theta - 4e-3, theta + 4e-3, 2e-5);
  return best;
}

/// A head whose radius grows along the track is a cone. Two sections are enough, since its generators are
/// straight: each is the arc there, yawed and inclined as its generator.
TEST(RailSections, OfAConeAreTheCone) {
  constexpr double radius = 300, growth = 0.2, half_angle = 0.11, along = 100;
  const auto section = [&](double u) {
    const ProfileCurve arc = shapes::rail_arc(radius + growth * u, half_angle);
    return BodySection{u, arc, {arc.s_begin(), arc.s_end()}};
  };
  const auto rail = surface({section(-400), section(600)});
  const double t_middle = 0.5 * (rail->nodes().front() + rail->nodes().back());
  for (const double u : {-399.0, -20.0, 0.0, 333.0})
    for (const double t : rail->nodes()) {
      const double r = radius + growth * u; // its centre is at z = r
      const double phi = half_angle * (t - t_middle) / (rail->nodes().back() - t_middle);
      const SectionedSurface::Point p = rail->at(u, t);
      ASSERT_NEAR(std::hypot(p.position.y, r - p.position.z), r, 2e-6) << u << " " << t;
      ASSERT_NEAR(p.by_u.y, growth * std::sin(phi), 1e-6) << u << " " << t;       // yaw of the generator
      ASSERT_NEAR(p.by_u.z, growth * (1 - std::cos(phi)), 1e-6) << u << " " << t; // and its inclination
    }
  WheelsetPosition position = standing(-14, 0, along);
  position.rail_inclination = 0;
  position.rail_origin = Point2{753, 0};
  const ProfileCurve arc = shapes::rail_arc(radius + growth * along, half_angle);
  const WheelOnRail even = place(position, arc, s1002());
  const auto cone = [&](double x, double y) { // z there
    const double r = radius + growth * (along + x);
    return std::abs(y - 753) < r * std::sin(half_angle) ? r - std::sqrt(r * r - (y - 753) * (y - 753))
                                                        : std::numeric_limits<double>::infinity();
  };
  const Nearest direct = nearest_by_brute_force(even.wheel_frame(), 460, cone);
  const Placed at = placed(position, rail, arc);
  EXPECT_NEAR(at.pair.wheel_pose.origin.z - even.wheel_pose.origin.z, direct.distance, 1e-4);
  EXPECT_LT(at.pair.wheel_pose.origin.z - even.wheel_pose.origin.z, direct.distance + 1e-6);
  const TouchPoint& touch = at.touch.front();
  const Vector3 place =
      at.pair.sections->frame().point_in_track({touch.x, touch.position.y, touch.position.z});
  const double phi = std::asin((place[1] - 753) / (radius + growth * (along + place[0])));
  EXPECT_GT(std::abs(phi), 0.008);
  EXPECT_NEAR(at.pair.sinking, growth * (1 - 1 / std::cos(phi)), 1e-7); // where y stays it rises
}

/// A nose that rises 1:10: a ruled surface along x.
TEST(RailSections, ARisingNoseIsTouchedWhereBruteForceTouchesIt) {
  constexpr double rise = -0.1;
  const auto rail = surface({{0, head()}, {1000, moved(head(), {0, 1000 * rise})}});
  WheelsetPosition position = standing(0, 0, 300);
  position.rail_inclination = 0; // of the sections, which keep their own heights
  for (const double yaw : {0.0, 0.008}) {
    position.yaw = yaw;
    WheelOnRail even = place(position, head(), s1002());
    const RailHeight profile(even);
    int near = 0;
    const Nearest direct = nearest_by_brute_force(even.wheel_frame(), 460, [&](double x, double y) {
      const auto h = profile.at(y, near);
      return h ? h->z + rise * (300 + x) : std::numeric_limits<double>::infinity();
    });
    const Placed at = placed(position, rail, head());
    EXPECT_NEAR(at.pair.wheel_pose.origin.z - even.wheel_pose.origin.z, direct.distance, 1e-4);
    EXPECT_LT(at.pair.wheel_pose.origin.z - even.wheel_pose.origin.z, direct.distance + 1e-7);
    const TouchPoint& touch = at.touch.front();
    const Vector3 place =
        at.pair.sections->frame().point_in_track({touch.x, touch.position.y, touch.position.z});
    EXPECT_NEAR(place[0], direct.x, 0.02);
    EXPECT_NEAR(place[1], direct.y, 0.02);
    if (yaw == 0) {
      EXPECT_NEAR(place[0], 460 * 0.1 / std::sqrt(1.01), 1.0);
    }
    EXPECT_NEAR(at.pair.sections->frame().rise(), rise, 1e-2); // the place is inclined a little
    EXPECT_NEAR(at.pair.sinking, rise, 1e-6);
  }
}

/// The wheel's centre rolls along the ramp: nothing slides where the rolling radius is that of the contact.
TEST(RailSections, AWheelRollsUpANoseWithoutSlip) {
  const auto rail = surface({{0, head()}, {1000, moved(head(), {0, -100})}});
  WheelsetPosition position = standing(0, 0, 300);
  position.rail_inclination = 0;
  const Placed at = placed(position, rail, head());
  const TouchPoint& touch = at.touch.front();
  const CurvePoint p = at.pair.rail_at(touch.rail_s);
  const ReferencePoint reference{p.position, p.s, p.delta, touch.x};
  const std::vector<ContactRow> row{{p.s, p.position, p.delta}};
  const std::vector<double> x{touch.x};
  EXPECT_NEAR(rigid_slip(at.pair, reference, {}, row, x).x[0], 0, 1e-9);
  EXPECT_NEAR(at.pair.surface_speed, std::sqrt(1.01), 1e-4);
  // With the radius of the level track the wheel is too slow for the ramp, and brakes.
  const double level = radius_at(at.pair, touch.x, p.position) * at.pair.surface_speed;
  EXPECT_NEAR(rigid_slip(at.pair, reference, {.rolling_radius = level}, row, x).x[0],
              1 - 1 / at.pair.surface_speed, 1e-5);
}

/// A hump: no plane anywhere. The height at which the wheel touches, against dense points.
TEST(RailSections, AHumpLiftsTheWheelAsBruteForceSays) {
  const auto lower = [](double u) { return -4 * std::exp(-u * u / (2 * 150 * 150.0)); };
  std::vector<BodySection> sections;
  for (int i = -10; i <= 10; ++i)
    sections.push_back({40.0 * i, moved(head(), {0, lower(40.0 * i)})});
  const auto rail = surface(sections);
  for (const double along : {-200.0, -90.0, 0.0, 130.0}) {
    WheelsetPosition position = standing(0, 0, along);
    position.rail_inclination = 0;
    position.rail_origin = Point2{750, 0};
    WheelOnRail even = place(position, head(), s1002());
    const RailHeight profile(even);
    int near = 0;
    const Nearest direct = nearest_by_brute_force(even.wheel_frame(), 460, [&](double x, double y) {
      const auto h = profile.at(y, near);
      return h ? h->z + lower(along + x) : std::numeric_limits<double>::infinity();
    });
    const Placed at = placed(position, rail, head());
    EXPECT_NEAR(at.pair.wheel_pose.origin.z - even.wheel_pose.origin.z, direct.distance, 2e-3) << along;
  }
}

/// Feature lines pass through the points that were given, and sections are what they are at their places.
TEST(SectionedSurface, KeepsSectionsAndFeatures) {
  std::vector<BodySection> sections;
  for (int i = 0; i < 4; ++i) {
    const ProfileCurve arc = shapes::rail_arc(100 + 20 * i, 0.2);
    sections.push_back({50.0 * i, arc, {arc.s_begin(), -5.0 - i, 6.0 + 2 * i, arc.s_end()}});
  }
  const SectionedSurface made(sections);
  ASSERT_EQ(made.lines().size(), 4u);
  for (const BodySection& section : sections) {
    for (int k = 0; k < 4; ++k)
      EXPECT_NEAR(norm(made.at(section.at, made.lines()[k]).position -
                       section.profile.at(section.features[k]).position),
                  0, 1e-9);
    for (double t = 0.3; t < made.lines().back(); t += 1.7) {
      const Point2 p = made.at(section.at, t).position;
      EXPECT_NEAR(norm(section.profile.nearest(p).position - p), 0, 1e-7);
    }
  }
}

/// A wing that bends, a nose that ends its rise: straight on both sides of the kink, which splines are not.
TEST(SectionedSurface, AKinkIsAnEdgeAcrossTheTrack) {
  const ProfileCurve arc = shapes::rail_arc(200, 0.2);
  const auto made = [&](bool kink) {
    std::vector<BodySection> sections;
    for (int i = -3; i <= 3; ++i)
      sections.push_back({40.0 * i, moved(arc, {0, -2.0 * std::max(i, 0)}), {}, kink && i == 0});
    return SectionedSurface(sections);
  };
  const SectionedSurface edge = made(true), smooth = made(false);
  const double t = 0.4 * edge.lines().back();
  const double level = edge.at(-80, t).position.z;
  for (const double u : {-100.0, -20.0, -1e-6, 0.0, 1.0, 20.0, 100.0}) {
    EXPECT_NEAR(edge.at(u, t).position.z, level - 0.05 * std::max(u, 0.0), 1e-9) << u;
    EXPECT_NEAR(edge.at(u, t).by_u.z, u < 0 ? 0 : -0.05, 1e-9) << u;
  }
  EXPECT_GT(std::abs(smooth.at(-20, t).position.z - level), 0.1);
}

TEST(SectionedSurface, FindsWhatCorresponds) {
  // The same head, one cut deeper at both sides: points that lie on each other correspond.
  std::vector<Point2> points;
  for (const CurvePoint& p : points_along(head(), 0.25))
    if (p.position.z < 20)
      points.push_back(p.position);
  const ProfileCurve cut = ProfileCurve::through_points("cut", points);
  const SectionedSurface made({{0, head()}, {100, cut}, {200, head()}});
  const auto [from, to] = made.extent(50); // what both have
  EXPECT_GT(to - from, cut.s_end() - cut.s_begin() - 1);
  for (double t = from + 1; t < to - 1; t += 2.3) {
    const Point2 a = made.at(0, t).position, b = made.at(100, t).position, middle = made.at(50, t).position;
    EXPECT_NEAR(norm(a - b), 0, 1e-3) << t;
    EXPECT_NEAR(norm(head().nearest(middle).position - middle), 0, 1e-5) << t;
  }
}

/// A nose 2 mm below a wing, with a flangeway between them.
ProfileCurve nose_and_wing(double width, bool nose, bool wing) {
  std::vector<Point2> points;
  const auto line_to = [&](Point2 to) {
    const Point2 from = points.back();
    const int parts = std::max(1, static_cast<int>(std::ceil(norm(to - from) / 0.5)));
    for (int i = 1; i <= parts; ++i)
      points.push_back(from + (static_cast<double>(i) / parts) * (to - from));
  };
  const auto corner = [&](Point2 centre, double radius, double from) {
    for (int i = 1; i <= 16; ++i) {
      const double delta = from + M_PI_2 * i / 16;
      points.push_back(centre + radius * Point2{std::sin(delta), -std::cos(delta)});
    }
  };
  if (nose) {
    points = {{0, 25}};
    line_to({0, 6});
    corner({4, 6}, 4, -M_PI_2);
    line_to({width - 4, 2});
    corner({width - 4, 6}, 4, 0);
    line_to({width, 25});
  }
  if (wing) {
    nose ? line_to({width + 44, 25}) : points.push_back({width + 44, 25});
    line_to({width + 44, 13});
    corner({width + 57, 13}, 13, -M_PI_2);
    line_to({width + 100, 0});
  }
  return ProfileCurve::through_points("crossing", points);
}

/// Without features: the nose begins with an upright end and the wing ends with one, and the wing goes on
/// beside the nose.
TEST(SectionedSurface, FindsWhereANoseBeginsAndAWingEnds) {
  std::vector<BodySection> sections;
  for (int i = 0; i <= 12; ++i)
    sections.push_back({30.0 * i, nose_and_wing(12 + 3.0 * i, i >= 3, i <= 9)});
  const SectionedSurface made(sections);
  const auto apart = [&](double u, Point2 p) { // from the surface
    const auto [from, to] = made.extent(u);
    double least = 1e9;
    for (double t = from; t <= to; t += 0.02)
      least = std::min(least, norm(made.at(u, t).position - p));
    return least;
  };
  for (const double u : {15.0, 45.0, 75.0, 105.0, 135.0, 255.0}) {
    const double width = 12 + u / 10;
    EXPECT_LT(apart(u, {width + 70, 0}), 0.02) << u; // on top of the wing
    EXPECT_LT(apart(u, {width + 57 - 13 * std::sqrt(0.5), 13 - 13 * std::sqrt(0.5)}), 0.05) << u;
  }
  for (const double u : {105.0, 135.0, 255.0, 285.0, 315.0, 345.0})
    EXPECT_LT(apart(u, {4 - 4 * std::sqrt(0.5), 6 - 4 * std::sqrt(0.5)}), 0.05) << u; // the nose's edge
  EXPECT_GT(apart(75, {8, 2}), 20);                                                   // no nose yet
  EXPECT_GT(apart(285, {12 + 28.5 + 70, 0}), 20);                                     // no wing any more
}

/// A nose that begins at the second section, at one end of the profile.
TEST(SectionedSurface, ABladeBeginsWithinTheStretch) {
  const ProfileCurve arc = shapes::rail_arc(200, 0.2);
  const SectionedSurface made(
      {{0, arc, {absent, -10, 30}}, {100, arc, {-20, -10, 30}}, {200, arc, {-20, -10, 30}}});
  EXPECT_EQ(made.extent(50).first, made.lines()[1]);
  EXPECT_EQ(made.extent(150).first, 0);
  EXPECT_EQ(made.extent(50).second, made.lines().back());
}

std::string refusal(std::vector<BodySection> sections) {
  try {
    const SectionedSurface made(std::move(sections));
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing";
}

TEST(SectionedSurface, SaysWhichSectionIsWrong) {
  const ProfileCurve arc = shapes::rail_arc(200, 0.2);
  EXPECT_THAT(refusal({{0, arc}}), HasSubstr("two sections or more"));
  EXPECT_THAT(refusal({{0, arc}, {200, arc}, {100, arc}}),
              AllOf(HasSubstr("Section 3 ('rail arc' at 100 mm) is out of order"), HasSubstr("200 mm")));
  EXPECT_THAT(refusal({{0, arc}, {200, arc}, {200, arc}}),
              HasSubstr("Section 3 ('rail arc' at 200 mm) is doubled"));
  EXPECT_THAT(refusal({{0, arc, {1, 2}}, {200, arc, {1}}}), HasSubstr("has 1 features"));
  EXPECT_THAT(refusal({{0, arc, {1, 2}}, {200, arc, {5, 4}}}),
              AllOf(HasSubstr("Features cross each other in Section 2"), HasSubstr("s = 4 mm")));
  EXPECT_THAT(refusal({{0, arc, {1, 2}}, {200, arc, {1, 100}}}), HasSubstr("Feature 2 of Section 2"));
  EXPECT_THAT(refusal({{0, arc, {1}}, {200, arc, {1}}}), HasSubstr("has one feature"));
  EXPECT_THAT(refusal({{0, arc, {1, 2, absent, 5, 9}}, {200, arc, {1, 2, 3, 5, 9}}}),
              AllOf(HasSubstr("a hole in the rail between 0 mm and 200 mm"), HasSubstr("sections 1")));
  std::vector<Point2> one_sided, other_sided;
  for (double y = -30; y <= 30; y += 0.5)
    one_sided.push_back({y, y < 0 ? y * y / 40 : y * y / 400});
  for (double y = -30; y <= 30; y += 0.5)
    other_sided.push_back({y, y < 0 ? y * y / 400 : y * y / 40});
  const ProfileCurve right = ProfileCurve::through_points("right", one_sided),
                     left = ProfileCurve::through_points("left", other_sided);
  EXPECT_THAT(refusal({{0, right}, {100, right}, {200, left}}),
              HasSubstr("Section 3 ('left' at 200 mm) is the mirror image of its neighbour"));
}

TEST(RailSections, EndWhereTheyEnd) {
  const auto rail = surface({{0, uic60()}, {100, uic60()}});
  try {
    placed(standing(0, 0, 120), rail);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("position.along is 120 mm"), HasSubstr("from 0 to 100 mm")));
  }
}

/// A slices file as CONTACT has it: offset and scale, chord lengths of features, -1 where there is none.
TEST(SlicesFile, IsReadWithItsOptions) {
  const TemporaryFolder folder;
  for (const char* name : {"a.txt", "b.txt"}) {
    std::ofstream points(folder.path() / name);
    for (const CurvePoint& p : points_along(uic60(), 0.5))
      points << p.position.y << " " << p.position.z << "\n";
  }
  const auto written = [&](const std::string& text) {
    std::ofstream(folder.path() / "rail.slcs") << text;
    return folder.path() / "rail.slcs";
  };
  const std::string head = "% a remark\n\n 0.5 1000. U_OFFSET\n 2 NSLC\n 3 1 0 NFEAT\n 1 % U_INTPOL\n",
                    places = " -1.0 'a.txt'\n 0.25\n   \"b.txt\"\n",
                    features = "2\n -1.0 -1 20 999.\n 0.25 0. 20.\n 999\n";
  const ProfileReading reading{.profile_z = ProfileZ::down, .keep_origin = true};
  const std::vector<BodySection> read =
      sections_of_slices(written(head + places + features), ProfileKind::rail, reading).sections;
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].at, -500);
  EXPECT_EQ(read[1].at, 750);
  EXPECT_TRUE(std::isnan(read[0].features[0]));
  EXPECT_NEAR(read[1].features[1], read[1].profile.s_begin() + 20, 0.01);
  EXPECT_EQ(read[1].features[2], read[1].profile.s_end());
  const auto refused = [&](const std::string& text) {
    try {
      read_slices(written(text));
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  EXPECT_FALSE(read_slices(written(head + places + features)).approximated);
  EXPECT_TRUE(read_slices(written(" 0 1\n2\n0\n2\n" + places)).approximated);
  EXPECT_THAT(refused(" 0 1\n2\n0\n3\n" + places),
              AllOf(HasSubstr("rail.slcs:4"), HasSubstr("3 is no way of interpolation")));
  EXPECT_THAT(refused(" 0 1\n2\n0\n1 1\n" + places),
              AllOf(HasSubstr("rail.slcs:4"), HasSubstr("perturbations")));
  EXPECT_THAT(refused(" 0 1\n2\n0\n1\n 5 'a.txt'\n 4 'b.txt'\n"),
              AllOf(HasSubstr("rail.slcs:6"), HasSubstr("at 4 mm")));
  EXPECT_THAT(refused(" 0 1\n3\n0\n1\n 5 'a.txt'\n"), HasSubstr("ends too early"));
  EXPECT_THAT(refused(" 0 x\n3\n0\n1\n"), AllOf(HasSubstr("rail.slcs:1"), HasSubstr("'x' stands where")));
  EXPECT_THAT(refused(head + places + "2\n 7 0 1 2\n"), HasSubstr("a place at 7500 mm"));
  try {
    sections_of_slices(written(" 0 1\n2\n0\n1\n 5 'a.txt'\n 9 'S1002'\n"), ProfileKind::rail, reading);
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("rail.slcs:6"), HasSubstr("S1002")));
  }
  std::filesystem::rename(folder.path() / "rail.slcs", folder.path() / "wheel.SLCW");
  EXPECT_TRUE(names_slices("wheel.SLCW") && names_slices("rail.Slcs"));
  try {
    sections_of_slices(folder.path() / "wheel.SLCW", ProfileKind::rail, reading);
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("gives the sections of a wheel"));
  }
}

} // namespace
