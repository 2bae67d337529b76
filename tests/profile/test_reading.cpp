// What a profile file does not say, or says in another way: where z points, which side it is of, where its y
// = 0 is, which values are missing. Read right, or said, or refused with the cause.
#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/wheel_datum.hpp"
#include "refusal.hpp"
#include "sampled.hpp"
#include "tests/base/temporary_folder.hpp"
#include "tests/profile/curves.hpp"
#include "warnings.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace bem_contact {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using Points = std::vector<Point2>;

Points scaled(Points points, double y, double z) {
  for (Point2& p : points)
    p = {y * p.y, z * p.z};
  return points;
}

/// Largest distance of a curve from a standard profile where it lies above `depth`, and how it was read.
struct Answer {
  double off = 0; ///< mm
  std::string said;
};
Answer answer(const Points& points, const std::string& standard, const ProfileReading& reading = {}) {
  const SaidWarnings warnings;
  const ProfileCurve curve = parse_profile(as_columns(points), "p.txt", kind_of_standard(standard), reading);
  const ProfileCurve exact = standard_profile(standard);
  double off = 0;
  for (double s = curve.s_begin(); s <= curve.s_end(); s += 0.31) {
    const CurvePoint p = curve.at(s), q = exact.nearest(p.position);
    const bool on_face = q.s <= exact.s_begin() + 1e-6 || q.s >= exact.s_end() - 1e-6;
    if (!on_face)
      off = std::max({off, norm(p.position - q.position), 1e-2 * std::abs(p.delta - q.delta)});
  }
  return {off, warnings.text()};
}

// ---------------------------------------------------------------- where z of a wheel points

/// S1002, walked from the field side, with the faces of the rim so deep (0: none), mm.
Points rim(double front, double back, double step = 0.5) {
  Points points = sampled_curve(standard_profile("S1002"), 0.25);
  const Point2 field = points.front(), flange = points.back();
  for (double d = step; d <= front; d += step)
    points.insert(points.begin(), field - Point2{0, d});
  for (double d = step; d <= back; d += step)
    points.push_back(flange - Point2{0, d});
  return points;
}

TEST(WheelUpsideDown, FacesOfTheRimTurnNoWheel) {
  for (const double front : {0.0, 8.0, 26.0, 60.0, 120.0})
    for (const double back : {0.0, 15.0, 37.0, 60.0, 120.0})
      for (const double y : {1.0, -1.0}) {
        const Answer down = answer(scaled(rim(front, back), y, 1), "S1002");
        EXPECT_LT(down.off, 0.01) << front << " " << back;
        EXPECT_THAT(down.said, Not(HasSubstr("z points up"))) << front << " " << back;
        const Answer up = answer(scaled(rim(front, back), y, -1), "S1002");
        EXPECT_LT(up.off, 0.01) << front << " " << back;
        EXPECT_THAT(up.said, HasSubstr("z points up")) << front << " " << back;
      }
}

/// The rim goes on inwards below its faces.
TEST(WheelUpsideDown, TheUndersideOfTheRimTurnsNoWheel) {
  Points points = rim(30, 36);
  for (double d = 1; d <= 30; ++d) {
    points.insert(points.begin(), points.front() - Point2{1, 0.1});
    points.push_back(points.back() + Point2{1, -0.1});
  }
  for (const double z : {1.0, -1.0}) {
    const SaidWarnings warnings;
    const ProfileCurve curve = parse_profile(as_columns(scaled(points, 1, z)), "p.txt", ProfileKind::wheel);
    EXPECT_NEAR(curve.nearest({-55, 28}).position.z, 28, 0.01) << z;
  }
}

/// A scan that ends on the flank of the flange: steep, but not vertical.
TEST(WheelUpsideDown, TheFlankOfAFlangeTells) {
  for (const double last : {-38.0, -41.0, -50.0, -55.0}) {
    Points points = rim(0, 0);
    std::erase_if(points, [&](Point2 p) { return p.y < last; });
    EXPECT_LT(answer(points, "S1002").off, 0.01) << last;
    const Answer up = answer(scaled(points, 1, -1), "S1002");
    EXPECT_LT(up.off, 0.01) << last;
    EXPECT_THAT(up.said, HasSubstr("z points up")) << last;
  }
}

