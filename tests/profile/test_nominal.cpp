#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/profile/worn/like_standard.hpp"
#include "bem_contact/profile/worn/wear_depth.hpp"
#include "sampled.hpp"
#include "tests/base/message.hpp"
#include "tests/base/temporary_folder.hpp"
#include "warnings.hpp"
#include "worn_points.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

namespace bem_contact {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using Points = std::vector<Point2>;

/// Root mean square and largest distance of a curve from points of the true profile.
std::pair<double, double> off(const ProfileCurve& curve, const Points& truth) {
  double squares = 0, most = 0;
  for (const Point2 p : truth) {
    const double d = norm(p - curve.nearest(p).position);
    squares += d * d;
    most = std::max(most, d);
  }
  return {std::sqrt(squares / static_cast<double>(truth.size())), most};
}

/// Mean curvature between the points of a curve that are nearest to two others.
double mean_curvature(const ProfileCurve& curve, Point2 from, Point2 to) {
  const CurvePoint a = curve.nearest(from), b = curve.nearest(to);
  return (b.delta - a.delta) / (b.s - a.s);
}

MeasuredProfile read(const Points& points, ProfileKind kind, ProfileReading reading) {
  return parse_measured_profile(as_columns(points), "p.txt", kind, reading);
}

const NominalPlace displaced{{0.7, -0.5}, 0.006};

TEST(Nominal, ExactPointsGiveItBackWithItsJumpsAndItsPlace) {
  for (const char* name : {"S1002", "60E1", "60E2", "54E1", "46E3"}) {
    const ProfileKind kind = kind_of_standard(name);
    const Points points = worn_points(name, {}, displaced, 0.25);
    const SaidWarnings quiet;
    const MeasuredProfile p = read(points, kind, {.nominal = name, .keep_origin = true});
    ASSERT_TRUE(p.worn) << name;
    EXPECT_NEAR(p.worn->place.shift.y, displaced.shift.y, 1e-5) << name;
    EXPECT_NEAR(p.worn->place.shift.z, displaced.shift.z, 1e-5) << name;
    EXPECT_NEAR(p.worn->place.angle, displaced.angle, 1e-7) << name;
    EXPECT_LT(p.worn->rms_depth, 1e-5) << name;
    EXPECT_LT(off(p.curve, points).second, 1e-4) << name;
    // Half a tenth of a millimetre on either side of every jump the curvature is what it was.
    const ProfileCurve exact = standard_profile(name);
    for (const double s : exact.joints())
      for (const double side : {-0.05, 0.05})
        if (s + side > exact.s_begin() + 1 && s + side < exact.s_end() - 1) {
          const CurvePoint e = exact.at(s + side);
          EXPECT_NEAR(p.curve.nearest(displaced.to_measured(e.position)).curvature, e.curvature,
                      2e-3 + 0.01 * std::abs(e.curvature))
              << name << ' ' << s + side;
        }
  }
}

/// At the flange root of S1002, over the 7 mm of a conformal contact, 2e-4 / mm move the area by 4 %.
TEST(Nominal, TellsTheCurvatureOfTheFlangeRootFromNoisyPoints) {
  const ProfileCurve exact = standard_profile("S1002");
  const Point2 from = exact.at(30).position, to = exact.at(37).position;
  const Points points = worn_points("S1002", {}, {}, 0.25);
  const SaidWarnings quiet;
  double worst = 0, plain = 0;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const Points scattered = noisy(points, 0.01, seed);
    const auto error = [&](const ProfileReading& reading) {
      return std::abs(mean_curvature(read(scattered, ProfileKind::wheel, reading).curve, from, to) -
                      mean_curvature(exact, from, to));
    };
    worst = std::max(worst, error({.nominal = "S1002"}));
    plain = std::max(plain, error({.smoothing = 14}));
  }
  EXPECT_LT(worst, 2e-4);
  EXPECT_GT(plain, 2 * worst);
}

