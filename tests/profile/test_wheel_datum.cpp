#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/wheel_datum.hpp"
#include "sampled.hpp"
#include "tests/base/message.hpp"
#include "tests/profile/curves.hpp"
#include "warnings.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace bem_contact {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using Points = std::vector<Point2>;

Points moved(double by) {
  Points points = sampled_curve(standard_profile("S1002"), 0.25);
  for (Point2& p : points)
    p.y += by;
  return points;
}

struct Read {
  std::string said;
  double tip = 0; ///< y of the flange's tip
};

Read read(const std::string& text, const ProfileReading& reading = {}) {
  const SaidWarnings warnings;
  const ProfileCurve curve = parse_profile(text, "p.txt", ProfileKind::wheel, reading);
  return {warnings.text(), flange_tip(sampled_curve(curve, 0.05))->y};
}

TEST(WheelDatum, AFlangeBackAtZeroIsRecognisedAndSaid) {
  const Read found = read(as_columns(moved(70)));
  EXPECT_NEAR(found.tip, -55, 0.1);
  EXPECT_THAT(found.said, AllOf(HasSubstr("the tip of the flange is at y = 15"),
                                HasSubstr("the back of the flange"), HasSubstr("wheel.flange_back = 0")));
}

TEST(WheelDatum, SaidByTheKeyItIsNoSurprise) {
  const Read said = read(as_columns(moved(70)), {.flange_back = 0});
  EXPECT_NEAR(said.tip, -55, 0.1);
  EXPECT_THAT(said.said, IsEmpty());
  EXPECT_NEAR(read(as_columns(moved(47)), {.flange_back = -23}).tip, -55, 0.1);
}

/// The key counts in the file's own direction of y, whatever is mirrored on the way.
TEST(WheelDatum, IsMirroredWithTheFile) {
  Points mirrored = moved(70);
  for (Point2& p : mirrored)
    p.y = -p.y;
  EXPECT_NEAR(read(as_columns(mirrored), {.flange_back = 0}).tip, -55, 0.1);
  for (Point2& p : mirrored)
    p.y += 12;
  EXPECT_NEAR(read(as_columns(mirrored), {.mirror = true, .flange_back = 12}).tip, -55, 0.1);
  EXPECT_NEAR(read(as_columns(mirrored), {.flange_back = 12}).tip, -55, 0.1);
}

TEST(WheelDatum, OneInBetweenIsWarnedOf) {
  const Read odd = read(as_columns(moved(30)));
  EXPECT_NEAR(odd.tip, -25, 0.1);
  EXPECT_THAT(odd.said, AllOf(HasSubstr("y = -24.9 mm"), HasSubstr("30 mm beside its place"),
                              HasSubstr("wheel.flange_back")));
}

TEST(WheelDatum, AnAbsolutePlaceKeepsTheOrigin) {
  const Read kept = read(as_columns(moved(70)), {.keep_origin = true});
  EXPECT_NEAR(kept.tip, 15, 0.1);
  EXPECT_THAT(kept.said, IsEmpty());
}

TEST(WheelDatum, AHeightAtTheTapeCircleIsSaid) {
  Points points = moved(0);
  for (Point2& p : points)
    p.z -= 28;
  EXPECT_THAT(read(as_columns(points)).said, HasSubstr("at the tape circle z is -28 mm"));
}

TEST(WheelDatum, ARollerHasNoFlange) {
  Points roller; // crowned, radius 60 mm, 80 mm wide
  for (double y = 40; y >= -40; y -= 0.5)
    roller.push_back({y, std::sqrt(3600 - y * y) - 60});
  EXPECT_FALSE(flange_tip(roller));
  EXPECT_TRUE(flange_tip(moved(0)));
}

// ---------------------------------------------------------------- orientation

Points bowl(double sign) { // 60 mm wide, radius 50 mm; sign > 0: its middle is highest where z points down
  Points points;
  for (double y = -30; y <= 30; y += 0.5)
    points.push_back({y, sign * (50 - std::sqrt(2500 - y * y))});
  return points;
}

