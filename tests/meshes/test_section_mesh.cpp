#include "bem_contact/profile/bodies/body_file.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "mesh_checks.hpp"
#include "meshes/section_mesh.hpp"
#include "meshes/write_msh.hpp"
#include "tests/base/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>
#include <set>

namespace bem_contact::meshes {
namespace {

using std::numbers::pi;

double distance_to_strip(const std::vector<Point2>& strip, Point2 p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& vertex : strip)
    nearest = std::min(nearest, norm(vertex - p));
  return nearest;
}

void expect_strip_on_profile(const BodyFile& body, const QuadMesh& mesh) {
  const ProfileCurve profile = body_profile(body);
  const auto vertices = strip_vertices(mesh);
  const double step = body.strip.station_width / body.mesh.elements_per_station;
  const auto edges = static_cast<std::size_t>(std::lround((body.strip.to - body.strip.from) / step));
  ASSERT_EQ(vertices.size(), edges + 1);
  for (std::size_t i = 0; i <= edges; ++i) {
    const double s = std::min(body.strip.from + static_cast<double>(i) * step, body.strip.to);
    EXPECT_LT(norm(vertices[i] - profile.at(s).position), 1e-9) << "vertex " << i;
  }
}

/// Where the worn profiles lie is known: in the standard's own frame.
BodyFile body_in_its_frame(const std::string& name) {
  BodyFile body = read_body_file(body_folder() / (name + ".toml"));
  body.body.graft_at = Point2{};
  return body;
}

class Bodies : public testing::TestWithParam<const char*> {
protected:
  const BodyFile body = body_in_its_frame(GetParam());
  const QuadMesh mesh = mesh_section(body);
};

TEST_P(Bodies, StripVerticesLieOnTheProfileAtTheStations) {
  expect_strip_on_profile(body, mesh);
}

TEST_P(Bodies, HaveGoodQuadrilaterals) {
  const Quality q = quality(mesh);
  EXPECT_GE(q.smallest, poor_quality);
  EXPECT_GE(q.mean, 0.8);
}

TEST_P(Bodies, HaveEveryEdgeInTwoQuadsOrOnTheBoundary) {
  const auto edges = directed_edges(mesh);
  std::set<std::pair<int, int>> boundary;
  for (const auto& edge : mesh.boundary)
    EXPECT_TRUE(boundary.insert({edge.vertices[0], edge.vertices[1]}).second);
  std::size_t alone = 0;
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    if (!edges.contains({edge.second, edge.first})) {
      ++alone;
      EXPECT_TRUE(boundary.contains(edge)); // also walked the same way: the material is on its left
    }
  }
  EXPECT_EQ(alone, mesh.boundary.size());
  // Euler: vertices - edges + quads = 1 - holes
  const auto edge_count = (edges.size() + alone) / 2;
  const long holes = body.body.kind == BodyKind::disc || body.body.kind == BodyKind::bore ? 1 : 0;
  EXPECT_EQ(static_cast<long>(mesh.points.size() + mesh.quads.size()) - static_cast<long>(edge_count),
            1 - holes);
}

TEST_P(Bodies, HaveAllGroups) {
  const double stations = (body.strip.to - body.strip.from) / body.strip.station_width;
  EXPECT_EQ(static_cast<long>(edges_of(mesh, Group::contact).size()),
            std::lround(stations) * body.mesh.elements_per_station);
  EXPECT_GE(edges_of(mesh, Group::held).size(), 4u);
  EXPECT_GE(edges_of(mesh, Group::free).size(), 4u);
  const double height = body.body.profile == "54E1" ? 159 : body.body.profile == "46E3" ? 142 : 172;
  double held_z = 0; // of an outline: that of its one held piece
  for (const auto& piece : body.body.outline)
    held_z = piece.group == PieceGroup::held ? piece.to.z : held_z;
  for (const auto& edge : edges_of(mesh, Group::held)) {
    const Point2 p = point(mesh, edge.vertices[0]);
    const double a = body.body.size;
    if (body.body.kind == BodyKind::rail)
      EXPECT_NEAR(p.z, height, 1e-9);
    else if (body.body.kind == BodyKind::wheel)
      EXPECT_NEAR(p.z, 92.5 - 460, 1e-9);
    else if (body.body.kind == BodyKind::block)
      EXPECT_NEAR(p.z, a, 1e-9);
    else if (body.body.kind == BodyKind::disc)
      EXPECT_NEAR(norm(p), 0.05 * body.body.radius, 1e-12);
    else if (body.body.kind == BodyKind::outline)
      EXPECT_NEAR(p.z, held_z, 1e-9);
    else
      EXPECT_NEAR(std::max(std::abs(p.y), std::abs(p.z)), a, 1e-9);
  }
}

