#include "bem_contact/base/error.hpp"
#include "bem_contact/inside/stresses_inside.hpp"
#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/record/hdf5.hpp"
#include "tests/base/message.hpp"
#include "tests/base/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

namespace {

using namespace bem_contact;
using namespace bem_contact::inside;
using halfspace::Stress;
using ::testing::HasSubstr;

/// Hertz's pressure sqrt(1 - x2/a2 - s2/b2) on n x m elements, and friction times it along x; p0 = 1000 MPa.
SurfaceTractions hertz(double a, double b, int columns, int rows, double friction) {
  SurfaceTractions t{.dx = 2 * a / columns, .ds = 2 * b / rows, .x0 = -a + a / columns, .columns = columns};
  for (int row = 0; row < rows; ++row) {
    t.s.push_back(-b + (row + 0.5) * t.ds);
    for (int column = 0; column < columns; ++column) {
      const double x = t.x(column) / a, s = std::isinf(b) ? 0 : t.s.back() / b;
      const double p = 1000 * std::sqrt(std::max(0.0, 1 - x * x - s * s));
      t.pn.push_back(p), t.px.push_back(friction * p), t.ps.push_back(0);
    }
  }
  return t;
}

/// A Hertz line contact along s, 60 half widths long. Its missing ends add P (1 - 2 nu) / (pi 30) to xx,
/// which vanishes for nu = 0.5.
SurfaceTractions line() {
  SurfaceTractions t = hertz(1, 30, 60, 61, 0);
  t.poisson = 0.5;
  for (int row = 0; row < t.rows(); ++row)
    for (int column = 0; column < t.columns; ++column)
      t.pn[static_cast<std::size_t>(row * t.columns + column)] =
          1000 * std::sqrt(1 - t.x(column) * t.x(column));
  return t;
}

/// The largest shear below a line contact: 0.30028 p0 at 0.786 a (Johnson 1985, section 4.2).
TEST(HalfspaceInside, LargestShearOfALine) {
  std::vector<BelowSurface> axis;
  for (double depth = 0.7; depth < 0.9; depth += 0.01)
    axis.push_back({0, depth});
  const StressesInside found = halfspace_inside(line(), Side::rail, axis);
  const Peak shear = peaks_of(found, found.areas.at(0)).shear;
  EXPECT_NEAR(shear.value, 300.28, 0.002 * 300.28);
  EXPECT_NEAR(shear.at.depth, 0.786, 0.02);
  EXPECT_NEAR(shear.x, 0, 0.02) << shear.at.depth << " " << shear.value;
}

/// A circle, nu = 0.28: the largest shear on the axis is 0.3146 p0, 0.47 a deep; von Mises twice that.
TEST(HalfspaceInside, LargestShearBelowACircle) {
  const StressesInside found = halfspace_inside(hertz(2, 2, 41, 41, 0), Side::rail);
  const AreaPeaks p = peaks_of(found, found.areas.at(0));
  EXPECT_NEAR(p.shear.value, 314.6, 0.005 * 314.6);
  EXPECT_NEAR(p.von_mises.value, 629.2, 0.005 * 629.2);
  EXPECT_NEAR(p.shear.at.depth, 0.47 * 2, 0.1);
  EXPECT_GE(p.shear.value.error, std::abs(p.shear.value - 314.6) - 0.3);
  EXPECT_TRUE(std::isnan(p.von_mises_change));
}

/// What a file holds comes back: every tensor, bit by bit.
TEST(StressesInside, ComeBackFromAFile) {
  StressesInside made = halfspace_inside(hertz(2, 1, 12, 8, 0.3), Side::wheel);
  made.body = "wheel";
  AreaStresses& area = made.areas.at(0);
  area.body = area.flat;
  for (Passage& passage : area.body)
    for (Stress& t : passage)
      t.xx += 1;
  area.body.back().front().xx = std::nan("");
  area.error.assign(area.points.size(), 2);
  area.positions.assign(area.points.size(), {1, 2});
  area.curvature = 0.05;
  const TemporaryFolder folder;
  record::write_hdf5(folder.path() / "s.h5",
                     record::Record{{"format", record::Text{stresses_format}}}.append(record_of(made)));
  const StressesInside found = stresses_from(record::read_hdf5(folder.path() / "s.h5"));
  const AreaStresses& back = found.areas.at(0);
  EXPECT_EQ(found.side, Side::wheel);
  EXPECT_EQ(found.body, "wheel");
  EXPECT_EQ(back.section->columns, area.section->columns);
  EXPECT_EQ(back.section->s_knots, area.section->s_knots);
  EXPECT_EQ(back.curvature, 0.05);
  EXPECT_EQ(back.positions, area.positions);
  ASSERT_EQ(back.body.size(), area.body.size());
  for (std::size_t i = 0; i < back.body.size(); ++i)
    for (std::size_t j = 0; j < back.x.size(); ++j) {
      EXPECT_TRUE(back.body[i][j].xx == area.body[i][j].xx || std::isnan(area.body[i][j].xx));
      EXPECT_EQ(back.flat[i][j].sn, area.flat[i][j].sn);
    }
}

TEST(StressesInside, RefuseAnotherFile) {
  EXPECT_THAT(message_of([] {
                stresses_from({{"format", record::Text{result_format}}});
              }),
              HasSubstr("another kind"));
  record::Record file{{"format", record::Text{stresses_format}}};
  file.append(record_of(halfspace_inside(hertz(2, 1, 12, 8, 0.3), Side::rail)));
  EXPECT_EQ(message_of([&] { stresses_from(file); }), "no error");
  record::Record less{{"format", record::Text{stresses_format}}};
  EXPECT_THAT(message_of([&] { stresses_from(less); }), HasSubstr("is missing"));
}

/// Twice the load, twice the stress; the other direction mirrors it.
TEST(HalfspaceInside, ScalesAndMirrors) {
  const SurfaceTractions t = hertz(2, 1, 12, 8, 0.3);
  SurfaceTractions twice = t, back = t;
  for (std::size_t i = 0; i < t.pn.size(); ++i)
    twice.pn[i] *= 2, twice.px[i] *= 2, back.px[i] *= -1;
  const AreaStresses a = halfspace_inside(t, Side::rail).areas.at(0),
                     b = halfspace_inside(twice, Side::rail).areas.at(0),
                     c = halfspace_inside(back, Side::rail).areas.at(0);
  const std::size_t last = a.x.size() - 1;
  for (std::size_t i = 0; i < a.points.size(); ++i)
    for (std::size_t j = 0; j <= last; ++j) {
      EXPECT_NEAR(b.flat[i][j].xx, 2 * a.flat[i][j].xx, 1e-9 * 1000);
      EXPECT_NEAR(c.flat[i][last - j].xx, a.flat[i][j].xx, 1e-7 * 1000);
      EXPECT_NEAR(c.flat[i][last - j].xn, -a.flat[i][j].xn, 1e-7 * 1000);
    }
}

TEST(PointsBelow, AreReadAndRefused) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "p.csv";
  const auto read = [&](const char* text) {
    std::ofstream(file) << text;
    return read_points_below(file);
  };
  const std::vector<BelowSurface> found = read("s,depth\n-3, 0.5 # here\n\n2,0\n");
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].s, -3);
  EXPECT_EQ(found[0].depth, 0.5);
  for (const char* wrong : {"", "s,depth\n", "1\n", "1,2,3\n", "1,-2\n", "nan,1\n", "1;2\n", "1,x\n"})
    EXPECT_THAT(message_of([&] { read(wrong); }), HasSubstr("has no points below a surface")) << wrong;
}

/// A cell between eight points, each with its number; a table line for each point and place.
TEST(StressesInside, AreWrittenForOthers) {
  const StressesInside made = halfspace_inside(hertz(2, 1, 12, 8, 0), Side::rail);
  const AreaStresses& area = made.areas.at(0);
  std::ostringstream grid, table;
  write_vtu(grid, made);
  write_csv(table, made);
  const std::size_t cells = (area.rows - 1) * (area.depths - 1) * (area.x.size() - 1),
                    points = area.points.size() * area.x.size();
  EXPECT_THAT(grid.str(), HasSubstr("NumberOfPoints=\"" + std::to_string(points) + "\" NumberOfCells=\"" +
                                    std::to_string(cells) + "\""));
  EXPECT_THAT(grid.str(), HasSubstr("</VTKFile>"));
  const std::string lines = table.str();
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(lines, '\n')), points + 1);
}

} // namespace