/// What has neither is asked about; nothing is turned in silence.
TEST(WheelUpsideDown, WithoutAFlangeItIsAskedOrSaid) {
  const auto tread = [](double front, double z) {
    Points points = rim(front, 0);
    std::erase_if(points, [](Point2 p) { return p.y < -25; });
    return as_columns(scaled(points, 1, z));
  };
  for (const double z : {1.0, -1.0}) {
    EXPECT_THAT(bem_contact::refusal(tread(30, z), ProfileKind::wheel),
                AllOf(HasSubstr("z may point up or down"), HasSubstr("profile_z = \"up\" or")))
        << z;
    const SaidWarnings warnings;
    parse_profile(tread(0, z), "p.txt", ProfileKind::wheel);
    EXPECT_THAT(warnings.text(), HasSubstr("profile_z = \"down\" says so")) << z;
  }
  for (const double front : {0.0, 30.0}) {
    const SaidWarnings warnings;
    const ProfileCurve up =
        parse_profile(tread(front, -1), "p.txt", ProfileKind::wheel, {.profile_z = ProfileZ::up});
    EXPECT_LT(norm(up.nearest({-20, 1.7}).position - standard_profile("S1002").nearest({-20, 1.7}).position),
              1e-3);
    EXPECT_THAT(warnings.text(), IsEmpty());
  }
}

TEST(WheelUpsideDown, AnArcIsNotTurned) {
  const auto arc = [](double z) { // 110 mm wide, R 100
    Points points;
    for (double y = -55; y <= 55; y += 0.5)
      points.push_back({y, z * (100 - std::sqrt(1e4 - y * y))});
    return as_columns(points);
  };
  const SaidWarnings warnings;
  const ProfileCurve groove = parse_profile(arc(1), "p.txt", ProfileKind::wheel);
  EXPECT_NEAR(groove.nearest({50, 13.4}).position.z, 13.4, 0.01);
  EXPECT_THAT(warnings.text(), HasSubstr("\"up\" turns it"));
  EXPECT_THAT(bem_contact::refusal(arc(-1), ProfileKind::wheel), HasSubstr("z may point up or down"));
}

// ---------------------------------------------------------------- rails with a groove or a gap

TEST(RailUpsideDown, AHeadBesideAGrooveIsAskedAbout) {
  Points points{{-78, 8.2}, {-70, 8}, {-66, 8.2}, {-65, 10}, {-65, 30}, {-64, 45}, {-30, 45}};
  for (const Point2 p : sampled_curve(standard_profile("60E1"), 0.5))
    if (p.y > -30)
      points.push_back(p);
  for (const double z : {1.0, -1.0})
    EXPECT_THAT(bem_contact::refusal(as_columns(scaled(points, 1, z))),
                AllOf(HasSubstr("z may point up or down"), HasSubstr("groove"), HasSubstr("profile_z")));
  const SaidWarnings warnings;
  const ProfileCurve curve =
      parse_profile(as_columns(points), "p.txt", ProfileKind::rail, {.profile_z = ProfileZ::down});
  EXPECT_NEAR(norm(curve.nearest({0, 0}).position), 0, 1e-3);
}

// ---------------------------------------------------------------- which side a rail is of

/// 60E1 with its gauge side worn: a plane 20 degrees off the vertical, as far as `lowest` below the top.
Points side_worn(double wear, double lowest = 20, double end = 35) {
  Points points = sampled_curve(standard_profile("60E1"), 0.25);
  for (Point2& p : points)
    if (p.y < 0 && p.z < lowest)
      p.y = std::max(p.y, -36 + wear + (14 - p.z) * std::tan(0.35));
  std::erase_if(points, [&](Point2 p) { return p.z > end; });
  return points;
}

Points inclined(Points points, double angle) {
  for (Point2& p : points)
    p = turned(p, angle);
  return points;
}