TEST(Nominal, WearAndPlaceAreFoundInNoisyPoints) {
  const std::vector<Bump> hollow{{0.3, 5, 15}};
  const Points truth = worn_points("S1002", hollow, displaced, 0.25);
  const SaidWarnings quiet;
  for (const double scatter : {0.002, 0.01})
    for (unsigned seed = 1; seed <= 5; ++seed) {
      const MeasuredProfile p = read(noisy(truth, scatter, seed), ProfileKind::wheel, {.nominal = "S1002"});
      EXPECT_NEAR(p.worn->place.shift.y, displaced.shift.y, 0.01);
      EXPECT_NEAR(p.worn->place.shift.z, displaced.shift.z, 0.02);
      EXPECT_NEAR(p.worn->place.angle, displaced.angle, 3e-4);
      EXPECT_NEAR(p.worn->largest_depth, 0.3, 0.02);
      EXPECT_GT(p.worn->least_depth, -0.02);
      EXPECT_LT(off(p.curve, truth).first, 0.4 * scatter); // points alone: their scatter
      EXPECT_NEAR(p.removed_rms, scatter, 0.2 * scatter);
      EXPECT_LT(p.worn->shortest_wave, 50); // the hollow needs it
    }
}

TEST(Nominal, AWornRailIsFoundToo) {
  const std::vector<Bump> corner{{1.2, -38, 8}};
  const NominalPlace inclined{{-0.4, 0.3}, -0.025};
  const Points truth = worn_points("60E1", corner, inclined, 0.25);
  const SaidWarnings quiet;
  const MeasuredProfile p = read(noisy(truth, 0.005, 3), ProfileKind::rail, {.nominal = "60E1"});
  EXPECT_NEAR(p.worn->place.shift.y, inclined.shift.y, 0.01);
  EXPECT_NEAR(p.worn->place.shift.z, inclined.shift.z, 0.01);
  EXPECT_NEAR(p.worn->place.angle, inclined.angle, 3e-4);
  EXPECT_NEAR(p.worn->largest_depth, 1.2, 0.01);
  EXPECT_LT(off(p.curve, truth).first, 0.003);
}

/// A file may have its origin anywhere: at the back of the flange, or at the edge of the rail.
TEST(Nominal, IsFoundFarFromTheFilesOrigin) {
  const SaidWarnings quiet;
  for (const char* name : {"S1002", "60E1"}) {
    const NominalPlace far{{36, 140}, 0.03};
    const Points truth = worn_points(name, {{0.5, 0, 12}}, far, 0.5);
    const MeasuredProfile p = read(truth, kind_of_standard(name),
                                   {.nominal = name, .profile_z = ProfileZ::down, .keep_origin = true});
    EXPECT_NEAR(p.worn->place.shift.y, 36, 0.05) << name;
    EXPECT_NEAR(p.worn->place.shift.z, 140, 0.05) << name;
    EXPECT_NEAR(p.worn->place.angle, 0.03, 1e-3) << name;
    EXPECT_LT(off(p.curve, truth).second, 2e-3) << name;
  }
}

TEST(Nominal, EndsAreStable) {
  const Points truth = worn_points("S1002", {{0.3, 5, 15}}, {}, 0.25);
  const SaidWarnings quiet;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const MeasuredProfile p = read(noisy(truth, 0.01, seed), ProfileKind::wheel, {.nominal = "S1002"});
    for (const std::size_t end :
         {std::size_t{2}, truth.size() - 3}) // the outermost may lie beyond the scattered ones
      EXPECT_LT(norm(truth[end] - p.curve.nearest(truth[end]).position), 0.02) << seed;
    EXPECT_NEAR(p.curve.s_end() - p.curve.s_begin(),
                standard_profile("S1002").s_end() - standard_profile("S1002").s_begin(), 1);
  }
}

