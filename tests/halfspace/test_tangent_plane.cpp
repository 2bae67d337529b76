#include "bem_contact/halfspace/tangent_plane.hpp"

#include "bem_contact/halfspace/combine.hpp"
#include "bem_contact/halfspace/flat_strip.hpp"
#include "steel.hpp"
#include "tests/reference/conformal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace bem_contact::halfspace {
namespace {

/// Rows ds wide about s = 0 on a circle; radius > 0 convex, < 0 concave.
std::vector<ContactRow> arc(double radius, double ds, int count) {
  std::vector<ContactRow> rows;
  for (int i = 0; i < count; ++i) {
    const double angle = (i - 0.5 * (count - 1)) * ds / radius;
    rows.push_back({0, {radius * std::sin(angle), radius * (1 - std::cos(angle))}, angle});
  }
  return rows;
}

TEST(TangentPlane, OnAFlatStripIsTheHalfSpace) {
  std::vector<ContactRow> rows;
  for (int i = 0; i < 5; ++i)
    rows.push_back({0, {0.3 * i, 0}, 0});
  const InfluenceNumbers flat = influence_numbers(steel, 0.5, 0.3, 4, 5);
  const InfluenceNumbers plane = plane_strain_numbers(steel, 0.3, 5, 100);
  const InfluenceNumbers a = tangent_plane_numbers(steel, {0.5, 0.3, 4}, rows);
  const InfluenceNumbers b = tangent_plane_numbers(steel, {0, 0.3}, rows);
  EXPECT_TRUE(a.translational);
  for (int row_i = 0; row_i < 5; ++row_i)
    for (int row_j = 0; row_j < 5; ++row_j)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          for (int m = 0; m < 4; ++m)
            EXPECT_NEAR(a.at(m, row_i, i, row_j, j), flat.at(m, row_i, i, row_j, j),
                        1e-12 * flat.at(0, 0, 2, 0, 2));
          EXPECT_NEAR(b.at(0, row_i, i, row_j, j), plane.at(0, row_i, i, row_j, j),
                      1e-12 * plane.at(0, 0, 2, 0, 2));
        }
}

/// The turn of the whole strip in its section changes nothing, and rows of a circle are translational: the
/// same rows, the last inclined by a hair more, are not, and give the same numbers.
TEST(TangentPlane, DependsOnRelativePositionsOnly) {
  const std::vector<ContactRow> rows = arc(10, 0.8, 7);
  std::vector<ContactRow> turned = rows, nearly = rows;
  const double angle = 0.7;
  for (ContactRow& row : turned)
    row = {0, row.position.y * tangent_of(angle) + row.position.z * normal_of(angle), row.delta + angle};
  nearly.back().delta += 1e-9;
  const InfluenceNumbers a = tangent_plane_numbers(steel, {0.5, 0.8, 3}, rows);
  const InfluenceNumbers b = tangent_plane_numbers(steel, {0.5, 0.8, 3}, turned);
  const InfluenceNumbers c = tangent_plane_numbers(steel, {0.5, 0.8, 3}, nearly);
  EXPECT_TRUE(a.translational);
  EXPECT_FALSE(c.translational);
  for (int m = 0; m < 3; ++m)
    for (int row_i = 0; row_i < 7; ++row_i)
      for (int row_j = 0; row_j < 7; ++row_j)
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j) {
            EXPECT_NEAR(a.at(m, row_i, i, row_j, j), b.at(m, row_i, i, row_j, j),
                        1e-12 * a.at(0, 0, 2, 0, 2));
            EXPECT_NEAR(a.at(m, row_i, i, row_j, j), c.at(m, row_i, i, row_j, j), 1e-8 * a.at(0, 0, 2, 0, 2));
          }
}