TEST(RailSide, ARailThatIsWornOnItsFieldSideIsSaid) {
  const auto said = [](const Points& points, bool mirror = false) {
    const SaidWarnings warnings;
    parse_profile(as_columns(points), "p.txt", ProfileKind::rail, {.mirror = mirror});
    return warnings.text();
  };
  for (const double wear : {3.0, 5.0, 8.0})
    for (const double angle : {0.0, -0.025, -0.05, 0.05})
      for (const double end : {28.0, 35.0}) {
        const Points right = inclined(side_worn(wear, 20, end), angle);
        EXPECT_THAT(said(right), Not(HasSubstr("mirror"))) << wear << " " << angle << " " << end;
        EXPECT_THAT(said(scaled(right, -1, 1)), AllOf(HasSubstr("worn by some"), HasSubstr("mirror = true")))
            << wear << " " << angle << " " << end;
        EXPECT_THAT(said(scaled(right, -1, 1), true), Not(HasSubstr("mirror"))) << wear;
        EXPECT_THAT(said(right, true), HasSubstr("mirror = false")) << wear;
      }
  // All of the flank worn by as much, as far down as the scan goes: the crown and the hollow below it tell.
  for (const double wear : {3.0, 5.0, 8.0}) {
    Points whole = sampled_curve(standard_profile("60E1"), 0.25);
    for (Point2& p : whole)
      if (p.y < 0)
        p.y += wear * std::clamp((p.z - 2) / 12, 0.0, 1.0);
    EXPECT_THAT(said(whole), Not(HasSubstr("mirror"))) << wear;
    EXPECT_THAT(said(scaled(whole, -1, 1)), HasSubstr("mirror = true")) << wear;
  }
  // Worn down to where the scan ends.
  EXPECT_THAT(said(scaled(side_worn(5, 30, 22), -1, 1)), HasSubstr("mirror = true"));
  EXPECT_THAT(said(side_worn(5, 30, 22)), Not(HasSubstr("mirror")));
}

TEST(RailSide, ARailMeasuredFromTheTracksCentreIsPutOnItsSide) {
  const Points right = side_worn(5);
  Points in_track = right;
  for (Point2& p : in_track)
    p.y += 753.5;
  const auto read = [](const Points& points, bool mirror = false) {
    return parse_profile(as_columns(points), "p.txt", ProfileKind::rail, {.mirror = mirror}).digest();
  };
  const SaidWarnings warnings;
  const auto expected = read(in_track);
  EXPECT_THAT(warnings.text(), Not(HasSubstr("mirror")));
  EXPECT_EQ(read(scaled(in_track, -1, 1)), expected);
  EXPECT_THAT(warnings.text(), AllOf(HasSubstr("centre of the track"), HasSubstr("mirror = true says so")));
  EXPECT_EQ(read(scaled(in_track, -1, 1), true), expected);
}

// ---------------------------------------------------------------- where the back of the flange is

TEST(FlangeBack, ASteepEndElsewhereIsSaid) {
  const auto said = [](double by, const ProfileReading& reading = {}, double y = 1, double back = 0) {
    Points points = rim(0, back);
    for (Point2& p : points)
      p.y = y * (p.y + by);
    const SaidWarnings warnings;
    parse_profile(as_columns(points), "p.txt", ProfileKind::wheel, reading);
    return warnings.text();
  };
  for (const double back : {0.0, 30.0}) {
    for (const double by : {-7.8, -3.5, 3.5, 5.0, 10.0, 12.0, 15.0})
      EXPECT_THAT(said(by, {}, 1, back),
                  AllOf(HasSubstr(fmt::format("y = {:.1f} mm", by - 70)),
                        HasSubstr(fmt::format("wheel.flange_back = {:.1f} puts", by - 70))));
    for (const double by : {-2.5, 0.0, 2.5})
      EXPECT_THAT(said(by, {}, 1, back), IsEmpty());
  }
  EXPECT_THAT(said(-7.8, {.flange_back = -77.8}), IsEmpty());
  EXPECT_THAT(said(-7.8, {.flange_back = -70}), IsEmpty());
  EXPECT_THAT(said(-7.8, {}, -1), HasSubstr("flange_back = 77.8 puts"));
}

