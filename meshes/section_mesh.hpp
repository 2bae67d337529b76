#pragma once

#include "meshes/outline.hpp"
#include "meshes/quad_mesh.hpp"

#include <filesystem>
#include <string>

namespace bem_contact::meshes {

inline constexpr double refused_quality = 0.05; ///< smallest scaled Jacobian below which a mesh is refused
inline constexpr double poor_quality = 0.2;     ///< below which the program warns

/// The mesh of a body's cross-section. On the strip its vertices lie on the profile at the arc lengths
/// from + i * station_width / elements_per_station. Elsewhere the size h of a quad, the square root of its
/// area, is at most h_strip + grading * distance from the strip, and `largest`; single quads by up to 10 %
/// more. An edge on an arc turns by at most `edge_angle`. Throws InputError for a body that cannot be meshed,
/// Error when the mesh fails its own checks: strip vertices on the curve to 1e-9 mm, quads filling the
/// outline, smallest scaled Jacobian.
QuadMesh mesh_section(const BodyFile& body, double edge_angle = fine_edge_angle);

/// Writes the mesh as MSH 4.1 (ASCII), first order, x and y of the file being (y, z) of the section, with
/// the physical curves contact 1, held 2, free 3, the physical surface body 10 and, in $Comments at the end,
/// the body file's digest. Written under a temporary name and renamed. Throws InputError when the file cannot
/// be written.
void write_msh(const QuadMesh& mesh, const std::filesystem::path& file);

} // namespace bem_contact::meshes