double curvature_at_middle(const std::string& text, ProfileKind kind, const ProfileReading& reading = {}) {
  const ProfileCurve curve = parse_profile(text, "p.txt", kind, reading);
  return curve.at((curve.s_begin() + curve.s_end()) / 2).curvature;
}

TEST(Orientation, OfAGrooveIsWhatTheSceneSays) {
  const SaidWarnings warnings;
  const std::string groove = as_columns(bowl(-1)); // z down: the middle is lowest
  EXPECT_NEAR(curvature_at_middle(groove, ProfileKind::rail, {.profile_z = ProfileZ::down}), -1.0 / 50, 1e-4);
  EXPECT_THAT(warnings.text(), IsEmpty());
  EXPECT_NEAR(curvature_at_middle(groove, ProfileKind::rail, {.profile_z = ProfileZ::up}), 1.0 / 50, 1e-4);
  EXPECT_NEAR(curvature_at_middle(groove, ProfileKind::rail), 1.0 / 50, 1e-4);
  EXPECT_THAT(warnings.text(), HasSubstr("profile_z"));
}

std::string simpack(const Points& points, int type) {
  return fmt::format(
      "header.begin\n type = {}\nheader.end\nspline.begin\npoint.begin\n{}point.end\nspline.end\n", type,
      as_columns(points));
}

TEST(Orientation, OfAFormatThatStatesItsAxesIsNotTurned) {
  const SaidWarnings warnings;
  EXPECT_NEAR(curvature_at_middle(simpack(bowl(-1), 0), ProfileKind::rail), -1.0 / 50, 1e-4);
  EXPECT_NEAR(curvature_at_middle(simpack(bowl(-1), 1), ProfileKind::wheel), 1.0 / 50, 1e-4);
  EXPECT_NEAR(curvature_at_middle(simpack(bowl(1), 1), ProfileKind::wheel), -1.0 / 50, 1e-4);
  EXPECT_THAT(warnings.text(), IsEmpty());
  Points up = moved(0);
  for (Point2& p : up)
    p.z = -p.z;
  parse_profile(simpack(up, 1), "p.prw", ProfileKind::wheel);
  EXPECT_THAT(warnings.text(),
              AllOf(HasSubstr("the flange points up"), HasSubstr("profile_z = \"up\" turns it")));
}

TEST(Orientation, MirrorTurnsARail) {
  Points rail = sampled_curve(standard_profile("60E1"), 0.5);
  std::erase_if(rail, [](Point2 p) { return p.y > 20; });
  const ProfileCurve curve = parse_profile(as_columns(rail), "p.txt", ProfileKind::rail, {.mirror = true});
  EXPECT_NEAR(curve.at(curve.s_begin()).position.y, -20, 0.5);
  EXPECT_GT(curve.at(curve.s_end()).position.y, 30);
}

TEST(Orientation, MirrorThatPutsTheFlangeOutsideIsRefused) {
  EXPECT_THAT(
      message_of([] { parse_profile(as_columns(moved(0)), "p.txt", ProfileKind::wheel, {.mirror = true}); }),
      HasSubstr("mirror = true puts the flange on the field side"));
}

// ---------------------------------------------------------------- units

std::string scaled(double factor, double by = 0) {
  Points points = moved(by);
  for (Point2& p : points)
    p = factor * p;
  return as_columns(points);
}

TEST(Unit, CentimetresAndInchesAreAskedAbout) {
  EXPECT_THAT(message_of([] { read(scaled(0.1)); }),
              AllOf(HasSubstr("13 mm wide"), HasSubstr("in centimetres it would be 130 mm"),
                    HasSubstr("unit = \"cm\".")));
  EXPECT_THAT(message_of([] { read(scaled(1 / 25.4)); }),
              AllOf(HasSubstr("5.118 mm wide"), HasSubstr("in inches it would be 130 mm"),
                    HasSubstr("unit = \"inch\".")));
  EXPECT_NEAR(read(scaled(0.1), {.unit = ProfileUnit::cm}).tip, -55, 0.1);
  EXPECT_NEAR(read(scaled(1 / 25.4), {.unit = ProfileUnit::inch}).tip, -55, 0.1);
}

} // namespace
} // namespace bem_contact