TEST(FlangeBack, AScanThatEndsBehindTheTipTellsNothing) {
  Points points = rim(0, 0);
  std::erase_if(points, [](Point2 p) { return p.y < -62; });
  for (Point2& p : points)
    p.y += 6;
  const SaidWarnings warnings;
  parse_profile(as_columns(points), "p.txt", ProfileKind::wheel);
  EXPECT_THAT(warnings.text(), Not(HasSubstr("flange_back")));
}

// ---------------------------------------------------------------- missing values

TEST(MissingValues, AreLeftOutAndSaid) {
  const auto marked = [](Points points, Point2 mark, bool whole) {
    for (const std::size_t at : {40u, 41u, 200u, 201u, 202u, 330u})
      points[at] = {whole ? mark.y : points[at].y, mark.z};
    return points;
  };
  for (const char* standard : {"S1002", "60E1"}) {
    const Points points = sampled_curve(standard_profile(standard), 0.2);
    for (const double z : {1.0, -1.0})
      for (const double mark : {-999.0, 999.99, -9999.0, 9999.999, 99999.0, 1e30, -1e10, -32768.0, -99.99})
        for (const bool whole : {false, true}) {
          const Answer read = answer(marked(scaled(points, 1, z), {mark, mark}, whole), standard);
          EXPECT_LT(read.off, 0.01) << standard << " " << mark;
          EXPECT_THAT(read.said, AllOf(HasSubstr("6 points left out"), HasSubstr("missing value"))) << mark;
        }
  }
  Points first = sampled_curve(standard_profile("S1002"), 0.2);
  first[0].z = first[1].z = first.back().z = -999;
  EXPECT_LT(answer(first, "S1002").off, 0.01);
  Points metres = marked(scaled(sampled_curve(standard_profile("S1002"), 0.2), 1e-3, 1e-3), {0, -999}, false);
  EXPECT_LT(answer(metres, "S1002").off, 0.01);
}

/// The outer wall of a keeper: two points, far apart for their neighbours, at a number of nines.
TEST(MissingValues, ANumberOfNinesWhereTheProfileGoesIsAPlace) {
  Points points{{-99.9, 40}, {-99.9, 0.5}};
  for (double y = -99.4; y < -78; y += 0.5)
    points.push_back({y, 0.5});
  points.insert(points.end(), {{-78, 47}, {-45, 47}}); // the groove
  const Points head = sampled_curve(standard_profile("60E1"), 0.5);
  points.insert(points.end(), head.begin(), head.end());
  const SaidWarnings warnings;
  const ProfileCurve curve =
      parse_profile(as_columns(points), "p.txt", ProfileKind::rail, {.profile_z = ProfileZ::down});
  EXPECT_NEAR(curve.at(curve.s_begin()).position.y, -99.9, 1e-9);
  EXPECT_THAT(warnings.text(), Not(HasSubstr("missing value")));
}

TEST(MissingValues, OfTwoZerosAreLeftOutWhereTheWalkLeapsThere) {
  Points points = sampled_curve(standard_profile("S1002"), 0.2);
  for (const std::size_t at : {100u, 101u, 400u, 500u})
    points[at] = {0, 0};
  EXPECT_LT(answer(points, "S1002").off, 0.01);
  Points rail = sampled_curve(standard_profile("60E1"), 0.2);
  for (Point2& p : rail)
    p.y += 753.5;
  const auto expected = [&] {
    const SaidWarnings warnings;
    Points whole = rail;
    whole.erase(whole.begin() + 50);
    return parse_profile(as_columns(whole), "p.txt", ProfileKind::rail).digest();
  }();
  rail[50] = {0, 0};
  const SaidWarnings warnings;
  EXPECT_EQ(parse_profile(as_columns(rail), "p.txt", ProfileKind::rail).digest(), expected);
  EXPECT_THAT(warnings.text(), HasSubstr("1 point left out"));
}

// ---------------------------------------------------------------- dense scans, closed outlines

