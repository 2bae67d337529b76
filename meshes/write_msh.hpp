#pragma once

#include "meshes/quad_mesh.hpp"
#include "meshes/solid_mesh.hpp"

#include <filesystem>

namespace bem_contact::meshes {

/// Writes the mesh as MSH 4.1 (ASCII), first order, x and y of the file being (y, z) of the section, with
/// the physical curves contact 1, held 2, free 3, the physical surface body 10 and, in $Comments at the end,
/// the body file's digest and the SHA-256 of all before it. Written under a temporary name and renamed.
/// Throws InputError when the file cannot be written.
void write_msh(const QuadMesh& mesh, const std::filesystem::path& file);

/// Writes the mesh as MSH 4.1 (ASCII), first order, with the physical surfaces contact 1, held 2, free 3,
/// symmetry 4 and the physical volume body 10; in its comments the section's curved edges. Written under a
/// temporary name and renamed. Throws what write_text() does (base/output_file.hpp).
void write_msh(const SolidMesh& mesh, const std::filesystem::path& file);

/// Throws InputError for an output that is there and no mesh of mesh_body: somebody else's. An empty file may
/// be replaced.
void require_replaceable_mesh(const std::filesystem::path& file);

} // namespace bem_contact::meshes