TEST_P(Bodies, AreGradedToTheStrip) {
  const auto strip = strip_vertices(mesh);
  const double h_strip = body.strip.station_width / body.mesh.elements_per_station;
  std::size_t larger = 0;
  for (const auto& quad : mesh.quads) {
    const Point2 a = point(mesh, quad[0]), b = point(mesh, quad[1]), c = point(mesh, quad[2]),
                 d = point(mesh, quad[3]);
    const Point2 u = c - a, v = d - b, centre = 0.25 * (a + b + c + d);
    const double h = std::sqrt((u.y * v.z - u.z * v.y) / 2);
    const double allowed =
        std::min(body.mesh.largest, h_strip + body.mesh.grading * distance_to_strip(strip, centre));
    ASSERT_LE(h, 1.1 * allowed) << "near " << centre.y << " " << centre.z;
    larger += h > allowed;
  }
  EXPECT_LE(larger, mesh.quads.size() / 500);
}

TEST_P(Bodies, ResolveArcsToTenDegreesAnEdge) {
  // The next edge turns by at most 10 degrees, unless it begins at a corner or where the strip meets the
  // rest.
  constexpr double most = 10 * pi / 180, corner = 15 * pi / 180;
  for (std::size_t i = 0; i + 1 < mesh.boundary.size(); ++i) {
    const auto &e = mesh.boundary[i], &f = mesh.boundary[i + 1];
    if (e.vertices[1] != f.vertices[0])
      continue; // another loop
    const Point2 a = point(mesh, e.vertices[1]) - point(mesh, e.vertices[0]);
    const Point2 b = point(mesh, f.vertices[1]) - point(mesh, f.vertices[0]);
    const double turn = std::abs(std::atan2(a.y * b.z - b.y * a.z, dot(a, b)));
    EXPECT_TRUE(turn <= most || turn >= corner)
        << turn * 180 / pi << " degrees near " << point(mesh, e.vertices[1]).y << " "
        << point(mesh, e.vertices[1]).z;
  }
}

TEST_P(Bodies, HaveTheSectionsArea) {
  EXPECT_NEAR(quality(mesh).area / mesh.section_area, 1, 2.5e-3);
}

INSTANTIATE_TEST_SUITE_P(Data, Bodies,
                         testing::Values("rail_60E1_gauge_corner", "wheel_S1002_flange_root", "small_rail",
                                         "small_wheel", "flat_block", "disc", "bore", "convex_corner",
                                         "concave_groove", "roller", "ring", "rail_60E2_gauge_corner",
                                         "rail_54E1_gauge_corner", "rail_46E3_gauge_corner",
                                         "rail_60E1_running_surface", "wheel_S1002_running_surface",
                                         "rail_worn", "wheel_worn"),
                         [](const auto& test) { return std::string(test.param); });

