#pragma once

#include <exception>
#include <filesystem>
#include <string>

namespace dealii {
template <int dim, int spacedim> class Triangulation;
}

namespace bem_contact::fem {

/// Numbers of a mesh's physical groups, as mesh_body writes them: curves of a section, surfaces of a 3-D
/// body.
inline constexpr int contact_id = 1, held_id = 2, symmetry_id = 4;

/// deal.II's messages fill a page: what the part after "Additional information" says, on one line.
std::string short_reason(const std::exception& error);

/// Reads a gmsh mesh of quadrilaterals (dim 2, in the plane) or hexahedra (dim 3) into an empty
/// triangulation. Throws InputError for a missing file, a file that is not such a mesh, and one with other
/// cells.
template <int dim> void read_msh(dealii::Triangulation<dim, dim>& mesh, const std::filesystem::path& path);

extern template void read_msh<2>(dealii::Triangulation<2, 2>&, const std::filesystem::path&);
extern template void read_msh<3>(dealii::Triangulation<3, 3>&, const std::filesystem::path&);

} // namespace bem_contact::fem