TEST(Nominal, APartOfAProfileWillDo) {
  Points truth = worn_points("S1002", {{0.3, 5, 15}}, {}, 0.25);
  std::erase_if(truth, [](Point2 p) { return p.y > 45 || p.y < -50; });
  const SaidWarnings quiet;
  const MeasuredProfile p = read(noisy(truth, 0.005, 2), ProfileKind::wheel, {.nominal = "S1002"});
  EXPECT_LT(off(p.curve, truth).second, 0.02);
  EXPECT_LT(p.curve.at(p.curve.s_begin()).position.y, 45.1); // nothing is added where nothing was measured
  EXPECT_GT(p.curve.at(p.curve.s_end()).position.y, -50.1);
}

/// A real rim has a chamfer beyond the standard's end.
TEST(Nominal, PointsBeyondItsEndsAreLeftOutAndCounted) {
  const Points truth = worn_points("S1002", {}, {}, 0.25);
  Points longer;
  for (int i = 0; i < 20; ++i)
    longer.push_back(truth.front() + Point2{5 - 0.25 * i, -(5 - 0.25 * i)});
  longer.insert(longer.end(), truth.begin(), truth.end());
  const SaidWarnings heard;
  const MeasuredProfile p = read(longer, ProfileKind::wheel, {.nominal = "S1002"});
  EXPECT_GE(p.worn->beyond, 20u);
  EXPECT_LE(p.worn->beyond, 22u);
  EXPECT_LT(off(p.curve, Points(truth.begin() + 1, truth.end() - 1)).second, 1e-3);
  EXPECT_THAT(heard.text(), HasSubstr("points beyond its ends left out"));
}

/// Of right and left wheels, z up or down, the same curve is made.
TEST(Nominal, MirroredAndTurnedFilesGiveTheSameCurve) {
  const Points truth = noisy(worn_points("S1002", {{0.3, 5, 15}}, displaced, 0.25), 0.005, 4);
  const SaidWarnings quiet;
  const ProfileReading reading{.nominal = "S1002"};
  const ProfileCurve curve = read(truth, ProfileKind::wheel, reading).curve;
  Points other = truth;
  for (Point2& p : other)
    p = {-p.y, -p.z};
  std::ranges::reverse(other);
  for (const ProfileReading& how :
       {reading, ProfileReading{.nominal = "S1002", .profile_z = ProfileZ::up, .mirror = true}})
    EXPECT_EQ(read(other, ProfileKind::wheel, how).curve.digest(), curve.digest());
}

/// A wave on the profile keeps the share 1 / (1 + (smoothing / length)^6).
TEST(Nominal, SmoothingOfTheDepthHasTheStatedResponse) {
  const ProfileCurve exact = standard_profile("S1002");
  const double smoothing = 10;
  for (const double ratio : {0.5, 1.0, 2.0}) {
    std::vector<double> s, depth;
    const double length = ratio * smoothing;
    for (double at = 0; at < 100; at += 0.25) {
      s.push_back(at);
      depth.push_back(std::sin(2 * std::numbers::pi * at / length));
    }
    const SmoothDepth smooth = smoothed_depth(s, depth, smoothing);
    double kept = 0;
    for (std::size_t i = 0; i < s.size(); ++i)
      if (s[i] > 30 && s[i] < 70)
        kept = std::max(kept, smooth.depth[i]);
    EXPECT_NEAR(kept, 1 / (1 + std::pow(ratio, -6)), 0.02) << ratio;
  }
}

TEST(WearDepth, PureNoiseIsRemovedByTheLongestWave) {
  int shortened = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Points line;
    for (int i = 0; i < 600; ++i)
      line.push_back({0.25 * i, 0});
    std::vector<double> s, depth;
    for (const Point2 p : noisy(line, 0.01, seed)) {
      s.push_back(0.25 * static_cast<double>(s.size()));
      depth.push_back(p.z);
    }
    const SmoothDepth smooth = smoothed_depth_by_noise(s, depth, 0.01, 0.25);
    shortened += *std::ranges::min_element(smooth.wavelength) < 50;
    for (const double d : smooth.depth)
      EXPECT_LT(std::abs(d), 0.01);
  }
  EXPECT_LE(shortened, 6);
}

