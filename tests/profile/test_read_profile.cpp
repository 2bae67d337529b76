#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "refusal.hpp"
#include "tests/base/message.hpp"
#include "tests/profile/curves.hpp"
#include "warnings.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace bem_contact {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using Points = std::vector<Point2>;

Points sampled(const std::string& standard, double step = 0.5) {
  const ProfileCurve curve = standard_profile(standard);
  Points points;
  const int count = static_cast<int>((curve.s_end() - curve.s_begin()) / step);
  for (int i = 0; i <= count; ++i)
    points.push_back(curve.at(curve.s_begin() + i * (curve.s_end() - curve.s_begin()) / count).position);
  return points;
}

std::string columns(const Points& points, double scale = 1) {
  std::string text;
  for (const Point2 p : points)
    text += fmt::format("{:.9g} {:.9g}\n", scale * p.y, scale * p.z);
  return text;
}

Points mapped(Points points, double y, double z) {
  for (Point2& p : points)
    p = {y * p.y, z * p.z};
  return points;
}

/// Largest distance from `curve` to a standard profile, and both run the same way.
double deviation(const ProfileCurve& curve, const std::string& standard) {
  const ProfileCurve exact = standard_profile(standard);
  double worst = 0;
  for (double s = curve.s_begin(); s <= curve.s_end(); s += 0.21) {
    const CurvePoint p = curve.at(s), q = exact.nearest(p.position);
    worst = std::max({worst, norm(p.position - q.position), 1e-2 * std::abs(p.delta - q.delta)});
  }
  return worst;
}
constexpr double sampling = 1e-3; // what half a millimetre between points costs where curvature jumps

TEST(PlainProfile, reads_what_it_should_without_a_word) {
  const SaidWarnings warnings;
  EXPECT_LT(deviation(parse_profile(columns(sampled("60E1")), "p", ProfileKind::rail), "60E1"), sampling);
  EXPECT_LT(deviation(parse_profile(columns(sampled("S1002")), "p", ProfileKind::wheel), "S1002"), sampling);
  EXPECT_THAT(warnings.text(), IsEmpty());
}

/// What is missing cannot be known; that it is missing can.
TEST(PlainProfile, holes_and_jumps_are_said) {
  const auto said = [](const Points& points) {
    const SaidWarnings warnings;
    parse_profile(columns(points), "p", ProfileKind::rail);
    return warnings.text();
  };
  const Points whole = sampled("60E1", 0.2);
  const auto without = [&](double from, double to) {
    Points points = whole;
    std::erase_if(points, [&](Point2 p) { return p.y > from && p.y < to; });
    return points;
  };
  EXPECT_THAT(said(without(-34, -20)), AllOf(HasSubstr("no points for 15"), HasSubstr("turns by 5")));
  EXPECT_THAT(said(without(-4, 4)), IsEmpty()) << "on the radius of 300 mm a chord is as good";
  EXPECT_THAT(said(without(-4, -3)), IsEmpty());
  Points jump = whole;
  for (Point2& p : jump)
    p.z += p.y > -12 ? 0.5 : 0;
  EXPECT_THAT(said(jump), HasSubstr("jumps once, by 0.5"));
}

/// One point half a millimetre off. The corner of a rim and noise are none.
TEST(PlainProfile, a_point_off_its_neighbours_is_said) {
  const auto said = [](const Points& points) {
    const SaidWarnings warnings;
    parse_profile(columns(points), "p", ProfileKind::rail);
    return warnings.text();
  };
  Points points = sampled("60E1", 0.5);
  const std::size_t at = points.size() / 2;
  points[at].z -= 0.5;
  EXPECT_THAT(said(points),
              AllOf(HasSubstr("0.5 mm off the line of its neighbours"), HasSubstr("Take the point out")));
  points[at].z += 0.47;
  EXPECT_THAT(said(points), Not(HasSubstr("off the line")));
  for (const double slope : {0.1, 0.3, 0.8, 1.5}) {
    Points corner;
    for (int i = -40; i <= 40; ++i)
      corner.push_back({i * 0.5, std::abs(i) * 0.5 * slope});
    EXPECT_THAT(said(corner), Not(HasSubstr("off the line"))) << slope;
  }
  Points scattered = sampled("60E1", 0.25);
  std::mt19937 random(1);
  for (Point2& p : scattered)
    p.z += std::normal_distribution(0.0, 0.01)(random);
  EXPECT_THAT(said(scattered), Not(HasSubstr("off the line")));
}