TEST(DenseScan, IsThinnedToMeans) {
  struct Scan {
    double spacing, scatter,
        largest_depth; ///< mm; what is found worn off a new rail grows with scatter sqrt(spacing)
  };
  for (const Scan& scan : {Scan{0.1, 0.05, 0.01}, Scan{0.05, 0.02, 0.01}, Scan{0.02, 0.01, 0.01},
                           Scan{0.2, 0.1, 0.025}, Scan{0.05, 0.05, 0.011}}) {
    const Points points = noisy(sampled_curve(standard_profile("60E1"), scan.spacing), scan.scatter, 5);
    const SaidWarnings warnings;
    const MeasuredProfile read =
        parse_measured_profile(as_columns(points), "p.txt", ProfileKind::rail, {.nominal = "60E1"});
    EXPECT_THAT(warnings.text(), AllOf(HasSubstr("points scatter by"), HasSubstr("became their mean")));
    ASSERT_TRUE(read.worn);
    EXPECT_LT(std::max(read.worn->largest_depth, -read.worn->least_depth), scan.largest_depth)
        << scan.spacing;
  }
}

TEST(ClosedOutline, OfARailIsOpenedAtItsBase) {
  // A head on a web and a foot 150 mm wide, as a CAD program writes it: from the top round to the top.
  Points right{{8, 50}, {8, 140}, {70, 152}, {75, 156}, {75, 171}, {74, 172}, {0, 172}};
  Points half = sampled_curve(standard_profile("60E1"), 0.5);
  std::erase_if(half, [](Point2 p) { return p.y < 0.1; });
  half.insert(half.begin(), Point2{0, 0}); // the first and the last point of the outline
  std::ranges::copy(right, std::back_inserter(half));
  const auto outline = [&](std::size_t begin, double z) {
    Points all;
    for (std::size_t i = 0; i + 1 < half.size(); ++i) // in small steps, as the head
      for (int k = 0; k < 20 && (k == 0 || norm(half[i + 1] - half[i]) > 1); ++k)
        all.push_back(half[i] + (k / 20.0) * (half[i + 1] - half[i]));
    const Points one = all;
    for (auto p = one.rbegin(); p != one.rend(); ++p)
      all.push_back({-p->y, p->z});
    std::rotate(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(begin), all.end());
    all.push_back(all.front());
    return as_columns(scaled(all, 1, z));
  };
  for (const std::size_t begin : {0u, 77u, 200u, 300u})
    for (const double z : {1.0, -1.0}) {
      const SaidWarnings warnings;
      const ProfileCurve curve = parse_profile(outline(begin, z), "p.txt", ProfileKind::rail);
      const ProfileCurve exact = standard_profile("60E1");
      for (double y = -34; y <= 34; y += 3.1) {
        const Point2 p = exact.nearest({y, 0}).position;
        EXPECT_LT(norm(curve.nearest(p).position - p), 2e-3) << begin << " " << y;
      }
      EXPECT_THAT(warnings.text(), HasSubstr("the outline is closed: its lower half"));
    }
  EXPECT_THAT(bem_contact::refusal(outline(0, 1), ProfileKind::wheel),
              AllOf(HasSubstr("the outline is closed"), HasSubstr("the back of the flange")));
  Points head = sampled_curve(standard_profile("60E1"), 0.5);
  for (double y = head.back().y; y > head.front().y;
       y -= 0.5) { // fishing surfaces, and a cut through the web
    const double into_web = std::max(0.0, std::min(28.0, 37 - std::abs(y)));
    head.push_back({y, head.front().z + 0.4 * into_web});
  }
  EXPECT_THAT(bem_contact::refusal(as_columns(head)),
              AllOf(HasSubstr("the outline is closed"), HasSubstr("over the head")));
}

// ---------------------------------------------------------------- other ways to write numbers

