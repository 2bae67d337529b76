#include "bem_contact/base/error.hpp"
#include "bem_contact/geometry/contact_search.hpp"
#include "bem_contact/geometry/rail_height.hpp"
#include "bem_contact/geometry/rail_rows.hpp"
#include "bem_contact/geometry/undeformed_distance.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/profile/sections/wheel_surface.hpp"
#include "tests/geometry/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace {

using namespace bem_contact;
using shapes::standing;
using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr double nominal_radius = 460, full_turn = 2 * std::numbers::pi;

ProfileCurve wheel_profile() {
  return named_profile("S1002", ProfileKind::wheel);
}

/// S1002 as points, all of it nearer to the axle by `depth`.
ProfileCurve ground_wheel(double depth) {
  std::vector<Point2> points;
  for (const CurvePoint& p : points_along(wheel_profile(), 0.25))
    points.push_back({p.position.y, p.position.z - depth});
  return ProfileCurve::through_points("S1002 as points", points);
}

/// `depth` of an angle, at so many angles round the wheel from `first` on.
template <class Depth>
std::shared_ptr<const SectionedSurface> wheel_by(int count, double first, double apart, const Depth& depth) {
  std::vector<BodySection> sections;
  for (int i = 0; i < count; ++i)
    sections.push_back({first + i * apart, ground_wheel(depth(first + i * apart))});
  return std::make_shared<const SectionedSurface>(wheel_surface(std::move(sections)));
}

struct Lowered {
  WheelOnRail pair;
  TouchPoint touch;

  Lowered(const WheelsetPosition& position, const ProfileCurve& wheel,
          const std::shared_ptr<const SectionedSurface>& surface = {})
      : pair(place(position, named_profile("60E1", ProfileKind::rail), wheel, {}, surface)),
        touch(lower_to_touch(pair).front()) {}
  double height() const { return pair.wheel_pose.origin.z; }
  /// Undeformed distance about a point.
  std::vector<double> gaps(const TouchPoint& about) const {
    std::vector<double> s, x;
    for (int i = -8; i <= 8; ++i) {
      s.push_back(about.rail_s + 0.7 * i);
      x.push_back(about.x + 1.1 * i);
    }
    const std::vector<ContactRow> rows = rail_rows(pair, s, 0.1);
    const ContactLocus locus(pair);
    return undeformed_distance(pair, rows_on_locus(locus, rows), rows, x);
  }
};

TEST(WheelSections, ThatAreAllEqualAreTheProfile) {
  std::vector<BodySection> sections;
  for (const double angle : {-2.9, -1.0, 0.3, 0.5, 2.0})
    sections.push_back({angle, wheel_profile()});
  const auto wheel = std::make_shared<const SectionedSurface>(wheel_surface(sections));
  for (const auto& [lateral, yaw] : {std::pair{0.0, 0.0}, {3.0, 0.01}, {6.0, -0.005}}) {
    const Lowered round(standing(lateral, yaw), wheel_profile()),
        given(standing(lateral, yaw, 700), wheel_profile(), wheel);
    EXPECT_NEAR(given.height(), round.height(), 1e-9) << lateral;
    EXPECT_NEAR(given.touch.rail_s, round.touch.rail_s, 1e-5) << lateral;
    const std::vector<double> a = round.gaps(round.touch), b = given.gaps(round.touch);
    for (std::size_t i = 0; i < a.size(); ++i)
      EXPECT_NEAR(a[i], b[i], 1e-9) << lateral << " " << i;
  }
}

/// Waves by sections are those of wheel.polygon, by the fourth power of the distance of sections.
TEST(WheelSections, OfWavesConvergeToThem) {
  const auto waves = [](double angle) { return -0.05 * std::cos(6 * (angle - 0.2)); };
  WheelsetPosition position = standing(1, 0.004, 120);
  position.uneven.polygon = {{6}, {0.05}, {0.2}};
  const Lowered polygon(position, ground_wheel(0));
  position.uneven.polygon = {};
  const auto error_of = [&](int count) {
    const Lowered sections(position, ground_wheel(0), wheel_by(count, -3, full_turn / count, waves));
    double error = std::abs(sections.height() - polygon.height());
    const std::vector<double> a = polygon.gaps(polygon.touch), b = sections.gaps(polygon.touch);
    for (std::size_t i = 0; i < a.size(); ++i)
      error = std::max(error, std::abs(a[i] - b[i]));
    return error;
  };
  const double coarse = error_of(48), fine = error_of(96);
  EXPECT_LT(coarse, 1e-3);
  EXPECT_LT(10 * fine, coarse);
}

