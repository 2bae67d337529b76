#pragma once

#include "meshes/outline.hpp"

#include <array>
#include <vector>

namespace bem_contact::meshes {

/// Triangles (last index -1) and quadrilaterals on every second vertex of the outline.
struct CoarseMesh {
  std::vector<Point2> points; ///< first the outline's even vertices, loop by loop
  std::vector<std::array<int, 4>> cells;
};

/// Meshes the inside of the outline with gmsh; edges about twice as long as `outline.size`.
CoarseMesh coarse_mesh(const Outline& outline);

} // namespace bem_contact::meshes
