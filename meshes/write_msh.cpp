#include "meshes/write_msh.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/sha256.hpp"
#include "meshes/gmsh_session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <string_view>

namespace bem_contact::meshes {
namespace {

/// 1 (share of the chord's square). An edge of the outline that bulges by less is straight.
constexpr double straight_edge = 1e-7;

constexpr int line_type = 1, quad_type = 3, hexahedron_type = 5;

std::size_t tag(int vertex) {
  return static_cast<std::size_t>(vertex) + 1;
}

/// A vertex belongs to the curve of the edge that begins there, else to the surface.
void add_nodes(const QuadMesh& mesh) {
  struct Nodes {
    std::vector<std::size_t> tags;
    std::vector<double> coordinates;
    void add(const QuadMesh& of, std::size_t vertex) {
      tags.push_back(vertex + 1);
      coordinates.insert(coordinates.end(), {of.points[vertex].y, of.points[vertex].z, 0});
    }
  };
  Nodes curves[3], surface;
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    (v < mesh.boundary.size() ? curves[static_cast<int>(mesh.boundary[v].group) - 1] : surface).add(mesh, v);
  for (int group = 1; group <= 3; ++group)
    gmsh::model::mesh::addNodes(1, group, curves[group - 1].tags, curves[group - 1].coordinates);
  gmsh::model::mesh::addNodes(2, body_group, surface.tags, surface.coordinates);
}

/// Nodes of the volume, all of them.
void add_nodes(const SolidMesh& mesh) {
  std::vector<std::size_t> tags;
  std::vector<double> coordinates;
  for (const Point3& p : mesh.points) {
    tags.push_back(tags.size() + 1);
    coordinates.insert(coordinates.end(), {p.x, p.y, p.z});
  }
  gmsh::model::mesh::addNodes(3, body_group, tags, coordinates);
}

/// Of the boundary, by their groups, and of the body.
template <class Boundary, class Cells>
void add_elements(const Boundary& boundary, int boundary_type, const Cells& cells, int cell_type) {
  std::map<int, std::vector<std::size_t>> groups;
  for (const auto& element : boundary)
    for (const int vertex : element.vertices)
      groups[static_cast<int>(element.group)].push_back(tag(vertex));
  for (const auto& [group, vertices] : groups)
    gmsh::model::mesh::addElementsByType(group, boundary_type, {}, vertices);
  std::vector<std::size_t> of_body;
  for (const auto& cell : cells)
    for (const int vertex : cell)
      of_body.push_back(tag(vertex));
  gmsh::model::mesh::addElementsByType(body_group, cell_type, {}, of_body);
}

/// An entity of its own for each physical group: those of the boundary have the numbers 1, 2, ...
void add_groups(int dimension, std::initializer_list<const char*> boundary) {
  const auto add = [](int of_dimension, int group, const char* name, const std::vector<int>& around) {
    gmsh::model::addDiscreteEntity(of_dimension, group, around);
    gmsh::model::addPhysicalGroup(of_dimension, {group}, group);
    gmsh::model::setPhysicalName(of_dimension, group, name);
  };
  std::vector<int> groups;
  for (const char* name : boundary) {
    groups.push_back(static_cast<int>(groups.size()) + 1);
    add(dimension - 1, groups.back(), name, {});
  }
  add(dimension, body_group, "body", groups);
}

void add_all(const QuadMesh& mesh) {
  add_groups(2, {"contact", "held", "free"});
  add_nodes(mesh);
  add_elements(mesh.boundary, line_type, mesh.quads, quad_type);
}

void add_all(const SolidMesh& mesh) {
  add_groups(3, {"contact", "held", "free", "symmetry"});
  add_nodes(mesh);
  add_elements(mesh.faces, quad_type, mesh.hexahedra, hexahedron_type);
}

template <class Mesh> void write_with_gmsh(const Mesh& mesh, const std::string& file) {
  const GmshSession session(mesh.name);
  gmsh_call([&] {
    add_all(mesh);
    gmsh::option::setNumber("Mesh.MshFileVersion", 4.1);
    gmsh::option::setNumber("Mesh.Binary", 0);
    gmsh::write(file);
  });
}

/// Gmsh does not tell when the disk is full: a whole file ends with its elements.
bool is_whole(const std::filesystem::path& file) {
  constexpr std::string_view end = "$EndElements\n";
  std::ifstream in(file, std::ios::binary);
  std::string found(end.size(), '\0');
  return in.seekg(-static_cast<std::streamoff>(end.size()), std::ios::end) &&
         in.read(found.data(), static_cast<std::streamsize>(found.size())) && found == end;
}

/// The edges of the outline that are not straight, which first-order elements cannot say: their ends and a
/// point between them, for fem_influence. False when the disk is full.
bool add_curved_edges(const QuadMesh& mesh, const std::filesystem::path& file) {
  std::string lines;
  for (const auto& edge : mesh.boundary) {
    const Point2 a = mesh.points[static_cast<std::size_t>(edge.vertices[0])],
                 b = mesh.points[static_cast<std::size_t>(edge.vertices[1])], h = edge.halfway;
    const Point2 chord = b - a;
    if (std::abs(cross(chord, h - a)) > straight_edge * dot(chord, chord) && edge.group != Group::contact)
      lines += fmt::format("{:.16g} {:.16g} {:.16g} {:.16g} {:.16g} {:.16g}\n", a.y, a.z, h.y, h.z, b.y, b.z);
  }
  std::ofstream out(file, std::ios::app);
  out << "$Comments\ncurved edges, y z of an end, of a point between, of the other end\n"
      << lines << "$EndComments\n"
      << std::flush;
  return out.good();
}
bool add_curved_edges(const SolidMesh& mesh, const std::filesystem::path& file) {
  return add_curved_edges(mesh.section, file);
}

/// Says which body file the mesh belongs to, and the SHA-256 of all before it; false when the disk is full.
bool add_comment(const std::string& body_digest, const std::filesystem::path& file) {
  if (body_digest.empty())
    return true;
  const std::string digest = sha256_of_file(file.string());
  std::ofstream out(file, std::ios::app);
  out << "$Comments\nbody file " << body_digest << " sha256 " << digest << "\n$EndComments\n" << std::flush;
  return out.good();
}

std::filesystem::path temporary_mesh() {
  std::error_code none;
  const std::filesystem::path folder = std::filesystem::temp_directory_path(none);
  return (none ? std::filesystem::path(".") : folder) / "mesh_body";
}

/// Gmsh makes a file of its own, which is renamed when complete, or copied into a device or a pipe.
template <class Mesh> void write_checked(const Mesh& mesh, const std::filesystem::path& output) {
  const OutputTarget target = output_target(output, OutputForm::text);
  // Gmsh tells the format by the name's end.
  const WholeFile whole(target.stream ? temporary_mesh() : target.file, ".msh");
  const std::filesystem::path& file = whole.temporary();
  write_with_gmsh(mesh, file.string());
  if (!is_whole(file) || !add_curved_edges(mesh, file) || !add_comment(mesh.body_digest, file))
    throw Error(fmt::format("The mesh cannot be written to '{}'", output.string()),
                "writing stopped early, the disk may be full", "Make room, or give another file with -o.");
  if (!target.stream)
    return whole.commit();
  const std::ifstream in(file, std::ios::binary);
  write_text(target.file, [&](std::ostream& out) { out << in.rdbuf(); });
}

} // namespace

/// The last bytes of a mesh of mesh_body have its mark; a file without it is somebody else's.
void require_replaceable_mesh(const std::filesystem::path& file) {
  constexpr std::streamoff tail = 200;
  std::error_code unknown;
  if (!is_regular(file) || std::filesystem::file_size(file, unknown) == 0)
    return;
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  in.seekg(std::max<std::streamoff>(0, static_cast<std::streamoff>(in.tellg()) - tail));
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  if (text.find("$Comments\nbody file ") == std::string::npos)
    throw InputError(fmt::format("The file '{}' exists and would be replaced", file.string()),
                     "it is no mesh of mesh_body", "Give the mesh another name, or move this file.");
}

void write_msh(const QuadMesh& mesh, const std::filesystem::path& file) {
  write_checked(mesh, file);
}

void write_msh(const SolidMesh& mesh, const std::filesystem::path& file) {
  write_checked(mesh, file);
}

} // namespace bem_contact::meshes