/// 6 mm apart: what looks like scatter is the shape.
TEST(PlainProfile, too_few_points_are_no_noise) {
  const SaidWarnings warnings;
  const MeasuredProfile p = parse_measured_profile(columns(sampled("60E1", 6)), "p", ProfileKind::rail);
  EXPECT_THAT(warnings.text(),
              AllOf(HasSubstr("6.1 mm apart: too few for a curved profile"), Not(HasSubstr("smoothing ="))));
  EXPECT_EQ(p.noise.smoothing, 0);
}

TEST(PlainProfile, other_files_and_a_third_column_are_told) {
  EXPECT_THAT(refusal("\x89HDF\r\n\x1a\n", ProfileKind::wheel), HasSubstr("give it as wheel.influence"));
  EXPECT_THAT(refusal("1 2 0\n2 3 0\n3 4 0\n", ProfileKind::wheel), HasSubstr("it has 3 columns"));
}

TEST(PlainProfile, comments_names_separators_and_line_ends) {
  const SaidWarnings warnings;
  const std::string text =
      "\xef\xbb\xbf# rail\r\ny; z\r\n! c\r\n-20, 1\r\n-10;+2.5D-1\r\n\r\n0\t0\r\n10 .25\r\n20 1\r\n";
  const ProfileCurve curve = parse_profile(text, "folder/p.txt", ProfileKind::rail);
  EXPECT_EQ(curve.name(), "p.txt");
  EXPECT_NEAR(norm(curve.at(0).position), 0, 1e-12);
  EXPECT_NEAR(curve.nearest({10, 0.25}).position.z, 0.25, 1e-12);
}

TEST(PlainProfile, refuses_what_is_no_profile) {
  EXPECT_THAT(refusal(""), HasSubstr("p.txt has 0 points (a profile needs at least 3) The file is empty"));
  EXPECT_THAT(refusal("# nothing\n\n"), HasSubstr("has 0 points"));
  EXPECT_THAT(refusal("0 0\n20 0\n"), HasSubstr("has 2 points"));
  EXPECT_THAT(refusal("0 0\n20 nan\n30 0\n"), HasSubstr("p.txt:2: a coordinate is not a number"));
  EXPECT_THAT(refusal("0 0\n20 inf\n30 0\n"), HasSubstr("p.txt:2: a coordinate is not a number"));
  EXPECT_THAT(refusal("0 0\n20 0\n30 x\n"), HasSubstr("p.txt:3: '30 x' is not a point"));
  EXPECT_THAT(refusal("0,5 1,5\n1,5 2,5\n"), HasSubstr("decimal points"));
  EXPECT_THAT(refusal("0 0\n1 0\n2 0\n"),
              AllOf(HasSubstr("the profile is 2 mm wide"), HasSubstr("Convert it to mm.")));
  EXPECT_THAT(refusal("0 0\n1000 0\n2000 5\n"), HasSubstr("2000 mm wide"));
  // Half a circle of radius 200 mm is one where somebody says that it is in mm.
  std::string circle;
  for (int i = -90; i <= 90; ++i)
    circle += fmt::format("{:.9f} {:.9f}\n", 200 * std::sin(i * std::numbers::pi / 180),
                          200 - 200 * std::cos(i * std::numbers::pi / 180));
  EXPECT_THAT(refusal(circle), HasSubstr("400 mm wide"));
  const ProfileCurve said =
      parse_profile(circle, "p.txt", ProfileKind::rail,
                    {.unit = ProfileUnit::mm, .profile_z = ProfileZ::down, .keep_origin = true});
  EXPECT_NEAR(said.s_end() - said.s_begin(), 200 * std::numbers::pi, 0.01);
}