/// A worn flat between sections about it; the rest of the wheel is round although it has no section.
TEST(WheelSections, OfAFlatAreTheFlat) {
  WheelsetPosition position = standing(0, 0, 12);
  position.uneven.flat = {.depth = 0.5, .rounding = 30, .angle = 0.01};
  const UnevenSurfaces flat(position.uneven, nominal_radius);
  const auto depth = [&](double angle) { return flat.depth(angle - 12 / nominal_radius); };
  const Lowered given(position, ground_wheel(0));
  position.uneven.flat = {};
  position.uneven.sections_angle = 0.3;
  const auto sections = wheel_by(121, -0.15 + 0.01, 0.0025, [&](double angle) { return depth(angle); });
  WheelsetPosition turned_back = position;
  turned_back.uneven.along = position.uneven.along + 0.3 * nominal_radius;
  const Lowered by_sections(turned_back, ground_wheel(0), sections);
  EXPECT_NEAR(by_sections.height(), given.height(), 2e-5);
  EXPECT_NEAR(by_sections.touch.x, given.touch.x, 0.05);
  const std::vector<double> a = given.gaps(given.touch), b = by_sections.gaps(given.touch);
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_NEAR(a[i], b[i], 1e-4) << i;
  WheelsetPosition far = position;
  far.uneven.along = 900;
  EXPECT_NEAR(Lowered(far, ground_wheel(0), sections).height(),
              Lowered(standing(0, 0), ground_wheel(0)).height(), 1e-6);
}

/// A wheel whose tread is worn hollow on one side of it: the height that brute force finds over all points.
TEST(WheelSections, OfOtherShapesTouchWhereBruteForceTouches) {
  std::vector<BodySection> sections;
  for (int i = 0; i < 24; ++i) {
    const double angle = full_turn * i / 24 - 3;
    std::vector<Point2> points;
    for (const CurvePoint& p : points_along(wheel_profile(), 0.25)) {
      const Point2 q = p.position;
      points.push_back({q.y, q.z - 0.2 * (1 + std::cos(2 * angle)) * std::exp(-q.y * q.y / 300)});
    }
    sections.push_back({angle, ProfileCurve::through_points("hollow", points)});
  }
  const auto wheel = std::make_shared<const SectionedSurface>(wheel_surface(sections));
  for (const double along : {0.0, 350.0}) {
    const WheelsetPosition position = standing(2, 0.006, along);
    WheelOnRail pair =
        place(position, named_profile("60E1", ProfileKind::rail), sections[0].profile, {}, wheel);
    const double before = pair.wheel_pose.origin.z;
    const WheelFrame frame = pair.wheel_frame();
    const RailHeight height(pair);
    int near = 0;
    double least = std::numeric_limits<double>::infinity();
    for (double theta = -0.08; theta < 0.08; theta += 5e-4)
      for (double t = wheel->nodes().front(); t < wheel->nodes().back(); t += 0.1) {
        const Point2 p = wheel->at(std::remainder(theta + along / nominal_radius, full_turn), t).position;
        const auto at = [&](int i) {
          return frame.centre[i] + p.y * frame.axle[i] +
                 (nominal_radius + p.z) *
                     (std::cos(theta) * frame.down[i] + std::sin(theta) * frame.forward[i]);
        };
        if (const auto h = height.at(at(1), near))
          least = std::min(least, h->z - at(2));
      }
    lower_to_touch(pair);
    EXPECT_NEAR(pair.wheel_pose.origin.z - before, least, 2e-4) << along; // steps of 0.1 and 0.25 mm
    EXPECT_LT(pair.wheel_pose.origin.z - before, least + 1e-6) << along;
  }
}

/// CONTACT's way 2: a section that stands alone is seen at 4/6 of its height, and its neighbours at 1/6.
TEST(WheelSections, AreSmoothedWhereTheyAreApproximated) {
  std::vector<BodySection> sections;
  for (int i = 0; i < 30; ++i)
    sections.push_back({-3 + 0.2 * i, ground_wheel(i == 14 ? 0.6 : 0)});
  const SectionedSurface surface = wheel_surface(sections, true), through = wheel_surface(sections);
  const double t = 0.4 * surface.nodes().back(), round = through.at(-3, t).position.z;
  EXPECT_NEAR(surface.at(-3, t).position.z, round, 1e-7);
  EXPECT_NEAR(surface.at(-3 + 0.2 * 14, t).position.z - round, -0.4, 1e-7);
  EXPECT_NEAR(surface.at(-3 + 0.2 * 13, t).position.z - round, -0.1, 1e-7);
  EXPECT_NEAR(through.at(-3 + 0.2 * 14, t).position.z - round, -0.6, 1e-7);
  EXPECT_GT(surface.at(-3 + 0.2 * 12.5, t).position.z - round, -0.1); // no swing beside it
  EXPECT_LE(surface.at(-3 + 0.2 * 11.5, t).position.z - round, 1e-7);
}

TEST(WheelSections, SayWhatIsWrong) {
  const auto message = [](std::vector<BodySection> sections) {
    try {
      wheel_surface(std::move(sections));
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  const ProfileCurve s = wheel_profile();
  EXPECT_THAT(message({{0, s}}), HasSubstr("A wheel has one section"));
  EXPECT_THAT(message({{0, s}, {1, s}, {0.5, s}}),
              AllOf(HasSubstr("Section 3"), HasSubstr("at 0.5 rad"), HasSubstr("out of order")));
  EXPECT_THAT(message({{-180, s}, {0, s}, {180, s}}), HasSubstr("a turn has 6.2832 rad"));
  const Lowered off(standing(0, 0), s); // a roller takes no such wheel
  WheelsetPosition rig = standing(0, 0);
  rig.roller_radius = 500;
  EXPECT_THROW(place(rig, named_profile("60E1", ProfileKind::rail), s, {},
                     std::make_shared<const SectionedSurface>(wheel_surface({{0, s}, {1, s}}))),
               InputError);
}

} // namespace
