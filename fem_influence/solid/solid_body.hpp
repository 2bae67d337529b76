#pragma once

#include "fem_influence/solid/solid_surface.hpp"

#include <filesystem>
#include <memory>
#include <span>
#include <vector>

namespace bem_contact::fem {

/// A node and what it counts for.
struct NodeWeight {
  int node = 0;
  double weight = 0;
};

/// One hexahedron as plain numbers.
struct SolidCellView {
  std::span<const int> nodes;
  std::span<const double> weight;   ///< [point], mm^3
  std::span<const double> gradient; ///< [point][local node][3], 1/mm
  Vector3 centre{};
};

/// One face of the group `contact`: the cell's nodes, the face's corners on the surface.
struct SolidFaceView {
  std::span<const int> nodes;
  std::array<SurfacePoint, 4> corner; ///< at (0, 0), (1, 0), (0, 1), (1, 1) of the face's own coordinates
  std::function<void(double xi, double eta, std::span<double> value)> shapes; ///< value: [local node]
};

/// A scalar per node that no equation determines, or one that is zero.
struct NodeFlags {
  std::vector<char> hanging, held, mirrored;
};

/// Half of a 3-D body in hexahedra with scalar Lagrange elements; each node carries three displacements, so
/// that degree of freedom 3 node + component. Its contact faces follow the profile, a wheel's cells the turn
/// about the axle. Only solid_body.cpp sees deal.II.
class SolidBody {
public:
  /// Reads a gmsh mesh of hexahedra with the physical surfaces contact = 1, held = 2, symmetry = 4 (planes
  /// across x, one of them x = 0). Throws InputError for anything else, and where `contact` lies off the
  /// profile.
  SolidBody(const std::filesystem::path& mesh, const ContactSurface& surface, int degree);
  ~SolidBody();
  SolidBody(const SolidBody&) = delete;
  SolidBody& operator=(const SolidBody&) = delete;

  /// Halves cells of the mesh as it was read until their longest edge is at most
  ///     smallest + grading d  (+ d - reach where d > reach),
  /// d the distance from the nearest load's centre, less `load_radius`.
  void refine(std::span<const SurfacePoint> loads, double load_radius, double smallest, double grading,
              double reach);

  std::size_t cell_count() const;
  std::size_t node_count() const;
  const NodeFlags& flags() const;
  /// A hanging node's value by others; of any other node itself.
  std::span<const NodeWeight> masters(int node) const;

  void for_each_cell(const std::function<void(const SolidCellView&)>& visit) const;
  void for_each_contact_face(const std::function<void(const SolidFaceView&)>& visit) const;

  /// Displacement [3 node + component] for ParaView. Throws InputError where it cannot be written.
  void write_vtu(const std::filesystem::path& file, std::span<const double> displacement) const;

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace bem_contact::fem
