#include "meshes/gmsh_mesh.hpp"

#include "bem_contact/base/error.hpp"
#include "meshes/gmsh_session.hpp"

#include <map>

namespace bem_contact::meshes {
namespace {

/// 1. Gmsh's element size over ours: two, because each cell is split in four, and 0.7, measured, because gmsh
/// makes triangles larger than it is asked to.
constexpr double coarse_factor = 2 * 0.7;

/// The outer boundary comes first, as gmsh wants it; points are numbered in the outline's order.
int surface_of(const Outline& outline) {
  std::vector<int> loops;
  int point = 0;
  for (const auto& loop : outline.loops) {
    const int first = point + 1, count = static_cast<int>(loop.size() / 2);
    for (int i = 0; i < count; ++i) {
      const Point2 p = loop[static_cast<std::size_t>(2 * i)].position;
      gmsh::model::geo::addPoint(p.y, p.z, 0, 0, ++point);
    }
    std::vector<int> lines;
    for (int i = 0; i < count; ++i)
      lines.push_back(gmsh::model::geo::addLine(first + i, first + (i + 1) % count));
    loops.insert(area(loop) > 0 ? loops.begin() : loops.end(), gmsh::model::geo::addCurveLoop(lines));
    for (const int line : lines)
      gmsh::model::geo::mesh::setTransfiniteCurve(line, 2);
  }
  const int surface = gmsh::model::geo::addPlaneSurface(loops);
  gmsh::model::geo::synchronize();
  return surface;
}

void set_options() {
  gmsh::option::setNumber("Mesh.Algorithm", 6);
  gmsh::option::setNumber("Mesh.RecombineAll", 1);
  gmsh::option::setNumber("Mesh.RecombinationAlgorithm", 1);
  gmsh::option::setNumber("Mesh.MeshSizeFromPoints", 0);
  gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", 0);
  gmsh::option::setNumber("Mesh.ElementOrder", 1);
}

CoarseMesh collect(int surface, int boundary_points) {
  std::map<std::size_t, int> index;
  CoarseMesh mesh;
  std::vector<std::size_t> tags;
  std::vector<double> x, parameters;
  for (int i = 1; i <= boundary_points; ++i) {
    gmsh::model::mesh::getNodes(tags, x, parameters, 0, i);
    if (tags.size() != 1)
      throw Error("The section could not be meshed", "gmsh lost a vertex of the outline",
                  "Report it with the body file.");
    index[tags[0]] = i - 1;
    mesh.points.push_back({x[0], x[1]});
  }
  gmsh::model::mesh::getNodes(tags, x, parameters, 2, surface);
  for (std::size_t i = 0; i < tags.size(); ++i) {
    index[tags[i]] = static_cast<int>(mesh.points.size());
    mesh.points.push_back({x[3 * i], x[3 * i + 1]});
  }
  for (const auto& [type, corners] : {std::pair{2, 3}, std::pair{3, 4}}) {
    std::vector<std::size_t> elements, nodes;
    gmsh::model::mesh::getElementsByType(type, elements, nodes, surface);
    for (std::size_t e = 0; e < elements.size(); ++e) {
      std::array<int, 4> cell{-1, -1, -1, -1};
      for (int c = 0; c < corners; ++c)
        cell[static_cast<std::size_t>(c)] = index.at(nodes[e * corners + c]);
      mesh.cells.push_back(cell);
    }
  }
  return mesh;
}

} // namespace

CoarseMesh coarse_mesh(const Outline& outline) {
  const GmshSession session("section");
  return gmsh_call([&] {
    set_options();
    const int surface = surface_of(outline);
    // gmsh 4.8 gives the callback five arguments, gmsh 4.13 the size so far as a sixth.
    gmsh::model::mesh::setSizeCallback([&](int, int, double x, double y, double, auto...) {
      return coarse_factor * outline.size({x, y});
    });
    gmsh::model::mesh::generate(2);
    gmsh::model::mesh::removeSizeCallback();
    std::size_t points = 0;
    for (const auto& loop : outline.loops)
      points += loop.size() / 2;
    return collect(surface, static_cast<int>(points));
  });
}

} // namespace bem_contact::meshes