struct Mishap {
  std::string name, standard, text, warning;
};

class Repaired : public testing::TestWithParam<Mishap> {};

TEST_P(Repaired, to_the_profile_it_was_and_said) {
  const Mishap& mishap = GetParam();
  const SaidWarnings warnings;
  const ProfileKind kind = mishap.standard == "S1002" ? ProfileKind::wheel : ProfileKind::rail;
  const ProfileCurve curve = parse_profile(mishap.text, "p.txt", kind);
  EXPECT_LT(deviation(curve, mishap.standard), sampling);
  // Points that say nothing more are dropped by the way; all else may change the shape.
  const std::string level = mishap.warning.find("doubled") == std::string::npos ? "warning" : "info";
  EXPECT_THAT(warnings.text(), mishap.warning.empty() ? testing::Matcher<std::string>(IsEmpty())
                                                      : HasSubstr(level + ": p.txt: " + mishap.warning));
}

Points reversed(Points points) {
  std::reverse(points.begin(), points.end());
  return points;
}

Points shuffled(Points points) {
  std::mt19937 generator(7);
  std::shuffle(points.begin(), points.end(), generator);
  return points;
}

Points with_doubles(Points points) {
  for (const std::ptrdiff_t at : {3, 40, 41, 100})
    points.insert(points.begin() + at, points[static_cast<std::size_t>(at)]);
  return points;
}

Points with_swapped(Points points) {
  std::swap(points[60], points[61]);
  return points;
}

Points with_spike(Points points) {
  points.insert(points.begin() + 80, points[80] + Point2{0, 4});
  return points;
}

INSTANTIATE_TEST_SUITE_P(
    Mishaps, Repaired,
    testing::Values(
        Mishap{"metres", "60E1", columns(sampled("60E1"), 1e-3), "0.0741 wide: taken as metres"},
        Mishap{"metres_wheel", "S1002", columns(sampled("S1002"), 1e-3), "0.13 wide: taken as metres"},
        Mishap{"z_up_rail", "60E1", columns(mapped(sampled("60E1"), 1, -1)),
               "z points up: its sign is changed"},
        Mishap{"z_up_wheel", "S1002", columns(mapped(sampled("S1002"), 1, -1)), "z points up"},
        Mishap{"mirrored_wheel", "S1002", columns(mapped(sampled("S1002"), -1, 1)),
               "the flange lies at y > 0"},
        Mishap{"turned_wheel", "S1002", columns(mapped(sampled("S1002"), -1, -1)), "z points up"},
        Mishap{"reversed_rail", "60E1", columns(reversed(sampled("60E1"))), ""},
        Mishap{"reversed_wheel", "S1002", columns(reversed(sampled("S1002"))), ""},
        Mishap{"shuffled_rail", "60E1", columns(shuffled(sampled("60E1"))), "the points are out of order"},
        Mishap{"shuffled_wheel", "S1002", columns(shuffled(sampled("S1002"))), "the points are out of order"},
        Mishap{"doubled", "60E1", columns(with_doubles(sampled("60E1"))),
               "4 doubled or crowded points dropped"},
        Mishap{"swapped", "60E1", columns(with_swapped(sampled("60E1"))), "1 point dropped where"},
        Mishap{"spike", "S1002", columns(with_spike(sampled("S1002"))), "1 point dropped where"}),
    [](const auto& p) { return p.param.name; });

