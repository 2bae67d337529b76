#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/bodies/body_file.hpp"
#include "meshes/solid_mesh.hpp"
#include "meshes/write_msh.hpp"
#include "tests/base/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <numbers>
#include <set>

namespace bem_contact::meshes {
namespace {

using testing::HasSubstr;

BodyFile small_block() {
  BodyFile body;
  body.body.kind = BodyKind::block;
  body.body.size = 40;
  body.strip = {.from = -5, .to = 5, .station_width = 0.5};
  body.harmonic.half_period = 120;
  return body;
}

Point3 minus(const Point3& a, const Point3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

double triple(const Point3& a, const Point3& b, const Point3& c) {
  return a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
}

/// Of a hexahedron with plane sides and a convex shape, by its six tetrahedra about one diagonal.
double volume(const SolidMesh& mesh, const std::array<int, 8>& h) {
  const auto p = [&](int c) { return mesh.points[static_cast<std::size_t>(h[static_cast<std::size_t>(c)])]; };
  constexpr int around[6][2] = {{1, 2}, {2, 3}, {3, 7}, {7, 4}, {4, 5}, {5, 1}};
  double six = 0;
  for (const auto& [a, b] : around)
    six += triple(minus(p(a), p(0)), minus(p(b), p(0)), minus(p(6), p(0)));
  return six / 6;
}

double volume(const SolidMesh& mesh) {
  double sum = 0;
  for (const auto& h : mesh.hexahedra)
    sum += volume(mesh, h);
  return sum;
}

TEST(SolidMesh, FillsThePrismWithPositiveHexahedra) {
  const SolidMesh mesh = mesh_solid(small_block());
  for (const auto& h : mesh.hexahedra)
    EXPECT_GT(volume(mesh, h), 0);
  EXPECT_NEAR(volume(mesh), 80.0 * 40 * 120, 1e-6 * 80 * 40 * 120);
}

TEST(SolidMesh, FillsHalfOfTheWheel) {
  BodyFile body;
  body.body.kind = BodyKind::wheel;
  body.body.profile = "S1002";
  body.strip = {.from = 24, .to = 44, .station_width = 0.5};
  const SolidMesh mesh = mesh_solid(body);
  // Pappus: 2 pi times the section's first moment about the axle, halved; straight sides of layers of up to
  // 20 degrees lose up to 2 % of it.
  double moment = 0;
  for (const auto& q : mesh.section.quads) {
    const auto p = [&](int c) {
      return mesh.section.points[static_cast<std::size_t>(q[static_cast<std::size_t>(c)])];
    };
    for (const auto& [a, b, c] : {std::array{p(0), p(1), p(2)}, std::array{p(0), p(2), p(3)}}) {
      const Point2 u = b - a, v = c - a;
      moment += (u.y * v.z - u.z * v.y) / 2 * (460 + (a.z + b.z + c.z) / 3);
    }
  }
  const double exact = std::numbers::pi * moment;
  EXPECT_LT(volume(mesh), exact);
  EXPECT_GT(volume(mesh), 0.98 * exact);
  for (const auto& face : mesh.faces)
    if (face.group == symmetry_group) {
      for (const int v : face.vertices)
        EXPECT_NEAR(mesh.points[static_cast<std::size_t>(v)].x, 0, 1e-9);
    }
}

TEST(SolidMesh, ItsFacesAreTheWholeSurface) {
  const SolidMesh mesh = mesh_solid(small_block());
  constexpr int sides[6][4] = {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4},
                               {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  std::map<std::set<int>, int> count;
  for (const auto& h : mesh.hexahedra)
    for (const auto& side : sides) {
      std::set<int> vertices;
      for (const int c : side)
        vertices.insert(h[static_cast<std::size_t>(c)]);
      ++count[vertices];
    }
  std::set<std::set<int>> surface, faces;
  for (const auto& [vertices, times] : count) {
    EXPECT_LE(times, 2);
    if (times == 1)
      surface.insert(vertices);
  }
  for (const auto& face : mesh.faces) {
    faces.insert(std::set<int>(face.vertices.begin(), face.vertices.end()));
    for (const int v : face.vertices) {
      const Point3& p = mesh.points[static_cast<std::size_t>(v)];
      if (face.group == static_cast<int>(Group::contact)) {
        EXPECT_NEAR(p.z, 0, 1e-9);
      }
      if (face.group == static_cast<int>(Group::held)) {
        EXPECT_NEAR(p.z, 40, 1e-9);
      }
    }
  }
  EXPECT_EQ(faces.size(), mesh.faces.size());
  EXPECT_EQ(faces, surface);
}

/// Halving an edge again and again must end at the borders of the stations and of the loaded element.
TEST(SolidMesh, EdgesAreStationsTimesPowersOfTwo) {
  BodyFile body = small_block();
  for (const double from : {-5.0, -4.5, -7.5}) { // 20, 19 and 25 stations
    body.strip.from = from;
    const SolidMesh mesh = mesh_solid(body);
    EXPECT_DOUBLE_EQ(mesh.layers[1], 2); // 8 halves of dx = 0.5, at most size = 2.5
    for (const auto& edge : mesh.section.boundary) {
      if (edge.group != Group::contact)
        continue;
      const double a = mesh.section.points[static_cast<std::size_t>(edge.vertices[0])].y,
                   b = mesh.section.points[static_cast<std::size_t>(edge.vertices[1])].y;
      EXPECT_NEAR(b - a, 2, 1e-9);
      EXPECT_NEAR((a - from) / 0.5, std::round((a - from) / 0.5), 1e-9);
    }
  }
}

TEST(SolidMesh, TheFileNamesItsGroups) {
  const TemporaryFolder folder;
  const auto file = folder / "groups.msh";
  write_msh(mesh_solid(small_block()), file);
  std::ifstream in(file);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  EXPECT_THAT(text, HasSubstr("$PhysicalNames\n5\n2 1 \"contact\"\n2 2 \"held\"\n2 3 \"free\"\n2 4 "
                              "\"symmetry\"\n3 10 \"body\"\n"));
}

TEST(SolidMesh, RefusesAnElementLongerThanTheBody) {
  BodyFile body = small_block();
  body.solid.dx = 100;
  try {
    mesh_solid(body);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("An element of 100 mm is too long for a body of 240 mm"));
    EXPECT_THAT(error.what(), HasSubstr("Lower solid.dx or raise harmonic.half_period."));
  }
}

} // namespace
} // namespace bem_contact::meshes
