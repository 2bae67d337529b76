#pragma once

#include "meshes/quad_mesh.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace bem_contact::meshes {

inline std::filesystem::path body_folder() {
  return std::filesystem::path(CONFORMAL_SOURCE_DIR) / "data" / "bodies";
}

inline Point2 point(const QuadMesh& mesh, int vertex) {
  return mesh.points[static_cast<std::size_t>(vertex)];
}

inline std::vector<BoundaryEdge> edges_of(const QuadMesh& mesh, Group group) {
  std::vector<BoundaryEdge> edges;
  for (const auto& edge : mesh.boundary)
    if (edge.group == group)
      edges.push_back(edge);
  return edges;
}

/// The strip's vertices in walking order, both ends included.
inline std::vector<Point2> strip_vertices(const QuadMesh& mesh) {
  std::vector<Point2> vertices;
  const auto edges = edges_of(mesh, Group::contact);
  for (const auto& edge : edges)
    vertices.push_back(point(mesh, edge.vertices[0]));
  vertices.push_back(point(mesh, edges.back().vertices[1]));
  return vertices;
}

/// In how many quads each edge (from, to), walked as the quad is, occurs.
inline std::map<std::pair<int, int>, int> directed_edges(const QuadMesh& mesh) {
  std::map<std::pair<int, int>, int> count;
  for (const auto& quad : mesh.quads)
    for (std::size_t c = 0; c < 4; ++c)
      ++count[{quad[c], quad[(c + 1) % 4]}];
  return count;
}

} // namespace bem_contact::meshes
