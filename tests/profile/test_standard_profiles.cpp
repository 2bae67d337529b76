#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "tests/profile/s1002_formula.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <numbers>

namespace bem_contact {
namespace {

using testing::HasSubstr;

using std::numbers::pi;

TEST(S1002, is_the_formula_on_the_tread_and_within_the_joints_jumps_elsewhere) {
  const ProfileCurve curve = standard_profile("S1002");
  double tread = 0, flange = 0;
  for (double s = curve.s_begin(); s <= curve.s_end(); s += 0.037) {
    const Point2 p = curve.at(s).position;
    if (p.y < -69.9)
      continue; // vertical there
    double& worst = p.y > -26 && p.y < 32.15 ? tread : flange;
    worst = std::max(worst, std::abs(p.z - s1002_height(p.y)));
  }
  EXPECT_LT(tread, 1e-11);
  EXPECT_LT(flange, 8.3e-5);
  EXPECT_GT(flange, 3e-5); // the jump at y = -26 is there and was taken up
}

TEST(S1002, known_points) {
  EXPECT_NEAR(s1002_height(0), 0, 1e-15);
  EXPECT_NEAR(s1002_height(-55), 28, 1e-12);       // the tip of the flange
  EXPECT_NEAR(s1002_height(60), -2.6356764, 5e-8); // published point list
  EXPECT_NEAR(s1002_height(-70), 9.519259302, 1e-12);
}

TEST(S1002, the_formulas_jump_by_what_the_reference_says) {
  const auto jump = [](double y) { return std::abs(s1002_height(y + 1e-9) - s1002_height(y - 1e-9)); };
  EXPECT_NEAR(jump(-35), 1.2e-4, 5e-6);
  EXPECT_NEAR(jump(-26), 3.7e-5, 1e-6);
  for (const double y : {32.15796, -38.426669071, -39.764473993, -49.662510381, -62.764705882})
    EXPECT_LT(jump(y), 1e-6) << y;
}

TEST(S1002, is_walked_from_the_field_side_with_the_material_above) {
  const ProfileCurve curve = standard_profile("S1002");
  EXPECT_NEAR(curve.at(curve.s_begin()).position.y, 60, 1e-9);
  EXPECT_NEAR(curve.at(curve.s_end()).position.y, -70, 1e-6);
  const CurvePoint tape = curve.at(0);
  EXPECT_NEAR(tape.position.y, 0, 1e-12);
  EXPECT_NEAR(tape.position.z, 0, 1e-12);
  EXPECT_NEAR(std::tan(tape.delta), -3.358537058e-2, 1e-14); // dz/dy
  EXPECT_NEAR(tape.delta, pi, 0.04);
  EXPECT_LT(normal_of(tape.delta).z, 0);
}

TEST(S1002, curvature_zone_by_zone) {
  const ProfileCurve curve = standard_profile("S1002");
  const auto at_y = [&](double y) { return curve.nearest({y, s1002_height(y)}); };
  EXPECT_NEAR(at_y(45).curvature, 0, 1e-15);
  EXPECT_NEAR(at_y(-37).curvature, -1 / 13.0, 1e-12); // the flange root is concave
  EXPECT_NEAR(at_y(-39).curvature, 0, 1e-15);
  EXPECT_NEAR(at_y(-39).delta, pi - std::atan(2.747477419), 1e-9); // 70 degrees
  EXPECT_NEAR(at_y(-45).curvature, 1 / 20.0, 1e-12);
  EXPECT_NEAR(at_y(-55).curvature, 1 / 12.0, 1e-12);
  EXPECT_NEAR(at_y(-55).delta, pi, 1e-9);
  EXPECT_NEAR(at_y(-65).curvature, 1 / 20.5, 1e-12);
  // z'' = 2 * 1.565681624e-3 at y = 0; walked towards -y, d(delta)/ds = -z''/(1 + z'^2)^1.5
  EXPECT_NEAR(at_y(0).curvature, -2 * 1.565681624e-3 / std::pow(1 + std::pow(3.358537058e-2, 2), 1.5), 1e-14);
}

TEST(Rails, are_symmetric_walked_from_the_gauge_side_with_the_material_below) {
  for (const char* name : {"60E1", "60E2", "54E1", "46E3"}) {
    const ProfileCurve curve = standard_profile(name);
    EXPECT_NEAR(curve.s_begin(), -curve.s_end(), 1e-10);
    EXPECT_LT(curve.at(curve.s_begin()).position.y, -35);
    EXPECT_NEAR(curve.at(0).delta, 0, 1e-12);
    EXPECT_NEAR(norm(curve.at(0).position), 0, 1e-12);
    for (double s = 0; s < curve.s_end(); s += 0.71) {
      const CurvePoint right = curve.at(s), left = curve.at(-s);
      EXPECT_NEAR(right.position.y, -left.position.y, 1e-10);
      EXPECT_NEAR(right.position.z, left.position.z, 1e-10);
      EXPECT_NEAR(right.delta, -left.delta, 1e-10);
    }
  }
}

TEST(Rails, delta_is_continuous_over_the_tangent_joints) {
  for (const char* name : {"60E1", "60E2", "54E1", "46E3"}) {
    const ProfileCurve curve = standard_profile(name);
    for (double s = curve.s_begin(); s + 1e-3 < curve.s_end(); s += 1e-3)
      ASSERT_LT(std::abs(curve.at(s + 1e-3).delta - curve.at(s).delta), 1e-3 / 8 + 2e-5) << name << " " << s;
  }
}

TEST(Rails, radii_of_60E1) {
  const ProfileCurve curve = standard_profile("60E1");
  const auto curvature_at = [&](Point2 p) { return curve.nearest(p).curvature; };
  EXPECT_NEAR(curvature_at({5, 0.04}), 1 / 300.0, 1e-15);
  EXPECT_NEAR(curvature_at({-20, 1.3}), 1 / 80.0, 1e-15);
  EXPECT_NEAR(curvature_at({-33, 6.7}), 1 / 13.0, 1e-15);
  EXPECT_NEAR(curve.at(curve.s_end()).delta, std::atan(20.0), 2e-5);
}

TEST(StandardProfile, an_unknown_name_is_answered_with_the_nearest) {
  try {
    standard_profile("S1oo2");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "Unknown profile 'S1oo2' (it is none of the built-in ones) Did you mean S1002? (`bem_contact "
        "profile --list` prints all)");
  }
}

BodyFile body(BodyKind kind) {
  BodyFile file;
  file.body.kind = kind;
  file.body.radius = 10;
  file.body.size = 40;
  return file;
}

TEST(BodyProfile, a_disc_is_an_upper_body) {
  const ProfileCurve disc = body_profile(body(BodyKind::disc));
  for (double s = -15.7; s < 15.7; s += 0.3) {
    const CurvePoint p = disc.at(s);
    EXPECT_NEAR(norm(p.position), 10, 1e-13);
    EXPECT_NEAR(p.delta, pi + s / 10, 1e-13);
    EXPECT_EQ(p.curvature, 0.1);
    EXPECT_NEAR(dot(normal_of(p.delta), p.position), -10, 1e-12); // the material is inside
  }
  EXPECT_NEAR(norm(disc.at(0).position - Point2{0, 10}), 0, 1e-14);
}

TEST(BodyProfile, a_bore_is_a_lower_body) {
  const ProfileCurve bore = body_profile(body(BodyKind::bore));
  for (double s = -15.7; s < 15.7; s += 0.3) {
    const CurvePoint p = bore.at(s);
    EXPECT_NEAR(p.position.y, 10 * std::sin(s / 10), 1e-13);
    EXPECT_NEAR(p.position.z, 10 * std::cos(s / 10), 1e-13);
    EXPECT_NEAR(p.delta, -s / 10, 1e-13);
    EXPECT_EQ(p.curvature, -0.1);
    EXPECT_NEAR(dot(normal_of(p.delta), p.position), 10, 1e-12); // the material is outside
  }
}

TEST(BodyProfile, a_block_is_flat) {
  const ProfileCurve block = body_profile(body(BodyKind::block));
  EXPECT_EQ(block.s_begin(), -40);
  EXPECT_EQ(block.s_end(), 40);
  EXPECT_EQ(block.at(12.5).position.y, 12.5);
  EXPECT_EQ(block.at(12.5).position.z, 0);
  EXPECT_EQ(block.at(12.5).delta, 0);
  EXPECT_EQ(block.nearest({3, -7}).s, 3);
}

TEST(BodyProfile, rails_and_wheels_by_name_or_file) {
  BodyFile file = body(BodyKind::rail);
  EXPECT_EQ(body_profile(file).digest(), standard_profile("60E1").digest());
  file = body(BodyKind::wheel);
  EXPECT_THROW(body_profile(file), InputError); // 60E1 is no wheel
  file.body.profile = "S1002";
  EXPECT_EQ(body_profile(file).digest(), standard_profile("S1002").digest());

  file = body(BodyKind::rail);
  file.folder = testing::TempDir();
  file.body.profile = "body_profile_test.txt";
  std::ofstream out(file.folder / file.body.profile);
  for (int i = -20; i <= 20; ++i)
    out << i << " " << 0.01 * i * i << "\n";
  out.close();
  EXPECT_NEAR(body_profile(file).at(0).curvature, 0.02, 1e-4);
  std::filesystem::remove(file.folder / file.body.profile);
}

} // namespace
} // namespace bem_contact
