#include "bem_contact/base/error.hpp"
#include "bem_contact/geometry/contact_search.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/profile/sections/section_spline.hpp"
#include "bem_contact/profile/sections/slices_file.hpp"
#include "bem_contact/profile/sections/wheel_surface.hpp"
#include "tests/base/temporary_folder.hpp"
#include "tests/geometry/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <numbers>
#include <string>

/// What people give as sections, right or not.
namespace section_checks {

using namespace bem_contact;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

std::string message_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing";
}

/// 60E1 as points, moved.
ProfileCurve rail_at(Point2 by) {
  static const ProfileCurve standard = named_profile("60E1", ProfileKind::rail);
  std::vector<Point2> points;
  for (const CurvePoint& p : points_along(standard, 0.5))
    points.push_back({p.position.y + by.y, p.position.z + by.z});
  return ProfileCurve::through_points("60E1 as points", points);
}

ProfileCurve wheel_ground_by(double depth) {
  std::vector<Point2> points;
  for (const CurvePoint& p : points_along(named_profile("S1002", ProfileKind::wheel), 0.5))
    points.push_back({p.position.y, p.position.z - depth});
  return ProfileCurve::through_points("ground", points);
}

/// A rail that leads to the side, as a wing rail does, is no mirror image, although a symmetric one fits so
/// too. All lines go straight with it.
TEST(SectionChecks, ARailThatLeadsToTheSideIsItself) {
  for (const double aside : {5.0, 20.0, 45.0, 80.0}) {
    const SectionedSurface made({{0, rail_at({-0.5 * aside, 0})}, {900, rail_at({0.5 * aside, -3})}});
    const auto [from, to] = made.extent(450);
    EXPECT_GT(to - from, 120) << aside;
    for (double t = from + 2; t < to - 2; t += 3.1) {
      const Point2 off = made.at(900, t).position - made.at(0, t).position;
      EXPECT_NEAR(off.y, aside, 0.02) << aside << " " << t;
      EXPECT_NEAR(off.z, -3, 0.02) << aside << " " << t;
    }
  }
}

/// A left rail among right ones is told by what wear and inclination leave of its asymmetry.
TEST(SectionChecks, ALeftRailAmongRightOnesIsNamed) {
  const auto seen = [](double lean, double wear, double side) {
    std::vector<Point2> points;
    for (const CurvePoint& p : points_along(rail_at({0, 0}), 0.5)) {
      const Point2 worn =
          p.position + wear * std::exp(-std::pow((p.position.y + 30) / 8, 2)) * Point2{1, 0.5};
      points.push_back(turned(worn, lean));
    }
    if (side < 0)
      std::ranges::reverse(points);
    for (Point2& p : points)
      p.y *= side;
    return ProfileCurve::through_points(side < 0 ? "left" : "right", points);
  };
  for (const auto& [lean, wear] : {std::pair{0.025, 0.0}, {0.0, 1.0}, {-0.05, 3.0}}) {
    EXPECT_THAT(message_of([&, lean = lean, wear = wear] {
                  SectionedSurface({{0, seen(lean, wear, 1)}, {300, seen(lean, wear, -1)}});
                }),
                AllOf(HasSubstr("Section 2 ('left' at 300 mm)"), HasSubstr("mirror image")))
        << lean << " " << wear;
    EXPECT_EQ(
        message_of([&, lean = lean, wear = wear] { // one that wears and turns more and more
          SectionedSurface({{0, seen(0, 0, 1)}, {300, seen(lean, wear, 1)}, {600, seen(0, 0.5 * wear, 1)}});
        }),
        "nothing");
  }
}

TEST(SectionChecks, NeighboursThatNoWheelRollsOverAreNamed) {
  EXPECT_THAT(
      message_of([] {
        SectionedSurface({{0, rail_at({0, 0})}, {0.001, rail_at({0.5, -0.5})}});
      }),
      AllOf(HasSubstr("at 0.001 mm"), HasSubstr("lies far off the one before it"), HasSubstr("at 0 mm")));
  EXPECT_THAT(
      message_of([] {
        wheel_surface({{0, wheel_ground_by(0)}, {1e-4, wheel_ground_by(0.5)}, {0.2, wheel_ground_by(0)}});
      }),
      AllOf(HasSubstr("0.0001 rad"), HasSubstr("lies far off")));
  const ProfileCurve head = rail_at({0, 0});
  EXPECT_EQ(message_of([&] { // a nose that rises 1:5 is steep, and no fault
              SectionedSurface({{0, rail_at({0, 30})}, {100, rail_at({0, 10})}, {150, rail_at({0, 0})}});
            }),
            "nothing");
}

