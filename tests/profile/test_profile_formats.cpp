#include "bem_contact/base/error.hpp"
#include "refusal.hpp"
#include "tests/profile/curves.hpp"
#include "warnings.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>

namespace bem_contact {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

std::string simpack(const std::string& flags, const std::string& points, int type = 0) {
  return fmt::format(
      "! a rail\nheader.begin\n version = 1\n type = {} ! 0=rail\nheader.end\nspline.begin\n"
      " comment = 'a = b'\n type = 3\n units.len.f = 1000\n{}\npoint.begin\n{}point.end\nspline.end\n",
      type, flags, points);
}
const std::string bow = "-20 4\n-10 1\n! 5 5\n0 0 1.0\n10 1\n20 4\n";

Point2 first_point(const ProfileCurve& curve) {
  return curve.at(curve.s_begin()).position;
}
ProfileCurve rail_of(const std::string& text) {
  return parse_profile(text, "p.prr", ProfileKind::rail);
}
void expect_near(Point2 a, Point2 b) {
  EXPECT_LT(norm(a - b), 1e-9) << a.y << " " << a.z;
}

TEST(Simpack, comments_begin_with_either_mark) {
  std::string text = simpack("shift.y = 3 % to the field side", "% measured\n" + std::string(bow));
  expect_near(first_point(rail_of(text)), {-17, 4});
}

TEST(Simpack, every_flag) {
  const SaidWarnings warnings;
  expect_near(first_point(rail_of(simpack("", bow))), {-20, 4});
  expect_near(first_point(rail_of(simpack("shift.y = 3\nshift.z = -0.5", bow))), {-17, 3.5});
  // about x from y towards z, after the shift
  expect_near(first_point(rail_of(simpack("rotate = 0.1", bow))),
              {-20 * std::cos(0.1) - 4 * std::sin(0.1), -20 * std::sin(0.1) + 4 * std::cos(0.1)});
  expect_near(first_point(rail_of(simpack("rotate = 9\nunits.ang.f = 57.29577951308232", bow))),
              first_point(rail_of(simpack("rotate = 0.15707963267948966", bow))));
  expect_near(first_point(rail_of(simpack("bound.y.min = -15\nbound.y.max = 15", bow))), {-10, 1});
  expect_near(first_point(rail_of(simpack("bound.z.min = -1\nbound.z.max = 2", bow))), {-10, 1});
  expect_near(first_point(rail_of(simpack("bound.y.min = 1\nbound.y.max = 0", bow))), {-20, 4}); // off
  expect_near(first_point(rail_of(simpack("units.len.f = 1", "-.02 .004\n-.01 .001\n0 0\n.01 .001\n"))),
              {-20, 4});
  expect_near(first_point(rail_of(simpack("point.dist.min = 15", bow))), {-20, 4});
  EXPECT_THAT(warnings.text(), IsEmpty());
}

TEST(Simpack, mirrors_and_inversion) {
  const SaidWarnings warnings;
  const std::string lopsided = "-30 9\n-10 1\n0 0\n10 1\n20 4\n";
  expect_near(first_point(rail_of(simpack("mirror.y = 1\ninversion = 1", lopsided))), {-20, 4});
  expect_near(first_point(rail_of(simpack("mirror.z = 1", "-20 -4\n-10 -1\n0 0\n10 -1\n20 -4\n"))), {-20, 4});
  EXPECT_THAT(warnings.text(), IsEmpty()); // the flags say all, nothing is left to repair
}

TEST(Simpack, points_of_no_weight_do_not_count) {
  const ProfileCurve curve = rail_of(simpack("", "-20 4\n-10 1\n-5 3 0.0\n0 0\n10 1\n20 4\n"));
  EXPECT_LT(norm(curve.nearest({-5, 0.25}).position - Point2{-5, 0.25}), 0.01);
}

TEST(Simpack, refusals) {
  EXPECT_THAT(refusal(simpack("approx.smooth = 0.5", bow)),
              HasSubstr("p.txt: approx.smooth = 0.5 (smoothing would"));
  EXPECT_THAT(refusal(simpack("mirror.y = 2", bow)), HasSubstr("mirror.y = 2 (it is a switch) Give 0 or 1."));
  EXPECT_THAT(refusal(simpack("units.len.f = 0", bow)), HasSubstr("a unit factor is positive"));
  EXPECT_THAT(refusal(simpack("", bow, 1)),
              HasSubstr("p.txt is the profile of a wheel (its header says type = 1"));
  EXPECT_THAT(refusal(simpack("", "-20 4\n0 NaN\n20 4\n")), HasSubstr("a coordinate is not a number"));
  EXPECT_THAT(refusal(simpack("", "-20 4\n0 0 1 7\n20 4\n")), HasSubstr("is not a point"));
  EXPECT_THAT(refusal(simpack("", "")), HasSubstr("p.txt has 0 points"));
  const std::string whole = simpack("", bow);
  EXPECT_THAT(refusal(whole.substr(0, whole.find("20 4\npoint.end"))),
              HasSubstr("has no point.end (the file is truncated)"));
  EXPECT_THAT(refusal(whole.substr(0, whole.find("point.begin"))), HasSubstr("has no point.begin"));
}

// ---------------------------------------------------------------- MiniProf

TEST(MiniProf, both_variants_and_stray_quotes) {
  const SaidWarnings warnings;
  const std::string points = "\"-20\t-4\"\n\"-10\t-1\n 0 0\n10 -1\n30 -9\n"; // z up, y mirrored
  for (const std::string& header : {std::string("Filename=a.ban\nXYPoints=5\nXOffset=0.0\n\n"),
                                    std::string("#MINIWHEELPROF 1.0\nsome title\n\n")}) {
    const ProfileCurve curve = rail_of(header + points);
    expect_near(first_point(curve), {-30, 9});
    expect_near(curve.at(curve.s_end()).position, {20, 4});
  }
  EXPECT_THAT(warnings.text(), HasSubstr("z points up"));
}

TEST(MiniProf, columns_by_name) {
  const SaidWarnings warnings;
  const ProfileCurve curve = rail_of("XYPoints=4\nColumnDef=N,Y,X\n\n1 4 -20\n2 1 -10\n3 0 0\n4 4 20\n");
  expect_near(first_point(curve), {-20, 4});
}

TEST(MiniProf, a_truncated_file_is_refused) {
  EXPECT_THAT(
      refusal("XYPoints=5\n\n-20 4\n-10 1\n0 0\n10 1\n"),
      HasSubstr("p.txt has 4 points (its header says XYPoints=5; the file is truncated or was altered)"));
  EXPECT_THAT(refusal("XYPoints=3\n\n-20 4\n-10\n0 0\n"), HasSubstr("p.txt:4: '-10' is not a point"));
  EXPECT_THAT(refusal("XYPoints=3\n\n-20 4\n-10 nan\n0 0\n"), HasSubstr("a coordinate is not a number"));
}

TEST(MiniProf, offsets_are_not_applied_in_silence) {
  const SaidWarnings warnings;
  rail_of("XYPoints=4\nXOffset=2.5\n\n-20 4\n-10 1\n0 0\n20 4\n");
  EXPECT_THAT(warnings.text(), HasSubstr("warning: p.prr: XOffset = 2.5 is not applied"));
}

// ---------------------------------------------------------------- by name

} // namespace
} // namespace bem_contact
