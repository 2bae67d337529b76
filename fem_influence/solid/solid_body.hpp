#pragma once

#include "fem_influence/solid/solid_mesh.hpp"

#include <filesystem>
#include <functional>
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
  std::span<const Vector3> point;   ///< [point]: where it is, mm
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
/// that degree of freedom 3 node + component. No header includes deal.II.
class SolidBody {
public:
  SolidBody(const SolidMesh& mesh, int degree, const SolidRefinement& refinement);
  ~SolidBody();
  SolidBody(const SolidBody&) = delete;
  SolidBody& operator=(const SolidBody&) = delete;

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