/// Where no place of contact is found, the message says where the wheel is.
TEST(SectionChecks, WhatTheWheelDoesNotFindNamesThePlace) {
  const auto rail = std::make_shared<const RailSurfaces>(
      std::vector{RailSurfaces::Body{std::make_shared<const SectionedSurface>(
          std::vector<BodySection>{{0, rail_at({0, 0})}, {500, rail_at({200, 0})}})}});
  EXPECT_THAT(
      message_of([&] {
        place(shapes::standing(0, 0, 400), rail_at({0, 0}), named_profile("S1002", ProfileKind::wheel), rail);
      }),
      HasSubstr("At 400 mm along the track, between the rail's sections at 0 and 500 mm: "));
}

/// CONTACT's way to close a wheel: sections beyond half a turn at both ends, which say the same twice.
TEST(SectionChecks, AWheelMayBeGivenBeyondItsTurn) {
  const auto depth = [](double angle) { return 0.05 * (1 + std::cos(3 * angle)); };
  std::vector<BodySection> beyond, once;
  for (int i = -16; i <= 16; ++i) {
    beyond.push_back({0.2 * i, wheel_ground_by(depth(0.2 * i))});
    if (0.2 * i < -3.2 + 2 * std::numbers::pi - 1e-4)
      once.push_back(beyond.back());
  }
  const SectionedSurface a = wheel_surface(beyond), b = wheel_surface(once);
  const double t = 0.4 * a.nodes().back();
  for (const double angle : {-3.1, -1.0, 0.3, 3.0, 3.14})
    EXPECT_NEAR(a.at(angle, t).position.z, b.at(angle, t).position.z, 1e-12) << angle;
  beyond.back().profile = wheel_ground_by(1);
  EXPECT_THAT(message_of([&] { wheel_surface(beyond); }),
              AllOf(HasSubstr("Section 'ground' at 3.2 rad"), HasSubstr("a turn before")));
  // The end of the turn is its beginning.
  EXPECT_THAT(message_of([&] {
                wheel_surface({{0, wheel_ground_by(0)},
                               {2, wheel_ground_by(0)},
                               {4, wheel_ground_by(0)},
                               {2 * std::numbers::pi, wheel_ground_by(0.5)}});
              }),
              HasSubstr("a turn before"));
}

TEST(SectionChecks, AWheelsAnglesMayBeginAnywhere) {
  const double turns = 2 * std::numbers::pi * 300;
  const SectionedSurface near = wheel_surface({{-1, wheel_ground_by(0)}, {1, wheel_ground_by(0.2)}}),
                         far = wheel_surface(
                             {{turns - 1, wheel_ground_by(0)}, {turns + 1, wheel_ground_by(0.2)}});
  EXPECT_EQ(near.places().size(), far.places().size());
  EXPECT_NEAR(near.at(0.3, 50).position.z, far.at(0.3, 50).position.z, 1e-9);
}

/// The textbook's equations (de Boor 1978), as a dense matrix would have them: slopes of cubics are theirs,
/// wherever the places are, and the third derivative does not jump behind the first interval.
TEST(SectionSpline, OfACubicIsTheCubic) {
  const auto cubic = [](double x) { return 2 - x + 0.3 * x * x - 0.7 * x * x * x; };
  const auto slope = [](double x) { return -1 + 0.6 * x - 2.1 * x * x; };
  for (const int count : {4, 5, 9, 200}) {
    std::vector<double> x, y;
    for (int i = 0; i < count; ++i)
      x.push_back(0.1 * i + 0.04 * std::sin(5.0 * i)), y.push_back(cubic(x.back()));
    const std::vector<double> slopes = SectionSpline(x).slopes(y);
    for (int i = 0; i < count; ++i)
      EXPECT_NEAR(slopes[i], slope(x[i]), 1e-10 * (1 + std::abs(slope(x[i])))) << count << " " << i;
  }
  EXPECT_THAT(SectionSpline({0, 2}).slopes<double>({1, 5}), ::testing::ElementsAre(2, 2));
  const std::vector<double> parabola = SectionSpline({0, 1, 3}).slopes<double>({0, 1, 9});
  for (const int x : {0, 1, 3})
    EXPECT_NEAR(parabola[x == 3 ? 2 : x], 2 * x, 1e-14);
}