TEST(Held, IsWhatTheBodyFileSays) {
  const auto held_places = [](BodyKind kind, const char* profile, const char* held, BodyFile::Strip strip) {
    BodyFile body;
    body.body.kind = kind;
    body.body.profile = profile;
    body.body.held = held;
    body.strip = strip;
    const QuadMesh mesh = mesh_section(body);
    std::vector<Point2> places;
    for (const auto& edge : edges_of(mesh, Group::held))
      places.push_back(0.5 * (point(mesh, edge.vertices[0]) + point(mesh, edge.vertices[1])));
    EXPECT_GE(places.size(), 4u);
    return places;
  };
  for (const char* rail : {"60E1", "54E1", "46E3"}) {
    double left = 0, right = 0;
    for (const Point2 p : held_places(BodyKind::rail, rail, "web", {-40, -20, 0.5})) {
      EXPECT_LT(std::abs(p.y), 12.3) << rail;
      EXPECT_GT(std::abs(p.y), 6.9) << rail;
      left = std::min(left, p.y);
      right = std::max(right, p.y);
    }
    EXPECT_NEAR(left, -right, 0.05) << rail;
  }
  for (const Point2 p : held_places(BodyKind::wheel, "S1002", "rim", {30, 40, 0.5}))
    EXPECT_NEAR(p.z, 390 - 460, 1e-9);
  for (const Point2 p : held_places(BodyKind::block, "", "sides", {-10, 10, 0.5}))
    EXPECT_NEAR(std::abs(p.y), 100, 1e-9);
}

TEST(Section, AreasAreExact) {
  BodyFile body;
  body.strip = {.from = -5, .to = 5, .station_width = 0.5};
  const auto area_of = [&](BodyKind kind) {
    body.body.kind = kind;
    return area(make_section(body));
  };
  EXPECT_NEAR(area_of(BodyKind::block), 2e4, 1e-6);
  EXPECT_NEAR(area_of(BodyKind::disc), pi * 100 * (1 - 0.0025), 1e-4);
  EXPECT_NEAR(area_of(BodyKind::bore), 4e4 - pi * 100, 1e-4);
}

TEST(Section, CurvedEdgesAreSaidInTheFile) {
  BodyFile body;
  body.body.kind = BodyKind::disc;
  body.strip = {.from = -5, .to = 5, .station_width = 0.5};
  const QuadMesh mesh = mesh_section(body);
  std::size_t curved = 0;
  for (const auto& edge : mesh.boundary) {
    const double radius = norm(mesh.points[static_cast<std::size_t>(edge.vertices[0])]);
    EXPECT_NEAR(norm(edge.halfway), radius, 1e-5 * radius); // the profile is a spline
    curved += edge.group != Group::contact;
  }
  const TemporaryFolder folder;
  const auto file = folder / "curved_edges.msh";
  write_msh(mesh, file);
  std::ifstream in(file);
  std::string line;
  while (std::getline(in, line) && !line.starts_with("curved edges,"))
    ;
  std::size_t said = 0;
  while (std::getline(in, line) && !line.starts_with("$"))
    ++said;
  EXPECT_EQ(said, curved);
}

/// Area, height of the centroid above the base and second moments about it, mm.
struct Moments {
  double area = 0, centroid = 0, Ix = 0, Iy = 0;
};

Moments moments(const QuadMesh& mesh) {
  double first = 0, second_z = 0, second_y = 0;
  Moments m;
  const auto add = [&](Point2 a, Point2 b, Point2 c) { // exact for a triangle
    const double part = ((b - a).y * (c - a).z - (b - a).z * (c - a).y) / 2;
    m.area += part;
    first += part * (a.z + b.z + c.z) / 3;
    second_z += part * (a.z * a.z + b.z * b.z + c.z * c.z + a.z * b.z + b.z * c.z + c.z * a.z) / 6;
    second_y += part * (a.y * a.y + b.y * b.y + c.y * c.y + a.y * b.y + b.y * c.y + c.y * a.y) / 6;
  };
  for (const auto& q : mesh.quads) {
    add(point(mesh, q[0]), point(mesh, q[1]), point(mesh, q[2]));
    add(point(mesh, q[0]), point(mesh, q[2]), point(mesh, q[3]));
  }
  const double z = first / m.area;
  m.centroid = 172 - z;
  m.Ix = second_z - m.area * z * z;
  m.Iy = second_y;
  return m;
}

