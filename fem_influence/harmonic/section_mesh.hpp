#pragma once

#include "bem_contact/profile/bodies/body_file.hpp"
#include "bem_contact/profile/profile_curve.hpp"

#include <filesystem>

namespace dealii {
template <int dim, int spacedim> class Triangulation;
}

namespace bem_contact::fem {

/// How often cells of the mesh that was read are halved: those that touch the surface at the border of two
/// stations. There a station's load jumps and the stress has a logarithm, which leaves an
/// error of (h / p^2)^2 in averaged displacements whatever the degree p: each level at the borders takes it
/// down to a quarter (THEORY.md, 3).
struct Refinement {
  int borders = 0;
};

/// Reads a gmsh mesh of quadrilaterals into an empty triangulation and refines it. A point of deal.II is (y,
/// z). Edges of the group `contact` and others along the profile follow the curve, edges on arcs that
/// mesh_body names follow these. Throws InputError as read_msh() does, for a mesh without the groups
/// `contact` and `held`, and for one whose contact edges do not lie on the curve.
void make_section_mesh(dealii::Triangulation<2, 2>& mesh, const std::filesystem::path& path,
                       const ProfileCurve& curve, const BodyFile::Strip& strip, Refinement refinement);

} // namespace bem_contact::fem