TEST(OtherFiles, DecimalCommasAreNamed) {
  const auto commas = HasSubstr("decimal commas");
  EXPECT_THAT(bem_contact::refusal(
                  "ProgramName=MiniProf\nXYPoints=3\nColumnDef=X,Y\n\n0,0000\t-6,6192\n0,2\t1,0\n1,0\t2,0\n"),
              commas);
  EXPECT_THAT(bem_contact::refusal("XYPoints=3\n\n0,5;1,5\n1,5;2,5\n2,5;3\n"), commas);
  EXPECT_THAT(bem_contact::refusal("0,5 1,5\n1,5 2,5\n"), commas);
  EXPECT_THAT(bem_contact::refusal("10;1,5\n11;2,5\n"), commas);
  EXPECT_THAT(
      bem_contact::refusal(
          "header.begin\n type = 0\nheader.end\nspline.begin\npoint.begin\n-20,5 4\n0 0\n20 4\npoint.end\n"),
      commas);
  EXPECT_THAT(bem_contact::refusal("RAILPROFILE\ntitle\nGAUGE 1435\n-750,5 1,5 750,5 1,5\n"), commas);
  const SaidWarnings warnings;
  EXPECT_NO_THROW(parse_profile("-20,4\n-10,1\n0,0\n10, 1\n20 , 4\n", "p.txt", ProfileKind::rail));
}

TEST(OtherFiles, WhatIsNoTableOfPointsIsNamed) {
  EXPECT_THAT(bem_contact::refusal("{\"unit\":\"mm\",\"y\":[1,2,3],\"z\":[0,0,0]}"),
              AllOf(HasSubstr("no table of points"), HasSubstr("JSON"), HasSubstr("on a line")));
  EXPECT_THAT(bem_contact::refusal("\n [\n  [1, 2],\n  [3, 4]\n]\n"), HasSubstr("JSON"));
  EXPECT_THAT(bem_contact::refusal("[1, 2, 3]"), HasSubstr("JSON"));
  EXPECT_THAT(bem_contact::refusal("PK\x03\x04 and so on"), HasSubstr("spreadsheet"));
  EXPECT_THAT(bem_contact::refusal("<?xml version=\"1.0\"?>\n<a/>\n"), HasSubstr("XML"));
  EXPECT_THAT(bem_contact::refusal(std::string("1\0 \0002\0", 6)), HasSubstr("no text"));
  const SaidWarnings warnings;
  EXPECT_NO_THROW(
      parse_profile("[Profile1Info]\nColumnDef=X,Y\n[Profile1Points]\n-20 4\n-10 1\n0 0\n10 1\n20 4\n",
                    "p.mpt", ProfileKind::rail));
}

TEST(NamedProfile, AFileWithTheNameOfAStandardIsSaid) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "S1002") << as_columns(scaled(rim(0, 0), 1, 1));
  const SaidWarnings warnings;
  EXPECT_EQ(named_profile("S1002", ProfileKind::wheel, folder.path()).digest(),
            standard_profile("S1002").digest());
  EXPECT_THAT(warnings.text(),
              AllOf(HasSubstr("S1002 is the standard profile"), HasSubstr("\"./S1002\" reads it")));
  EXPECT_NE(named_profile("./S1002", ProfileKind::wheel, folder.path()).digest(),
            standard_profile("S1002").digest());
}

// ---------------------------------------------------------------- no false alarm

const std::filesystem::path source_folder = CONFORMAL_SOURCE_DIR;

/// What must not be said of a file that is as it should be.
const auto no_alarm = Not(testing::AnyOf(
    HasSubstr("mirror"), HasSubstr("flange_back"), HasSubstr("profile_z = \"down\""), HasSubstr("left out"),
    HasSubstr("became their mean"), HasSubstr("worn by some"), HasSubstr("the outline is closed")));

TEST(NoFalseAlarm, OnTheProjectsOwnProfiles) {
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(source_folder / "data/bodies"))
    if (const std::string name = entry.path().stem().string(); entry.path().extension() == ".txt") {
      const SaidWarnings warnings;
      read_profile(entry.path(), name.find("rail") != name.npos ? ProfileKind::rail : ProfileKind::wheel);
      EXPECT_THAT(warnings.text(), no_alarm) << entry.path();
      ++files;
    }
  EXPECT_GE(files, 3);
}

