#include "bem_contact/profile/profile_findings.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/profile/worn/head_symmetry.hpp"
#include "bem_contact/profile/worn/like_standard.hpp"
#include "sampled.hpp"
#include "warnings.hpp"
#include "worn_points.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>

namespace bem_contact {
namespace {

using Points = std::vector<Point2>;

/// A head of no standard: flank, corner, shoulder, top, and their mirror image.
struct Head {
  double flank_slope, corner, shoulder, top; ///< 1; radii, mm
  double corner_from, shoulder_from;         ///< inclinations where they end, rad
};
constexpr Head wide_head{0.03, 11, 70, 250, 0.35, 0.06};
constexpr Head small_head{0, 10, 60, 180, 0.3, 0.07};

ProfileCurve curve_of_head(const Head& head) {
  std::vector<CurvePiece> pieces;
  Point2 at{};
  double delta = -std::numbers::pi / 2 + head.flank_slope;
  const auto add = [&](double radius, double to) {
    const double length = radius > 0 ? radius * (to - delta) : 14;
    pieces.push_back(arc_piece(at, delta, radius > 0 ? 1 / radius : 0, length));
    at = point_on(pieces.back(), length).position;
    delta = to;
  };
  add(0, delta);
  add(head.corner, -head.corner_from);
  add(head.shoulder, -head.shoulder_from);
  add(head.top, head.shoulder_from);
  add(head.shoulder, head.corner_from);
  add(head.corner, std::numbers::pi / 2 - head.flank_slope);
  add(0, delta);
  ProfileCurve curve = ProfileCurve::from_pieces("head", pieces);
  const Point2 top = curve.at((curve.s_begin() + curve.s_end()) / 2).position;
  pieces.front().start = pieces.front().start - top; // the others follow
  pieces.front().middle = pieces.front().middle - top;
  return ProfileCurve::from_pieces("head", pieces);
}

/// Wear as trains leave it: top, gauge corner, both.
std::vector<std::vector<Bump>> usual_wear(double corner_at, double width = 10) {
  return {{}, {{0.3, 0, 10}}, {{0.6, -corner_at, width}}, {{0.6, -corner_at, width}, {0.3, 0, 10}}};
}

double inclination(const Points& points) {
  const SaidWarnings quiet;
  const MeasuredProfile p = parse_measured_profile(as_columns(points), "rail.txt", ProfileKind::rail);
  return rail_inclination(p.curve, p.scatter_left());
}

TEST(RailInclination, OfAHeadOfNoStandardIsToldByItsSymmetry) {
  for (const Head& head : {wide_head, small_head}) {
    const ProfileCurve curve = curve_of_head(head);
    const double corner_at = -curve.s_begin() - 14 - head.corner * 0.7;
    for (const std::vector<Bump>& wear : usual_wear(corner_at, 0.7 * head.corner))
      for (const double part : {0.0, 0.025, 0.05}) {
        const double found = inclination(noisy(worn_points(curve, wear, {{-7, 0.2}, -part}, 0.4), 0.003, 1));
        EXPECT_NEAR(found, part, wear.empty() ? 3e-4 : 5e-3) << head.corner << ' ' << wear.size();
        EXPECT_EQ(found == 0, part == 0) << head.corner << ' ' << wear.size();
      }
  }
}

TEST(RailInclination, OfAStandardWornOnTopAndAtTheCornerIsTold) {
  for (const char* name : {"60E1", "60E2", "54E1", "46E3"})
    for (const std::vector<Bump>& wear : usual_wear(33))
      for (const double part : {0.0, 0.025, 0.05})
        EXPECT_NEAR(inclination(worn_points(name, wear, {{-7, 0}, -part}, 0.5)), part, 5e-3)
            << name << ' ' << wear.size();
}

TEST(RailInclination, TellsARailThatIsInclinedAlready) {
  for (const double part : {20.0, 40.0}) {
    const double inclined =
        inclination(worn_points("60E1", {{1.0, -35, 10}}, {{-7, 0}, -std::atan(1 / part)}, 0.5));
    EXPECT_NEAR(inclined, std::atan(1 / part), 2e-4);
    EXPECT_EQ(inclination_text(inclined), part == 20 ? "about 1:20" : "about 1:40");
  }
  const NominalPlace other_way{{0, 0}, 0.025};
  EXPECT_EQ(inclination(worn_points("60E1", {}, other_way, 0.5)), 0);
}

/// Wide wear turns the place at which 60E1 lies best.
TEST(RailInclination, TakesNoWearForAnInclination) {
  for (const double depth : {0.3, 1.0, 2.0})
    for (const double at : {-35.0, -20.0, -10.0})
      for (const double width : {12.0, 20.0, 30.0})
        EXPECT_EQ(inclination(worn_points("60E1", {{depth, at, width}}, {}, 0.5)), 0)
            << depth << ' ' << at << ' ' << width;
}

/// A low rail: a trough over the whole top, beside its middle. Its flanks alone tell.
TEST(RailInclination, OfALowRailWornAllOverItsTopIsTold) {
  for (const double c : {-6.0, -4.0, 0.0, 4.0, 6.0})
    for (const double w : {12.0, 18.0})
      for (const double depth : {0.5, 1.0, 2.0})
        for (const double part : {0.0, 0.025, 0.05}) {
          const Points points = noisy(worn_points("60E1", {{depth, c, w}}, {{0, 0}, -part}, 0.25), 0.003, 7);
          const SaidWarnings quiet;
          const MeasuredProfile p = parse_measured_profile(as_columns(points), "rail.txt", ProfileKind::rail);
          EXPECT_NEAR(rail_inclination(p.curve, p.scatter_left()), part, 2e-3)
              << c << ' ' << w << ' ' << depth;
          const auto like = like_standard(p.curve, ProfileKind::rail, p.scatter_left());
          ASSERT_TRUE(like) << c << ' ' << w << ' ' << depth;
          EXPECT_TRUE(like->name == "60E1" || like->other == "60E1") << like->name;
        }
}

TEST(RailInclination, OfARailThatLeansOutwardsIsSaid) {
  const auto turn = [](double angle) {
    const SaidWarnings quiet;
    const Points points = worn_points("60E1", {{0.5, 0, 12}}, {{-7, 0}, angle}, 0.4);
    const MeasuredProfile p = parse_measured_profile(as_columns(points), "rail.txt", ProfileKind::rail);
    return rail_turn(p.curve, p.scatter_left());
  };
  EXPECT_NEAR(turn(0.025), 0.025, 1e-3);
  EXPECT_NEAR(turn(-0.025), -0.025, 1e-3);
  EXPECT_EQ(turn(0), 0);
  EXPECT_THAT(leans_outwards(0.025),
              testing::HasSubstr("away from the track's centre in its file (about 1:40)"));
  EXPECT_EQ(leans_outwards(-0.025), "");
}

/// The gauge face is worn to a plane, `side` mm inside the widest place of the head.
Points side_worn(const ProfileCurve& curve, double side, double slope, double turn) {
  Points points = worn_points(curve, {}, {}, 0.4);
  const double widest = std::ranges::min(points, {}, &Point2::y).y + side;
  for (Point2& p : points)
    if (p.y < 0)
      p.y = std::max(p.y, widest - slope * (p.z - 14));
  for (Point2& p : points)
    p = turned(p, -turn);
  return points;
}

TEST(RailInclination, OfASideWornRailIsToldByTheStandardOnWhichItLies) {
  for (const double slope : {0.0, 0.15})
    for (const double turn : {0.0, 0.025, 0.05})
      EXPECT_NEAR(inclination(side_worn(standard_profile("60E1"), 3, slope, turn)), turn, 3e-4)
          << slope << ' ' << turn;
}

/// A flank and a worn face are mirror images about an axis that is none.
TEST(RailInclination, TwoStraightSidesAloneTellNoAxis) {
  const ProfileCurve curve = curve_of_head(wide_head);
  for (const double slope : {0.0, 0.15}) {
    const Points points = side_worn(curve, 4, slope, 0);
    EXPECT_FALSE(turn_by_symmetry(ProfileCurve::through_points("rail", points))) << slope;
    EXPECT_EQ(inclination(points), 0) << slope;
  }
}

/// Grooves, and what is no head of a rail, are not looked at.
TEST(RailInclination, OfAGrooveIsNone) {
  Points groove;
  for (double angle = -0.9; angle <= 0.9; angle += 0.01)
    groove.push_back(turned({60 * std::sin(angle), 60 * std::cos(angle)}, -0.03));
  EXPECT_EQ(rail_inclination(ProfileCurve::through_points("groove", groove)), 0);
}

std::filesystem::path in_shared(const char* name) {
  return std::filesystem::path(CONFORMAL_SOURCE_DIR) / ".." / "shared" / "data" / name;
}

/// The heads of the file's rails, from flank to flank.
std::vector<ProfileCurve> heads_in(const std::filesystem::path& file) {
  std::vector<ProfileCurve> out;
  std::vector<CurvePiece> left, right;
  std::string before;
  const auto finish = [&] {
    if (right.empty())
      return;
    std::ranges::reverse(left);
    left.insert(left.end(), right.begin(), right.end());
    out.push_back(ProfileCurve::from_pieces(before, left));
    left.clear();
    right.clear();
  };
  std::ifstream in(file);
  std::string line;
  bool below = false;
  for (std::getline(in, line); std::getline(in, line);) {
    std::ranges::replace(line, ',', ' ');
    std::istringstream words(line);
    std::string name, number, kind;
    double y0 = 0, z0 = 0, y1 = 0, z1 = 0, radius = 0;
    words >> name >> number >> kind >> y0 >> z0 >> y1 >> z1 >> radius;
    if (name != before) {
      finish();
      before = name;
      below = false;
    }
    below = below || y1 < y0; // the fillet under the head
    if (below)
      continue;
    const double curvature = radius == 0 ? 0 : 1 / radius;
    right.push_back(arc_piece({y0, z0}, {y1, z1}, curvature));
    left.push_back(arc_piece({-y1, z1}, {-y0, z0}, curvature));
  }
  finish();
  return out;
}

TEST(RailInclination, OfAllRailsOfTheStandardIsToldAndNoneIsInvented) {
  const std::filesystem::path file = in_shared("standards/rails_en13674.csv");
  if (!std::filesystem::exists(file))
    GTEST_SKIP() << "the tables of rails are not at hand";
  const std::vector<ProfileCurve> heads = heads_in(file);
  EXPECT_EQ(heads.size(), 39u);
  for (const ProfileCurve& head : heads)
    for (const double turn : {0.0, 0.025, 0.05})
      EXPECT_NEAR(inclination(worn_points(head, {{0.3, -5, 10}}, {{-5, 0}, -turn}, 0.5)), turn, 2e-3)
          << head.name();
}

TEST(RailInclination, OfTheSampleFilesIsAsTheyAreKnown) {
  const SaidWarnings quiet;
  const auto of = [](const std::filesystem::path& file) {
    const MeasuredProfile p = measured_profile(file, ProfileKind::rail);
    return rail_inclination(p.curve, p.scatter_left());
  };
  EXPECT_EQ(of(std::filesystem::path(CONFORMAL_SOURCE_DIR) / "data/bodies/worn_rail.txt"), 0);
  if (!std::filesystem::exists(in_shared("profiles")))
    GTEST_SKIP() << "the sample files are not at hand";
  EXPECT_NEAR(of(in_shared("found/file-05-inclined-rail-of-another-standard/rail_49E1_1in20.txt")), 0.05,
              3e-4);
  EXPECT_NEAR(of(in_shared("profiles/MBench_UIC60_v3.ban")), 0.025, 3e-4);
  EXPECT_NEAR(of(in_shared("conicity/SUIC519A.dat")), 0.05, 1e-3); // rail A of EN 15302 is inclined 1:20
  EXPECT_EQ(of(in_shared("found/file-04-left-rail-as-it-lies-in-the-track/right.txt")), 0);
}

} // namespace
} // namespace bem_contact
