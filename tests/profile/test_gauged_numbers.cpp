#include "bem_contact/profile/profile_findings.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "bem_contact/profile/worn/gauged_numbers.hpp"
#include "sampled.hpp"
#include "warnings.hpp"
#include "worn_points.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace bem_contact {
namespace {

/// EN 13715: the face is an arc of 13 mm about (-26.210665, 16.446), the shoulder one of 20 mm about
/// (-58.558326, 8.834924), the tip is 28 mm high.
TEST(FlangeNumbers, OfS1002AreThoseOfItsArcs) {
  const auto found = flange_numbers(standard_profile("S1002"), 70);
  ASSERT_TRUE(found);
  const double face = -26.210665 - std::sqrt(13.0 * 13 - 6.446 * 6.446),
               shoulder = -58.558326 + std::sqrt(20.0 * 20 - std::pow(26 - 8.834924, 2));
  EXPECT_NEAR(found->Sh, 28, 1e-4);
  EXPECT_NEAR(found->Sd, 70 + face, 1e-4);
  EXPECT_NEAR(found->qR, face - shoulder, 1e-4);
  EXPECT_NEAR(found->Sd, 32.5, 1e-3); // as its name says
  EXPECT_NEAR(found->qR, 10.8, 0.01);
}

TEST(FlangeNumbers, AreWhatTheNamesOfTheStandardSay) {
  for (const char* tread : {"S1002", "1/40"})
    for (const double height : {28.0, 30.0, 32.0})
      for (const double thickness : {28.5, 30.5, 32.5}) {
        const auto name = fmt::format("{} h{:g} e{:g} 6.7%", tread, height, thickness);
        const auto found = flange_numbers(standard_profile(name), 70);
        ASSERT_TRUE(found) << name;
        EXPECT_NEAR(found->Sd, thickness, 2e-3) << name;
        // Of a thinner flange the front stands farther back: the arcs of 12 mm at the tip meet in a ridge.
        const double half = (32.5 - thickness) / 2, ridge = height - 12 + std::sqrt(12.0 * 12 - half * half);
        EXPECT_NEAR(found->Sh, ridge, 2e-3) << name;
      }
}

TEST(FlangeNumbers, OfAMeasuredWheelFollowItsWear) {
  const SaidWarnings quiet;
  const auto numbers = [](const std::vector<Point2>& points) {
    const MeasuredProfile p = parse_measured_profile(as_columns(points), "w.whl", ProfileKind::wheel);
    return *findings_of(p, ProfileKind::wheel, {}).flange;
  };
  std::vector<Point2> points = worn_points("S1002", {}, {}, 0.2);
  const FlangeNumbers as_new = numbers(points);
  EXPECT_NEAR(as_new.qR, 10.794, 2e-3);
  for (Point2& p : points)
    if (p.y > -40 && p.z < 9)
      p.z += 1.0; // the tread is lower by 1 mm, and the flange higher
  EXPECT_NEAR(numbers(points).Sh, as_new.Sh - 1, 1e-3);
}

TEST(FlangeNumbers, OfATreadAloneAreNone) {
  std::vector<Point2> points = worn_points("S1002", {}, {}, 0.2);
  std::erase_if(points, [](Point2 p) { return p.y < -40; });
  EXPECT_FALSE(flange_numbers(ProfileCurve::through_points("tread", points), 70));
}

/// EN 13674-1: the corner of 60E1 is an arc of 13 mm about (23.0160, 14.9491) on either side.
struct Corner {
  double y = -23.0160, z = 14.9491, radius = 13;

  double face(double depth) const { return y - std::sqrt(radius * radius - std::pow(z - depth, 2)); }
  /// How far the line from a point reaches before the arc, at 45 degrees.
  double reach(Point2 from) const {
    const Point2 to{y - from.y, z - from.z};
    const double along = (to.y + to.z) / std::sqrt(2.0), off = (to.y - to.z) / std::sqrt(2.0);
    return along - std::sqrt(radius * radius - off * off);
  }
};

TEST(HeadWear, OfARailThatIsLowerAndNarrowerIsThatOfItsArcs) {
  const ProfileCurve rail = standard_profile("60E1");
  const Corner as_new;
  for (const Point2 worn : {Point2{0, 0}, Point2{0, 2}, Point2{3, 0}, Point2{1, 1.5}}) {
    const NominalPlace place{{-worn.y, -worn.z}, 0}; // the steel that was there
    const auto found = head_wear(rail, rail, place);
    ASSERT_TRUE(found);
    const Corner now{as_new.y + worn.y, as_new.z + worn.z};
    const Point2 corner{as_new.face(14), 0};
    if (worn.y == 0) {
      EXPECT_NEAR(found->W1, worn.z, 1e-9);
    }
    EXPECT_NEAR(found->W2, now.face(14) - as_new.face(14), 1e-5) << worn.y << ' ' << worn.z;
    EXPECT_NEAR(found->W3, now.reach(corner) - as_new.reach(corner), 1e-5) << worn.y << ' ' << worn.z;
  }
}

TEST(HeadWear, IsFoundWhereverTheRailStandsInItsFile) {
  const SaidWarnings quiet;
  for (const double turn : {0.0, -0.025}) {
    const auto points = worn_points("60E1", {{1.0, 0, 12}}, {{-7, 3}, turn}, 0.3);
    const MeasuredProfile p = parse_measured_profile(as_columns(points), "r.ban", ProfileKind::rail);
    const auto wear = findings_of(p, ProfileKind::rail, {}).wear;
    ASSERT_TRUE(wear);
    EXPECT_NEAR(wear->W1, 1.0, 0.02);
    EXPECT_NEAR(wear->W2, 0, 0.02);
  }
}

TEST(HeadWear, OfARailThatEndsAboveTheGaugeIsNone) {
  std::vector<Point2> points = worn_points("60E1", {}, {}, 0.3);
  std::erase_if(points, [](Point2 p) { return p.z > 10; });
  EXPECT_FALSE(head_wear(ProfileCurve::through_points("top", points), standard_profile("60E1"), {}));
}

} // namespace
} // namespace bem_contact