TEST(Repairs, what_cannot_be_mended_is_refused) {
  Points twice = sampled("60E1", 1); // two scans, one after the other, a little apart
  for (const Point2 p : sampled("60E1", 0.83))
    twice.push_back(p + Point2{0, 0.4});
  const auto refused = AllOf(HasSubstr("p.txt: the profile runs back and forth near y = "),
                             HasSubstr("of overlapping scans give one"));
  EXPECT_THAT(refusal(columns(twice)), refused);

  Points there_and_back = sampled("60E1", 1);
  for (const Point2 p : reversed(sampled("60E1", 0.83)))
    there_and_back.push_back(p + Point2{0, 0.4});
  EXPECT_THAT(refusal(columns(there_and_back)), refused);

  Points loop; // a large loop without a sharp turn
  for (double t = -2.6; t <= 2.6; t += 0.05)
    loop.push_back({20 * (t - 1.6 * std::sin(t)), 12 * std::cos(t)});
  EXPECT_THAT(refusal(columns(loop)), AllOf(HasSubstr("the profile crosses itself at y = "),
                                            HasSubstr("Remove the points of the loop.")));
}

TEST(Repairs, a_small_loop_is_cut_off) {
  const SaidWarnings warnings;
  Points points = sampled("60E1"), looped = points;
  const Point2 middle = 0.5 * (points[90] + points[91]),
               t = (1 / norm(points[91] - points[90])) * (points[91] - points[90]);
  const Point2 n{-t.z, t.y};
  Points circle;
  for (int i = 0; i <= 8; ++i) { // once round, 0.1 mm in radius, entered and left along the profile
    const double a = -0.3 + i * (2 * std::acos(-1.0) + 0.6) / 8;
    circle.push_back(middle + 0.1 * std::sin(a) * t + (-0.1 * (1 - std::cos(a))) * n);
  }
  looped.insert(looped.begin() + 91, circle.begin(), circle.end());
  const ProfileCurve curve = parse_profile(columns(looped), "p.txt", ProfileKind::rail);
  EXPECT_THAT(warnings.text(), HasSubstr("p.txt: a loop of "));
  double worst = 0;
  const ProfileCurve exact = standard_profile("60E1");
  for (double s = curve.s_begin(); s <= curve.s_end(); s += 0.05)
    worst = std::max(worst, norm(curve.at(s).position - exact.nearest(curve.at(s).position).position));
  EXPECT_LT(worst, 0.02); // the entry and the exit of the loop stay
}

RC_GTEST_PROP(Readers, never_crash_and_never_give_a_number_that_is_none, (const std::string& text)) {
  const SaidWarnings warnings;
  for (const std::string prefix : {"", "point.begin\n", "XYPoints=3\n"}) {
    try {
      const ProfileCurve curve = parse_profile(prefix + text, "p", ProfileKind::rail);
      RC_ASSERT(std::isfinite(curve.s_end()));
    } catch (const InputError&) {
    }
  }
}

// ---------------------------------------------------------------- Simpack

TEST(NamedProfile, of_the_right_kind) {
  EXPECT_EQ(named_profile("60E2", ProfileKind::rail).digest(), standard_profile("60E2").digest());
  EXPECT_THROW(named_profile("S1002", ProfileKind::rail), InputError);
  EXPECT_THROW(named_profile("60E1", ProfileKind::wheel), InputError);
  EXPECT_THAT(message_of([&] { named_profile("60F1", ProfileKind::rail, "somewhere"); }),
              AllOf(HasSubstr("Unknown profile '60F1'"), HasSubstr("there is no file somewhere/60F1"),
                    HasSubstr("Did you mean 60E1")));
}

TEST(ReadProfile, AWheelInPlaceOfARailIsRefused) {
  for (const double y : {1.0, -1.0})
    for (const double z : {1.0, -1.0})
      EXPECT_THAT(
          refusal(columns(mapped(sampled("S1002"), y, z))),
          AllOf(HasSubstr("p.txt is no profile of a rail"), HasSubstr("as on the flange of a wheel")));
  for (const char* rail : {"60E1", "60E2", "54E1", "46E3"})
    EXPECT_EQ(refusal(columns(sampled(rail))), "no error");
}

TEST(NamedProfile, TheOldNamesOfRailsAreKnown) {
  for (const auto& [old, name] : {std::pair{"UIC60", "60E1"}, std::pair{"UIC 54", "54E1"}})
    EXPECT_EQ(named_profile(old, ProfileKind::rail, "somewhere").name(), name);
}

} // namespace
} // namespace bem_contact
