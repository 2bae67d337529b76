#include "meshes/section_mesh.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "meshes/outline.hpp"

#include <fmt/format.h>

#include <cmath>

namespace bem_contact::meshes {
namespace {

/// 1 (smallest scaled Jacobian). A worse mesh is refused: its elements are nearly folded. Chosen.
constexpr double refused_quality = 0.05;
/// 1. Sweeps that move the vertices inside a mesh. Later ones no longer change the worst quad. Chosen.
constexpr int smoothing_sweeps = 10;
/// mm. How far a vertex of the strip may be off the profile: rounding of an arc length.
constexpr double strip_slack = 1e-9;
/// 1 (share of the area). How far the quads' area may be off that of the outline: rounding.
constexpr double area_slack = 1e-9;

/// The quads must fill the outline exactly: no hole, no overlap.
void check_area(const QuadMesh& mesh, double area, const std::string& name) {
  double twice = 0;
  for (const auto& edge : mesh.boundary) {
    const Point2 a = mesh.points[static_cast<std::size_t>(edge.vertices[0])];
    const Point2 b = mesh.points[static_cast<std::size_t>(edge.vertices[1])];
    twice += cross(a, b);
  }
  if (!(std::abs(area - twice / 2) < area_slack * area))
    throw Error(fmt::format("The mesh of {} does not fill its outline", name),
                fmt::format("the quadrilaterals have {:.6f} mm^2, the outline {:.6f} mm^2", area, twice / 2),
                "Report it with the body file.");
}

void check_strip(const QuadMesh& mesh, const Piece& strip, int edges, const std::string& name) {
  for (int i = 0; i <= edges; ++i) {
    const auto& edge = mesh.boundary[static_cast<std::size_t>(i == edges ? i - 1 : i)];
    const int vertex = edge.vertices[i == edges ? 1 : 0];
    const Point2 p = mesh.points[static_cast<std::size_t>(vertex)];
    const Point2 wanted = strip.at(strip.from + (strip.to - strip.from) * i / edges);
    if (edge.group != Group::contact || !(norm(p - wanted) < strip_slack))
      throw Error(fmt::format("Vertex {} of the strip of {} is not where it should be", i, name),
                  fmt::format("it is {:.3e} mm away", norm(p - wanted)), "Report it with the body file.");
  }
}

} // namespace

QuadMesh mesh_section(const BodyFile& body, double edge_angle) {
  const Section section = make_section(body);
  const int edges = body.strip.stations() * body.mesh.elements_per_station;
  const Outline outline = divide(section, edges, body.mesh, edge_angle);
  refuse_crossings(outline, section.name);

  QuadMesh mesh = split(coarse_mesh(outline), outline);
  smooth(mesh, smoothing_sweeps);
  mesh.name = section.name;
  mesh.note = section.note;
  mesh.body_digest = mesh_digest(body, body_profile(body).digest());
  mesh.section_area = area(section);

  const Quality report = quality(mesh);
  if (report.quads == 0 || !(report.smallest >= refused_quality))
    throw Error(fmt::format("The mesh of {} is too distorted", section.name),
                fmt::format("smallest scaled Jacobian {:.3f} < {} near y = {:.3f}, z = {:.3f} mm",
                            report.smallest, refused_quality, report.worst.y, report.worst.z),
                "Lower [mesh] grading or [strip] station_width, or move the strip's ends.");
  check_area(mesh, report.area, section.name);
  check_strip(mesh, section.loops.front().front(), edges, section.name);
  return mesh;
}

} // namespace bem_contact::meshes