TEST(WearDepth, ExactPointsKeepTheirShape) {
  std::vector<double> s, depth;
  for (int i = 0; i < 400; ++i) {
    s.push_back(0.25 * i);
    depth.push_back(0.3 * std::exp(-std::pow((s.back() - 50) / 10, 2)));
  }
  const SmoothDepth smooth = smoothed_depth_by_noise(s, depth, 0, 0.25);
  for (std::size_t i = 0; i < s.size(); ++i)
    EXPECT_NEAR(smooth.depth[i], depth[i], 1e-5) << s[i];
}

/// Wear begins within a millimetre: only there the wavelength is short.
TEST(WearDepth, AnEdgeShortensTheWaveOnlyWhereItIs) {
  std::vector<double> s, depth;
  std::mt19937 generator(3);
  std::normal_distribution<double> normal(0, 0.005);
  for (int i = 0; i < 600; ++i) {
    s.push_back(0.25 * i);
    depth.push_back(0.2 / (1 + std::exp(-(s.back() - 60) / 0.5)) + normal(generator));
  }
  const SmoothDepth smooth = smoothed_depth_by_noise(s, depth, 0.005, 0.25);
  EXPECT_LT(smooth.wavelength[240], 8);
  EXPECT_GT(smooth.wavelength[40], 30);
  EXPECT_GT(smooth.wavelength[480], 30);
  for (std::size_t i = 0; i < s.size(); ++i)
    EXPECT_NEAR(smooth.depth[i], 0.2 / (1 + std::exp(-(s[i] - 60) / 0.5)), 0.02) << s[i];
}

/// A body's contact surface is what a scene makes of the same file.
TEST(Nominal, IsAKeyOfBodyFiles) {
  const TemporaryFolder folder;
  std::ofstream(folder / "w.txt") << as_columns(
      noisy(worn_points("S1002", {{0.3, 5, 15}}, {}, 0.25), 0.005, 9));
  std::ofstream(folder / "body.toml")
      << "[body]\nkind = \"wheel\"\nprofile = \"w.txt\"\nnominal = \"S1002\"\n";
  const SaidWarnings quiet;
  const ProfileCurve of_body = named_profile("body.toml", ProfileKind::wheel, folder.path());
  EXPECT_EQ(of_body.digest(),
            named_profile("w.txt", ProfileKind::wheel, folder.path(), {.nominal = "S1002"}).digest());
  EXPECT_NE(of_body.digest(), named_profile("w.txt", ProfileKind::wheel, folder.path()).digest());
}

std::string refusal(const Points& points, ProfileKind kind, const ProfileReading& reading) {
  const SaidWarnings quiet;
  return message_of([&] { read(points, kind, reading); });
}

TEST(Nominal, AnotherShapeIsRefusedWithItsFigures) {
  Points roller; // R 30, crowned
  for (double angle = -1.2; angle <= 1.2; angle += 0.01)
    roller.push_back({-30 * std::sin(angle), 30 * std::cos(angle)});
  const ProfileReading as_is{.nominal = "S1002", .profile_z = ProfileZ::down, .keep_origin = true};
  EXPECT_THAT(refusal(roller, ProfileKind::wheel, as_is),
              AllOf(HasSubstr("not one of S1002 that is worn"), HasSubstr("moved by"), HasSubstr("degrees"),
                    HasSubstr("root mean square"), HasSubstr("at most 5 mm"),
                    HasSubstr("leave out nominal")));
  // Worn by 6 mm.
  EXPECT_THAT(refusal(worn_points("60E1", {{6, -30, 10}}, {}, 0.25), ProfileKind::rail, {.nominal = "60E1"}),
              HasSubstr("not one of 60E1 that is worn"));
}

