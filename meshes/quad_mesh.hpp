#pragma once

#include "bem_contact/base/conventions.hpp"
#include "meshes/gmsh_mesh.hpp"

#include <array>
#include <string>
#include <vector>

namespace bem_contact::meshes {

/// An edge of the boundary, walked as its loop is.
struct BoundaryEdge {
  std::array<int, 2> vertices{};
  Group group = Group::free;
  Point2 halfway = {}; ///< on the outline, about halfway
};

/// First-order quadrilaterals of a section; vertices of a quad run from +y towards +z.
struct QuadMesh {
  std::string name;           ///< of the body
  std::string body_digest;    ///< mesh_digest() of the body file; "" for none
  std::string note;           ///< of the section
  double section_area = 0;    ///< of the true section, mm^2
  std::vector<Point2> points; ///< (y, z), mm
  std::vector<std::array<int, 4>> quads;
  std::vector<BoundaryEdge> boundary; ///< loop by loop; the strip first, with rising arc length
};

/// Splits every cell at its middle and its edges' middles; on the outline these are its odd vertices.
/// The first vertices of the result are the outline's, loop by loop.
QuadMesh split(const CoarseMesh& coarse, const Outline& outline);

/// Scaled Jacobian of a quadrilateral: the smallest, over its corners, of the sine of the angle between
/// the corner's edges; 1 for a rectangle, <= 0 where it is folded.
double scaled_jacobian(const std::array<Point2, 4>& quad);
double scaled_jacobian(const QuadMesh& mesh, std::size_t quad);

/// Moves vertices inside the mesh where that raises the smallest scaled Jacobian around them.
void smooth(QuadMesh& mesh, int sweeps);

struct Quality {
  std::size_t quads = 0;
  double smallest = 0, mean = 0;              ///< scaled Jacobian
  Point2 worst;                               ///< centre of the worst quad
  double area = 0;                            ///< of all quads, mm^2
  double shortest_edge = 0, longest_edge = 0; ///< mm
};
Quality quality(const QuadMesh& mesh);

} // namespace bem_contact::meshes
