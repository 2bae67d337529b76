#pragma once

#include "meshes/section.hpp"

#include <numbers>
#include <vector>

namespace bem_contact::meshes {

/// How long an element edge may be, as a function of the place.
/// size(p) = min(largest, min over sources (size_i + grading * |p - source_i|)).
class SizeField {
public:
  SizeField(double largest, double grading) : largest_(largest), grading_(grading) {}
  void add(double size, std::vector<Point2> sources);
  double operator()(Point2 p) const;

private:
  struct Level {
    double size;
    std::vector<Point2> sources;
  };
  double largest_, grading_;
  std::vector<Level> levels_; ///< rising in size
};

/// A vertex of the outline, the group of the edge that starts there, and a point halfway along it.
struct OutlineVertex {
  Point2 position;
  Group group = Group::free;
  Point2 halfway = {};
};

/// A closed loop of vertices, an even number of them; corners and changes of group are at even
/// positions, but the end of a strip of an odd number of edges.
using VertexLoop = std::vector<OutlineVertex>;

struct Outline {
  std::vector<VertexLoop> loops;
  SizeField size;
};

inline constexpr double fine_edge_angle = 7.5 * std::numbers::pi / 180;

/// Divides a section's outline: the strip in `strip_edges` equal edges of arc length, the rest as the
/// strip's grading, its arcs (`edge_angle` an edge) and half the thickness of the body there ask for.
/// Throws InputError for an odd number of strip edges up to a corner.
Outline divide(const Section& section, int strip_edges, const BodyFile::Mesh& mesh,
               double edge_angle = fine_edge_angle);

/// Throws InputError when edges of the outline cross or touch each other, or a hole is not within the body.
void refuse_crossings(const Outline& outline, const std::string& name);

} // namespace bem_contact::meshes