/// The lines and arcs of a table in shared/data/standards, sampled; polynomials are left out.
std::vector<std::pair<std::string, Points>> drawn(const std::filesystem::path& table) {
  std::vector<std::pair<std::string, Points>> out;
  std::ifstream file(table);
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::vector<std::string> cell;
    for (std::size_t at = 0; at <= line.size();) {
      const auto end = std::min(line.find(',', at), line.size());
      cell.push_back(line.substr(at, end - at));
      at = end + 1;
    }
    const auto number = [&](std::size_t k) { return std::stod(cell.at(k)); };
    if (out.empty() || out.back().first != cell[0])
      out.push_back({cell[0], {}});
    const Point2 a{number(3), number(4)}, b{number(5), number(6)};
    const int count = 1 + static_cast<int>(norm(b - a) / 0.4);
    for (int i = 0; i < count; ++i) {
      Point2 p = a + (i / static_cast<double>(count)) * (b - a);
      if (cell[2] == "arc") {
        const Point2 centre{number(8), number(9)};
        p = centre + (std::abs(number(7)) / norm(p - centre)) * (p - centre);
      }
      out.back().second.push_back(p);
    }
  }
  return out;
}

TEST(NoFalseAlarm, OnSharedProfiles) {
  const std::filesystem::path shared = source_folder / "../shared/data";
  if (!std::filesystem::exists(shared / "standards/wheels.csv"))
    GTEST_SKIP() << "the shared data are not at hand";
  const auto read = [](const std::filesystem::path& file, ProfileKind kind) {
    const SaidWarnings warnings;
    read_profile(file, kind);
    EXPECT_THAT(warnings.text(), no_alarm) << file;
  };
  read(shared / "profiles/MBench_UIC60_v3.prr", ProfileKind::rail);
  read(shared / "profiles/MBench_UIC60_v3.ban", ProfileKind::rail);
  read(shared / "profiles/MBench_S1002_v3.prw", ProfileKind::wheel);
  read(shared / "conicity/SUIC519A.dat", ProfileKind::rail);
  read(shared / "conicity/RUIC519A.dat", ProfileKind::wheel);
  read(shared / "conicity/RUIC519B.dat", ProfileKind::wheel);
  read(shared / "found/file-12-nominal-advised-for-another-profile/wheel.txt", ProfileKind::wheel);
  int rails = 0, wheels = 0;
  for (const auto& [name, half] : drawn(shared / "standards/rails_en13674.csv"))
    for (const double z : {1.0, -1.0}) {
      Points outline = half; // of the whole rail, from the middle of its base round to there
      for (const Point2 p : half)
        if (p.y > 0)
          outline.insert(outline.begin(), {-p.y, p.z});
      Points head = outline;
      std::erase_if(head, [](Point2 p) { return p.z > 30; });
      const SaidWarnings warnings;
      const ProfileCurve curve = parse_profile(as_columns(scaled(head, 1, z)), name, ProfileKind::rail);
      EXPECT_THAT(warnings.text(), no_alarm) << name;
      EXPECT_LT(norm(curve.nearest({0, 0}).position), 1e-6) << name;
      outline.push_back(outline.front());
      const ProfileCurve opened = parse_profile(as_columns(scaled(outline, 1, z)), name, ProfileKind::rail);
      EXPECT_LT(norm(opened.nearest({0, 0}).position), 1e-6) << name;
      EXPECT_THAT(warnings.text(), AllOf(HasSubstr("the outline is closed"), Not(HasSubstr("mirror"))))
          << name;
      ++rails;
    }
  for (const auto& [name, points] : drawn(shared / "standards/wheels.csv")) {
    if (name.starts_with("EN13715_S1002") || name.starts_with("APTA") || name.starts_with("NRCC"))
      continue; // a polynomial is missing; or y = 0 is at the gauge point or the flange back
    for (const double z : {1.0, -1.0}) {
      const SaidWarnings warnings;
      parse_profile(as_columns(scaled(points, 1, z)), name, ProfileKind::wheel);
      EXPECT_THAT(warnings.text(), no_alarm) << name;
      ++wheels;
    }
  }
  EXPECT_GE(rails, 60);
  EXPECT_GE(wheels, 30);
}

} // namespace
} // namespace bem_contact
