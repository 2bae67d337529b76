#pragma once

#include "bem_contact/profile/bodies/body_file.hpp"
#include "meshes/quad_mesh.hpp"
#include "meshes/settings.hpp"

namespace bem_contact::meshes {

/// The mesh of a body's cross-section. On the strip its vertices lie on the profile at the arc lengths
/// from + i * station_width / elements_per_station. Elsewhere the size h of a quad, the square root of its
/// area, is at most h_strip + grading * distance from the strip, and `largest`; single quads by up to 10 %
/// more. An edge on an arc turns by at most `edge_angle`. Throws InputError for a body that cannot be meshed,
/// Error when the mesh fails its own checks: strip vertices on the curve to 1e-9 mm, quads filling the
/// outline, smallest scaled Jacobian.
QuadMesh mesh_section(const BodyFile& body, double edge_angle = fine_edge_angle);

} // namespace bem_contact::meshes
