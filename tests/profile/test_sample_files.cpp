// The published files of the Manchester contact benchmark, where they are at hand.
#include "bem_contact/profile/standard_profiles.hpp"
#include "tests/profile/curves.hpp"
#include "tests/profile/s1002_formula.hpp"
#include "warnings.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <filesystem>

namespace bem_contact {
namespace {

std::filesystem::path sample(const std::string& name) {
  return std::filesystem::path(CONFORMAL_SOURCE_DIR) / ".." / "shared" / "data" / "profiles" / name;
}

#define SKIP_WITHOUT(name)                                                                                   \
  if (!std::filesystem::exists(sample(name)))                                                                \
  GTEST_SKIP() << "the sample file " << name << " is not at hand"

TEST(SampleFiles, the_S1002_point_list_is_the_formula) {
  SKIP_WITHOUT("MBench_S1002_v3.prw");
  const SaidWarnings warnings;
  const ProfileCurve curve = read_profile(sample("MBench_S1002_v3.prw"), ProfileKind::wheel);
  EXPECT_THAT(warnings.text(), testing::IsEmpty());
  const ProfileCurve exact = standard_profile("S1002");
  EXPECT_NEAR(curve.at(curve.s_begin()).position.y, 60, 1e-9);
  double at_points = 0, tread = 0, tread_delta = 0, tread_curvature = 0, all = 0;
  for (double s = curve.s_begin(); s <= curve.s_end(); s += 0.05) {
    const CurvePoint p = curve.at(s), q = exact.nearest(p.position);
    all = std::max(all, norm(p.position - q.position));
    if (std::abs(p.position.y) < 25) {
      at_points = std::max(at_points, std::abs(p.position.z - s1002_height(p.position.y)));
      tread = std::max(tread, norm(p.position - q.position));
      tread_delta = std::max(tread_delta, std::abs(p.delta - q.delta));
      tread_curvature = std::max(tread_curvature, std::abs(p.curvature - q.curvature));
    }
  }
  EXPECT_LT(at_points, 1.6e-6);
  EXPECT_LT(tread, 1.6e-6);
  EXPECT_LT(tread_delta, 5e-6);
  EXPECT_LT(tread_curvature, 1e-4);
  EXPECT_LT(all, 3e-4); // the list's spacing where the curvature jumps
}

TEST(SampleFiles, the_wheel_is_no_rail) {
  SKIP_WITHOUT("MBench_S1002_v3.prw");
  EXPECT_ANY_THROW(read_profile(sample("MBench_S1002_v3.prw"), ProfileKind::rail));
}

/// Distance of a point, in the rail's own frame, from the UIC60 v3 zones: R300, R80, R13, flank.
struct Zone {
  int index;
  double distance;
};
Zone uic60_v3(Point2 p) {
  const double y = std::abs(p.y);
  if (y < 10.5)
    return {0, std::abs(norm(p - Point2{0, 300}) - 300)};
  if (y < 25.9880)
    return {1, std::abs(norm(Point2{y - 7.7, p.z - 80.1348}) - 80)};
  const double end = 14.9089 - 13 / std::sqrt(401.0); // where R13 is as steep as 1:20
  if (p.z < end)
    return {2, std::abs(norm(Point2{y - 23.0162, p.z - 14.9089}) - 13)};
  return {3, std::abs(y - 36.0 - (p.z - end) / 20)};
}

TEST(SampleFiles, the_UIC60_v3_point_lists_are_what_is_known_of_them) {
  for (const char* name : {"MBench_UIC60_v3.prr", "MBench_UIC60_v3.ban"}) {
    SKIP_WITHOUT(name);
    const SaidWarnings warnings;
    const ProfileCurve curve = read_profile(sample(name), ProfileKind::rail);
    EXPECT_THAT(warnings.text(), testing::HasSubstr("29 doubled or crowded points dropped"));
    std::array<double, 4> worst{};
    std::array<int, 4> count{};
    const double cant = std::atan(1 / 40.0);
    for (double s = curve.s_begin(); s <= curve.s_end(); s += 0.05) {
      const Point2 p = curve.at(s).position;
      const Point2 own = Point2{7.4917, 0.0937} + p.y * tangent_of(cant) + p.z * normal_of(cant);
      if (own.z > 33)
        continue;
      const auto [zone, distance] = uic60_v3(own);
      worst[static_cast<std::size_t>(zone)] = std::max(worst[static_cast<std::size_t>(zone)], distance);
      ++count[static_cast<std::size_t>(zone)];
    }
    EXPECT_LT(worst[0], 2e-4); // the origin is known to 1e-4
    EXPECT_LT(worst[1], 2e-4);
    EXPECT_LT(worst[2], 1e-3);
    EXPECT_LT(worst[3], 2e-3); // the spline at the jump of curvature into the flank
    for (const int n : count)
      EXPECT_GT(n, 100);
  }
}

TEST(SampleFiles, Simpack_and_MiniProf_tell_the_same_rail) {
  SKIP_WITHOUT("MBench_UIC60_v3.ban");
  const SaidWarnings warnings;
  EXPECT_EQ(read_profile(sample("MBench_UIC60_v3.prr"), ProfileKind::rail).digest(),
            read_profile(sample("MBench_UIC60_v3.ban"), ProfileKind::rail).digest());
}

TEST(SampleFiles, UIC60_v3_is_not_60E1) {
  SKIP_WITHOUT("MBench_UIC60_v3.prr");
  const SaidWarnings warnings;
  const ProfileCurve curve = read_profile(sample("MBench_UIC60_v3.prr"), ProfileKind::rail);
  const ProfileCurve exact = standard_profile("60E1");
  const double cant = std::atan(1 / 40.0);
  double worst = 0;
  for (double s = curve.s_begin(); s <= curve.s_end(); s += 0.05) {
    const Point2 p = curve.at(s).position;
    const Point2 own = Point2{7.4917, 0.0937} + p.y * tangent_of(cant) + p.z * normal_of(cant);
    if (own.z < 30)
      worst = std::max(worst, norm(exact.nearest(own).position - own));
  }
  // R13 is centred 14.9491 - 14.9089 mm higher; it begins where its inclination is asin(3.0105/13).
  EXPECT_NEAR(worst, 0.0402 * std::sqrt(1 - std::pow(3.0105 / 13, 2)), 1e-3);
}

} // namespace
} // namespace bem_contact