BodyFile rail(const char* profile, BodyFile::Strip strip) {
  BodyFile body;
  body.body.profile = profile;
  body.strip = strip;
  return body;
}

TEST(RailMesh, HasTheSectionPropertiesOfTheStandard60E1) {
  const Moments m = moments(mesh_section(rail("60E1", {-45, -17, 0.25})));
  EXPECT_NEAR(m.area, 7670, 1e-3 * 7670);
  EXPECT_NEAR(m.centroid, 80.92, 0.05);
  EXPECT_NEAR(m.Ix, 30383100, 1e-3 * 30383100);
  EXPECT_NEAR(m.Iy, 5123000, 1e-3 * 5123000);
}

TEST(RailMesh, HasTheSectionPropertiesOfTheStandard60E2) {
  const Moments m = moments(mesh_section(rail("60E2", {-45, -17, 0.25})));
  EXPECT_NEAR(m.area, 7647.6, 1e-3 * 7647.6);
  EXPECT_NEAR(m.Ix, 30215000, 1e-3 * 30215000);
  EXPECT_NEAR(m.Iy, 5105000, 1e-3 * 5105000);
}

TEST(RailMesh, MirroredStripGivesTheMirroredStrip) {
  const auto left = strip_vertices(mesh_section(rail("60E1", {-45, -17, 0.5})));
  const auto right = strip_vertices(mesh_section(rail("60E1", {17, 45, 0.5})));
  ASSERT_EQ(left.size(), right.size());
  for (std::size_t i = 0; i < left.size(); ++i) {
    const Point2 mirror = right[right.size() - 1 - i];
    EXPECT_LT(norm(left[i] - Point2{-mirror.y, mirror.z}), 1e-9);
  }
}

TEST(RailMesh, FourHundredStations) {
  const BodyFile body = rail("60E1", {-60, 20, 0.2});
  const QuadMesh mesh = mesh_section(body);
  expect_strip_on_profile(body, mesh);
  EXPECT_EQ(edges_of(mesh, Group::contact).size(), 400u);
  EXPECT_GE(quality(mesh).smallest, poor_quality);
}

class StripDivision : public testing::TestWithParam<int> {};

TEST_P(StripDivision, OddAndEvenNumbersOfEdgesComeOutExactly) {
  for (const double to : {-17.0, -17.5}) { // 56 and 55 stations
    BodyFile body = rail("60E1", {-45, to, 0.5});
    body.mesh.elements_per_station = GetParam();
    const QuadMesh mesh = mesh_section(body);
    expect_strip_on_profile(body, mesh);
    EXPECT_GE(quality(mesh).smallest, poor_quality);
  }
}

INSTANTIATE_TEST_SUITE_P(PerStation, StripDivision, testing::Values(1, 2, 3, 5));

TEST(StripCorners, AreReachedByAnEvenNumberOfEdges) {
  BodyFile body;
  body.body = {.kind = BodyKind::block, .size = 5};
  body.strip = {.from = -5, .to = 5, .station_width = 1};
  body.mesh.elements_per_station = 1;
  const QuadMesh mesh = mesh_section(body);
  expect_strip_on_profile(body, mesh);
  EXPECT_GE(quality(mesh).smallest, poor_quality);
  EXPECT_NEAR(quality(mesh).area, 50, 1e-9);
}

TEST(Grading, ASmallerOneGivesMoreElements) {
  BodyFile body = rail("60E1", {-45, -17, 0.5});
  const auto count = [&](double grading) {
    body.mesh.grading = grading;
    return mesh_section(body).quads.size();
  };
  const auto coarse = count(0.6), middle = count(0.3), fine = count(0.15);
  EXPECT_LT(coarse, middle);
  EXPECT_LT(middle, fine);
}

} // namespace
} // namespace bem_contact::meshes