/// Michell 1899: pressures cos(n theta) on a whole disc in a whole hole, and shear sin(n theta), of the pair.
TEST(TangentPlane, MichellsPair) {
  const double radius = 10;
  const int count = 360;
  const double ds = 2 * std::numbers::pi * radius / count;
  const std::vector<ContactRow> hole = arc(-radius, ds, count);
  std::vector<ContactRow> disc = hole; // the upper body's own frame is turned by pi about x
  for (ContactRow& row : disc)
    row.position = -1.0 * row.position;
  const InfluenceNumbers pair = combine(tangent_plane_numbers(steel, {0, ds, 1, radius}, hole),
                                        tangent_plane_numbers(steel, {0, ds, 1, radius}, disc));
  for (const int n : {0, 2, 3, 5}) {
    const auto exact = reference::michell_pair(steel, radius, n);
    for (const int row : {count / 2, count / 2 + 25, 17}) {
      const auto angle = [&](int i) { return (i - 0.5 * (count - 1)) * ds / radius; };
      double normal = 0, along = 0, mixed = 0;
      for (int j = 0; j < count; ++j) {
        normal += pair.at(0, row, component_n, j, component_n) * std::cos(n * angle(j));
        along += pair.at(0, row, component_s, j, component_s) * std::sin(n * angle(j));
        mixed += pair.at(0, row, component_s, j, component_n) * std::cos(n * angle(j));
      }
      const double scale = 1e-3 * std::abs(exact[0][0]);
      EXPECT_NEAR(normal, exact[0][0] * std::cos(n * angle(row)), scale) << n;
      if (n > 0) {
        EXPECT_NEAR(along, -exact[1][1] * std::sin(n * angle(row)), scale) << n;
        EXPECT_NEAR(mixed, exact[1][0] * std::sin(n * angle(row)), scale) << n;
      }
    }
  }
}

/// Rows on two arcs, as on a rail's head: most chords at equal distances in rows differ.
std::vector<ContactRow> two_arcs(int count) {
  std::vector<ContactRow> rows{{0, {0, 0}, 0}};
  for (int i = 1; i < count; ++i) {
    const double turn = 0.4 / (i < count / 3 ? 80.0 : 13.0), delta = rows.back().delta;
    rows.push_back({0, rows.back().position + 0.4 * tangent_of(delta + 0.5 * turn), delta + turn});
  }
  return rows;
}

/// Pairs whose chords differ a little share lines by interpolation: each pair alone has the same numbers.
TEST(TangentPlane, SharedLinesAreThoseOfEachPair) {
  const std::vector<ContactRow> rows = two_arcs(30);
  const InfluenceNumbers all = tangent_plane_numbers(steel, {0.5, 0.4, 8}, rows);
  ASSERT_FALSE(all.translational);
  for (const int row_i : {3, 12, 29})
    for (const int row_j : {0, 2, 9, 11}) {
      if (row_j >= row_i)
        continue;
      const std::vector<ContactRow> two{rows[row_j], rows[row_i]};
      const InfluenceNumbers pair = tangent_plane_numbers(steel, {0.5, 0.4, 8}, two);
      for (int m = 0; m < 8; ++m)
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            EXPECT_NEAR(all.at(m, row_i, i, row_j, j), pair.at(m, 1, i, 0, j),
                        1e-6 * std::abs(pair.at(m, 1, 2, 0, 2)));
    }
}

/// Opposite rows of the other body, which runs against the first one, and rows of a later strip take the same
/// lines: their number grows with the rows, not with their pairs.
TEST(TangentPlane, BothBodiesAndLaterStripsShareLines) {
  const std::vector<ContactRow> rows = two_arcs(60);
  std::vector<ContactRow> other = rows;
  for (ContactRow& row : other)
    row.position = -1.0 * row.position;
  LineStore lines;
  tangent_plane_numbers(steel, {0.5, 0.4, 8}, rows, &lines);
  const std::size_t first = lines.size();
  EXPECT_LT(first, 6 * rows.size()) << "1770 pairs";
  tangent_plane_numbers(steel, {0.5, 0.4, 8}, other, &lines);
  EXPECT_EQ(lines.size(), first);
}

TEST(TangentPlane, RefusesAnEmptyStrip) {
  EXPECT_ANY_THROW(tangent_plane_numbers(steel, {0.5, 0.3, 4}, {}));
}

} // namespace
} // namespace bem_contact::halfspace
