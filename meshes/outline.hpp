#pragma once

#include "meshes/section.hpp"
#include "meshes/settings.hpp"
#include "meshes/size_field.hpp"

#include <string>
#include <vector>

namespace bem_contact::meshes {

/// A vertex of the outline, the group of the edge that starts there, and a point halfway along it.
struct OutlineVertex {
  Point2 position;
  Group group = Group::free;
  Point2 halfway = {};
};

/// A closed loop of vertices, an even number of them; corners and changes of group are at even
/// positions, but the end of a strip of an odd number of edges.
using VertexLoop = std::vector<OutlineVertex>;

/// Area enclosed by straight edges, mm^2; below 0 for a hole.
double area(const VertexLoop& loop);

struct Outline {
  std::vector<VertexLoop> loops;
  SizeField size;
};

/// Divides a section's outline: the strip in `strip_edges` equal edges of arc length, the rest as the
/// strip's grading, its arcs (`edge_angle` an edge) and half the thickness of the body there ask for.
/// Throws InputError for an odd number of strip edges up to a corner.
Outline divide(const Section& section, int strip_edges, const BodyFile::Mesh& mesh,
               double edge_angle = fine_edge_angle);

/// Throws InputError when edges of the outline cross or touch each other, or a hole is not within the body.
void refuse_crossings(const Outline& outline, const std::string& name);

} // namespace bem_contact::meshes
