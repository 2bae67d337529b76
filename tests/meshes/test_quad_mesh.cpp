#include "meshes/quad_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bem_contact::meshes {
namespace {

TEST(ScaledJacobian, IsTheSineOfTheWorstCorner) {
  EXPECT_NEAR(scaled_jacobian({Point2{0, 0}, {3, 0}, {3, 1}, {0, 1}}), 1, 1e-15);
  const double c = 0.5, s = std::numbers::sqrt3 / 2; // a rhombus of 60 degrees
  EXPECT_NEAR(scaled_jacobian({Point2{0, 0}, {1, 0}, {1 + c, s}, {c, s}}), s, 1e-15);
}

TEST(ScaledJacobian, IsNotPositiveWhereTheQuadIsFoldedOrDegenerate) {
  EXPECT_LT(scaled_jacobian({Point2{0, 0}, {1, 0}, {0.1, 0.1}, {0, 1}}), 0); // a corner turned inside
  EXPECT_LT(scaled_jacobian({Point2{0, 0}, {0, 1}, {1, 1}, {1, 0}}), 0);     // walked the wrong way
  EXPECT_EQ(scaled_jacobian({Point2{0, 0}, {1, 0}, {1, 0}, {0, 1}}), 0);     // two vertices in one place
}

/// 2 x 2 unit squares; the vertex in the middle, the only one that may move, is the last.
QuadMesh four_squares(Point2 middle) {
  QuadMesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}, middle};
  for (int i = 0; i < 8; ++i)
    mesh.boundary.push_back({{i, (i + 1) % 8}, Group::free});
  mesh.quads = {{0, 1, 8, 7}, {1, 2, 3, 8}, {8, 3, 4, 5}, {7, 8, 5, 6}};
  return mesh;
}

TEST(Smooth, BringsADisplacedVertexBackAndLeavesTheBoundary) {
  const QuadMesh before = four_squares({1.7, 0.4});
  QuadMesh after = before;
  smooth(after, 20);
  EXPECT_LT(quality(before).smallest, 0.6);
  EXPECT_GT(quality(after).smallest, 0.99);
  for (std::size_t v = 0; v < 8; ++v) {
    EXPECT_EQ(after.points[v].y, before.points[v].y);
    EXPECT_EQ(after.points[v].z, before.points[v].z);
  }
}

TEST(Smooth, LeavesAPerfectMeshAlone) {
  QuadMesh mesh = four_squares({1, 1});
  smooth(mesh, 3);
  EXPECT_EQ(mesh.points[8].y, 1);
  EXPECT_EQ(mesh.points[8].z, 1);
}

TEST(Quality, CountsAndMeasures) {
  const Quality q = quality(four_squares({1.5, 1}));
  EXPECT_EQ(q.quads, 4u);
  EXPECT_NEAR(q.area, 4, 1e-14);
  EXPECT_NEAR(q.longest_edge, 1.5, 1e-14);
  EXPECT_NEAR(q.shortest_edge, 0.5, 1e-14);
  EXPECT_NEAR(q.smallest, 1 / std::sqrt(1.25), 1e-14);
}

TEST(Split, MakesFourOfAQuadAndThreeOfATriangle) {
  // A house of one quad and one triangle: the outline has ten vertices, every second one coarse.
  Outline outline{{}, SizeField(1, 1)};
  const std::vector<Point2> corners{{0, 0}, {2, 0}, {2, 2}, {1, 3}, {0, 2}};
  VertexLoop loop;
  for (std::size_t i = 0; i < 5; ++i) {
    loop.push_back({corners[i], Group::free});
    loop.push_back({0.5 * (corners[i] + corners[(i + 1) % 5]), Group::free});
  }
  loop[1].position = {1, -0.1}; // on a curve
  outline.loops.push_back(loop);
  const CoarseMesh coarse{corners, {{0, 1, 2, 4}, {4, 3, 2, -1}}}; // the triangle is walked the wrong way
  const QuadMesh mesh = split(coarse, outline);
  EXPECT_EQ(mesh.quads.size(), 7u);
  EXPECT_EQ(mesh.points.size(), 10u + 1u + 2u); // outline, one inner edge, two middles
  const Quality q = quality(mesh);
  EXPECT_GT(q.smallest, 0);
  EXPECT_NEAR(q.area, 5 + 0.1, 1e-14);
}

} // namespace
} // namespace bem_contact::meshes
