#pragma once

#include "fem_influence/solid/solid_surface.hpp"

#include <filesystem>
#include <memory>
#include <span>

namespace dealii {
template <int dim, int spacedim> class Triangulation;
}

namespace bem_contact::fem {

/// The mesh of half of a 3-D body as it was read: hexahedra whose contact faces follow the profile, other
/// faces the arcs that mesh_body names, and a wheel's cells the turn about its axle.
class SolidMesh {
public:
  /// Reads a gmsh mesh of hexahedra with the physical surfaces contact = 1, held = 2, symmetry = 4 (planes
  /// across x, one of them x = 0). Throws InputError for anything else, and where `contact` lies off the
  /// profile.
  SolidMesh(const std::filesystem::path& path, const ContactSurface& surface);
  ~SolidMesh();
  SolidMesh(const SolidMesh&) = delete;
  SolidMesh& operator=(const SolidMesh&) = delete;

  const ContactSurface& surface() const;
  const dealii::Triangulation<3, 3>& triangulation() const;

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// How large cells may be, lengths in mm: their longest edge is at most
///     smallest + grading d  (+ d - reach where d > reach),
/// d the distance from the nearest load's centre, less `load_radius`.
struct SolidRefinement {
  std::span<const SurfacePoint> loads; ///< centres
  double load_radius = 0;
  double smallest = 0;
  double grading = 0; ///< 1
  double reach = 0;
};

/// Makes `refined`, which is empty, a copy of the mesh and halves its cells until they are small enough.
void refine(dealii::Triangulation<3, 3>& refined, const SolidMesh& mesh, const SolidRefinement& refinement);

} // namespace bem_contact::fem