TEST(Nominal, AnUnknownOneAndOneOfTheOtherKindAreRefused) {
  const Points points = worn_points("S1002", {}, {}, 0.25);
  EXPECT_THAT(refusal(points, ProfileKind::wheel, {.nominal = "S1003"}),
              AllOf(HasSubstr("nominal = \"S1003\" is not known"),
                    HasSubstr("a wheel was made) Did you mean S1002?")));
  EXPECT_THAT(refusal(points, ProfileKind::wheel, {.nominal = "60E1"}), HasSubstr("is not known"));
}

std::optional<LikeStandard> like(const Points& points) {
  const SaidWarnings quiet;
  return like_standard(read(points, ProfileKind::rail, {}).curve, ProfileKind::rail);
}

double told_inclination(const Points& points) {
  const SaidWarnings quiet;
  return rail_inclination(read(points, ProfileKind::rail, {}).curve);
}

/// The gauge corner of a 60E1 worn by 1.2 mm lies nearer to 60E2 than to 60E1, in the root mean square: but
/// wear adds no steel.
TEST(LikeStandard, IsTheOneOutsideOfWhichThereIsNoSteel) {
  const auto worn = like(worn_points("60E1", {{1.2, -30, 12}}, {}, 0.5));
  ASSERT_TRUE(worn);
  EXPECT_EQ(worn->name, "60E1");
  EXPECT_EQ(worn->other, "");
  EXPECT_NEAR(worn->largest_depth, 1.2, 0.05);
}

/// A top that is worn evenly looks like the lower top of another standard; the sides tell, if they are whole.
TEST(LikeStandard, TwoThatAreNearAreBothNamedAndTheSidesTellTheTurn) {
  const NominalPlace inclined{{0, 0}, -std::atan(1 / 40.0)};
  const Points even = worn_points("60E2", {{1.0, 0, 20}}, inclined, 0.5),
               beside = worn_points("60E2", {{1.0, -5, 15}}, inclined, 0.5);
  ASSERT_TRUE(like(even) && like(beside));
  EXPECT_EQ(like(even)->name, "60E2");
  EXPECT_NE(like(beside)->other, "");
  for (const Points& points : {even, beside})
    EXPECT_NEAR(told_inclination(points), inclined.angle * -1, 1e-3);
}

std::string said(const Points& points, ProfileKind kind, const ProfileReading& reading = {}) {
  const SaidWarnings heard;
  read(points, kind, reading);
  return heard.text();
}

/// As wear of 0.3 mm and 0.6 mm leaves it, by what is not worn: the top pulls no more.
TEST(Nominal, ARailIsPlacedByItsSides) {
  const std::vector<Bump> both{{0.6, -33, 10}, {0.3, 0, 10}};
  const NominalPlace inclined{{-7, 0.3}, -0.025};
  const Points truth = worn_points("60E1", both, inclined, 0.25);
  const SaidWarnings quiet;
  const MeasuredProfile p = read(noisy(truth, 0.003, 3), ProfileKind::rail, {.nominal = "60E1"});
  EXPECT_NEAR(p.worn->place.angle, inclined.angle, 3e-4);
  EXPECT_LT(norm(p.worn->place.shift - inclined.shift), 0.02);
  EXPECT_GT(p.worn->least_depth, -0.02);
  EXPECT_NEAR(p.worn->largest_depth, 0.6, 0.02);
  EXPECT_EQ(p.worn->doubt, "");
}

/// Two millimetres worn evenly off the top: more of the head is worn top than anything else.
TEST(Nominal, AnEvenlyWornTopIsNotTakenForTheTop) {
  Points points;
  const ProfileCurve exact = standard_profile("60E1");
  for (double s = exact.s_begin(); s <= exact.s_end(); s += 0.5) {
    const CurvePoint p = exact.at(s);
    points.push_back(p.position + 2 / (1 + std::exp((std::abs(s) - 30) / 2)) * normal_of(p.delta));
  }
  const SaidWarnings quiet;
  const MeasuredProfile p = read(points, ProfileKind::rail, {.nominal = "60E1"});
  EXPECT_NEAR(p.worn->place.shift.z, 0, 0.1);
  EXPECT_NEAR(p.worn->place.angle, 0, 1e-3);
  EXPECT_NEAR(p.worn->largest_depth, 2, 0.1);
}