/// Thousands of sections, as of a scan: what each costs does not grow with their number.
TEST(SectionChecks, ThousandsOfSectionsAreASurface) {
  std::vector<BodySection> sections;
  const ProfileCurve arc = shapes::rail_arc(100, 0.1);
  for (int i = 0; i < 4000; ++i)
    sections.push_back({0.5 * i, arc, {arc.s_begin(), arc.s_end()}});
  const SectionedSurface made(std::move(sections));
  EXPECT_NEAR(made.at(1000.2, 5).by_u.z, 0, 1e-12);
}

TEST(SectionChecks, CountsOfASlicesFileAreHeld) {
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& text) {
    std::ofstream(folder.path() / "r.slcs") << text;
    return message_of([&] { read_slices(folder.path() / "r.slcs"); });
  };
  const std::string two = " 0. '60E1'\n 9. '60E1'\n";
  EXPECT_EQ(refused("0 1\n2 N\n0 0 0\n1\n" + two + "and a remark\n"), "nothing");
  EXPECT_THAT(refused("0 1\n0 N\n0 0 0\n1\n"),
              AllOf(HasSubstr("r.slcs:2"), HasSubstr("number of sections is 0")));
  EXPECT_THAT(refused("0 1\n1 N\n0 0 0\n1\n" + two),
              AllOf(HasSubstr("r.slcs:6"), HasSubstr("goes on with '9.'"), HasSubstr("counts 1 sections")));
  EXPECT_THAT(refused("0 1\n2 N\n2 0 0\n1\n" + two + "0. 0. 40. 999.\n9. 0. 40. 999.\n"),
              AllOf(HasSubstr("r.slcs:7"), HasSubstr("'999.' follows the features"), HasSubstr("counts 2")));
  EXPECT_THAT(refused("0,5 1\n2 N\n0 0 0\n1\n" + two),
              AllOf(HasSubstr("r.slcs:1"), HasSubstr("'0,5' may be one number or two")));
  EXPECT_EQ(refused("0., 1.\n2 N\n0,0,0\n1\n" + two), "nothing"); // lists with commas
  EXPECT_THAT(refused("0 1e300\n2 N\n0 0 0\n1\n" + two), AllOf(HasSubstr("r.slcs:6"), HasSubstr("9e+300")));
  EXPECT_EQ(refused("0 1\n2 N\n3 1 2\n1\n" + two + "-3\n-1 3\n0 0 9 99\n9 0 9 99\n"), "nothing");
  EXPECT_THAT(refused("0 1\n2 N\n3 1 0\n1\n" + two + "9\n0 0 9 99\n9 0 9 99\n"), HasSubstr("r.slcs:7"));
  const auto used = [&](const std::string& name) {
    std::ofstream(folder.path() / "r.slcs") << "0 1\n2\n0\n1\n0 '" << name << "'\n9 '" << name << "'\n";
    return message_of([&] { sections_of_slices(folder.path() / "r.slcs", ProfileKind::rail, {}); });
  };
  EXPECT_THAT(used("r.slcs"), AllOf(HasSubstr("r.slcs:5"), HasSubstr("is a slices file")));
  std::filesystem::create_directory(folder.path() / "all");
  std::ofstream points(folder.path() / "all" / "a.prr.txt");
  for (const CurvePoint& p : points_along(named_profile("60E1", ProfileKind::rail), 0.5))
    points << p.position.y << " " << p.position.z << "\n";
  points.close();
  EXPECT_THAT(used("all\\a.prr.txt"), Not(HasSubstr("Unknown profile"))); // as on Windows
}

} // namespace section_checks
