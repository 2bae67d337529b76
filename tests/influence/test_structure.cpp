// The structural compliance of a strip: what any rigid motion and any symmetric kernel must give, and the
// numbers of expand(), which come another way.
#include "bem_contact/influence/structure.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/influence/expand.hpp"
#include "sample_function.hpp"

#include <gmock/gmock.h>

#include <cmath>

using namespace bem_contact;

namespace {

const Point2 middle{-29.8, 3.9};

/// A structure of any strength. Its 6 x 6 matrices are positive definite at every wavenumber.
InfluenceFunction soft(double strength = 10) {
  InfluenceFunction f = sample_function();
  for (std::size_t k = 0; k < f.wavenumber_count(); ++k)
    for (std::size_t d = 0; d < 6; ++d)
      for (std::size_t a = 0; a < 9; ++a) // six independent rows
        f.remote[k * 54 + d * 9 + a] =
            strength * 5e-8 / (1 + f.wavenumber[k]) * std::sin((1.0 + double(d)) * (2.0 + double(a)));
  for (int i = 0; i < 3; ++i) // a strip as wide as a contact: a turn is not a difference of rounding errors
    f.stations[i].position = {-35 + 5.0 * i, 5 - 1.5 * i * i};
  return f;
}

double scale(const SixBySix& c, int i, int j) {
  return std::sqrt(c[i][i] * c[j][j]);
}

bool along(int m) { // what a section does along x: translation along x, turns about y and z
  return m == 0 || m == 4 || m == 5;
}

/// Two stations of one inclination, 3 mm apart, whose displacements and loads the structure does not tell
/// apart.
InfluenceFunction alike_stations() {
  const InfluenceFunction three = soft();
  InfluenceFunction f = three;
  f.stations.resize(2);
  f.stations[1].delta = f.stations[0].delta;
  f.stations[1].position = f.stations[0].position + Point2{3, 1};
  f.kernel.resize(f.wavenumber_count() * f.kernel_size());
  f.remote.clear();
  for (std::size_t k = 0; k < f.wavenumber_count(); ++k) {
    for (std::size_t a = 0; a < 6; ++a)
      for (std::size_t b = 0; b <= a; ++b)
        f.kernel[f.kernel_index(k, a, b)] =
            (a == b ? 2 : 1) * three.kernel[three.kernel_index(k, a % 3, b % 3)];
    for (std::size_t d = 0; d < 6; ++d)
      for (std::size_t a = 0; a < 6; ++a)
        f.remote.push_back(three.remote[k * 54 + d * 9 + a % 3]);
  }
  return f;
}

} // namespace

TEST(Structure, IsReciprocalAndPositive) {
  const SixBySix c = *structural_compliance(soft(), middle);
  for (int i = 0; i < 6; ++i) {
    EXPECT_GT(c[i][i], 0);
    for (int j = 0; j < 6; ++j) {
      EXPECT_EQ(c[i][j], c[j][i]);
      EXPECT_LE(std::abs(c[i][j]), scale(c, i, j) * (1 + 1e-12));
    }
  }
}

TEST(Structure, MotionAlongAndAcrossTheSectionDoNotMeet) {
  const SixBySix c = *structural_compliance(soft(), middle);
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) {
      if (along(i) != along(j)) {
        EXPECT_NEAR(c[i][j], 0, 1e-12 * scale(c, i, j)) << i << j;
      }
    }
}

TEST(Structure, AnotherPointSeesTheSameRigidMotion) {
  // The same body from another point: forces F' give the moments F' x r more, turns move the point by r.
  const Point2 other{-24.0, -1.5};
  const Point2 r = other - middle;
  const SixBySix c = *structural_compliance(soft(), middle), d = *structural_compliance(soft(), other);
  // motion at `other` = to(motion at `middle`)
  const auto to = [&](const SixNumbers& m) {
    return SixNumbers{m[0] + m[4] * r.z - m[5] * r.y, m[1] - m[3] * r.z, m[2] + m[3] * r.y, m[3], m[4], m[5]};
  };
  const auto back = [&](const SixNumbers& f) { // force at `other`, about `middle`
    return SixNumbers{f[0], f[1], f[2], f[3] + r.y * f[2] - r.z * f[1], f[4] + r.z * f[0], f[5] - r.y * f[0]};
  };
  for (int j = 0; j < 6; ++j) {
    SixNumbers unit{};
    unit[j] = 1;
    const SixNumbers expected = to(product(c, back(unit)));
    for (int i = 0; i < 6; ++i)
      EXPECT_NEAR(d[i][j], expected[i], 1e-9 * scale(d, i, j)) << i << j;
  }
}

TEST(Structure, IsWhatExpandRemoves) {
  // Two stations that move alike: the structure moves them along y and z only, and the compliance, turned
  // into their frame, is the influence number that `removed` takes away, per force.
  const InfluenceFunction f = alike_stations();
  ExpandOptions options{.dx = 10, .offsets = 1, .structural = StructuralCompliance::included};
  const InfluenceNumbers included = expand(f, options);
  options.structural = StructuralCompliance::removed;
  const InfluenceNumbers removed = expand(f, options);
  const Point2 between = 0.5 * (f.stations[0].position + f.stations[1].position);
  const SixBySix c = *structural_compliance(f, between);
  const Point2 directions[] = {tangent_of(f.stations[0].delta), normal_of(f.stations[0].delta)};
  const double area = options.dx * f.station_width;
  const auto taken = [&](int i, int j) { return included.at(0, 0, i, 0, j) - removed.at(0, 0, i, 0, j); };
  for (const int i : {component_s, component_n})
    for (const int j : {component_s, component_n}) {
      const Point2 a = directions[i - 1], b = directions[j - 1];
      const double turned = a.y * (c[1][1] * b.y + c[1][2] * b.z) + a.z * (c[2][1] * b.y + c[2][2] * b.z);
      EXPECT_NEAR(turned * area, taken(i, j), 1e-9 * taken(component_n, component_n)) << i << j;
    }
  EXPECT_NEAR(c[0][0] * area, taken(component_x, component_x), 1e-9 * taken(component_x, component_x));
}

TEST(Structure, GrowsWithTheSquareOfTheRemoteMotion) {
  const SixBySix c = *structural_compliance(soft(1), middle), d = *structural_compliance(soft(3), middle);
  for (int i = 0; i < 6; ++i)
    EXPECT_NEAR(d[i][i], 9 * c[i][i], 1e-12 * d[i][i]);
}

TEST(Structure, ABodyThatDoesNotGiveWayHasNoStiffness) {
  const SixBySix c = *structural_compliance(soft(0), middle);
  for (const SixNumbers& row : c)
    EXPECT_THAT(row, testing::Each(0.0));
  EXPECT_FALSE(inverse(c));
}

TEST(Structure, StiffnessTimesComplianceIsOne) {
  const SixBySix c = *structural_compliance(soft(), middle);
  const auto k = inverse(c);
  ASSERT_TRUE(k);
  for (int j = 0; j < 6; ++j) {
    SixNumbers column{};
    for (int i = 0; i < 6; ++i)
      column[i] = c[i][j];
    const SixNumbers unit = product(*k, column);
    for (int i = 0; i < 6; ++i)
      EXPECT_NEAR(unit[i] * std::sqrt(c[i][i] / c[j][j]), i == j ? 1 : 0, 1e-7) << i << j;
  }
}

TEST(Structure, ATableHoldsNone) {
  InfluenceFunction f = sample_function();
  f.table_dx = 0.5;
  EXPECT_FALSE(structural_compliance(f, middle));
}