TEST(Nominal, AWheelOfAnotherShapeIsNeitherAdvisedNorSilent) {
  // Steel of 0.2 mm outside S1002 over 20 mm, and 1 mm less beside it.
  const Points other = worn_points("S1002", {{-0.2, 12, 10}, {1, 32, 8}}, {}, 0.5);
  EXPECT_THAT(said(noisy(other, 0.003, 1), ProfileKind::wheel),
              AllOf(HasSubstr("smoothing ="), Not(HasSubstr("nominal"))));
  EXPECT_THAT(said(other, ProfileKind::wheel, {.nominal = "S1002"}),
              AllOf(HasSubstr("S1002 does not fit"), HasSubstr("lie outside, up to")));
  const Points turned_wheel = worn_points("S1002", {}, {{0, 0}, 0.012}, 0.5);
  EXPECT_THAT(said(noisy(turned_wheel, 0.003, 1), ProfileKind::wheel), Not(HasSubstr("nominal")));
  EXPECT_THAT(said(turned_wheel, ProfileKind::wheel, {.nominal = "S1002"}),
              HasSubstr("turned by 0.69 degrees"));
}

/// XP55, a 1:18 cone rounded to 0.01 mm, was taken for S1002, worn and turned by 1.2 degrees.
TEST(Nominal, TheSampleOfAnotherWheelIsNotAdvisedToBeS1002) {
  const std::filesystem::path file =
      std::filesystem::path(CONFORMAL_SOURCE_DIR) /
      "../shared/data/found/file-12-nominal-advised-for-another-profile/wheel.txt";
  if (!std::filesystem::exists(file))
    GTEST_SKIP() << "the sample file is not at hand";
  const SaidWarnings heard;
  const MeasuredProfile p = measured_profile(file, ProfileKind::wheel);
  EXPECT_THAT(heard.text(), AllOf(HasSubstr("smoothing = 14"), Not(HasSubstr("nominal = "))));
  EXPECT_FALSE(like_standard(p.curve, ProfileKind::wheel, p.scatter_left()));
}

TEST(NoisyFile, IsToldFromWhichStandardItMayBeWorn) {
  EXPECT_THAT(
      said(noisy(worn_points("S1002", {{0.3, 5, 15}}, displaced, 0.25), 0.005, 1), ProfileKind::wheel),
      AllOf(HasSubstr("looks like S1002 worn by -0.0"), HasSubstr("nominal = \"S1002\"")));
  for (const char* rail : {"60E1", "60E2", "54E1", "46E3"})
    EXPECT_THAT(
        said(noisy(worn_points(rail, {{0.3, -20, 10}}, displaced, 0.25), 0.005, 1), ProfileKind::rail),
        HasSubstr(std::string("nominal = \"") + rail + "\""));
  Points groove;
  for (double angle = -0.6; angle <= 0.6; angle += 0.005)
    groove.push_back({60 * std::sin(angle), 60 * std::cos(angle)});
  EXPECT_THAT(said(noisy(groove, 0.005, 1), ProfileKind::rail, {.profile_z = ProfileZ::down}),
              AllOf(HasSubstr("smoothing ="), Not(HasSubstr("nominal"))));
  EXPECT_THAT(
      said(noisy(worn_points("S1002", {}, {}, 0.25), 0.005, 1), ProfileKind::wheel, {.nominal = "S1002"}),
      AllOf(Not(HasSubstr("warning")), HasSubstr("S1002 worn by"), HasSubstr("root mean square")));
}

} // namespace
} // namespace bem_contact
