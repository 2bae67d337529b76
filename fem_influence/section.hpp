#pragma once

#include "bem_contact/base/conventions.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace bem_contact::fem {

/// Physical ids of a section's mesh (written by mesh_body).
inline constexpr int contact_id = 1, held_id = 2;

/// A quadrature point of a cell: weight is the area it stands for, mm^2.
struct CellPoint {
  double weight = 0;
  Point2 position;
};

/// One cell as plain numbers. Shapes are [point][local node].
struct CellView {
  std::span<const int> nodes;
  std::span<const CellPoint> points;
  std::span<const double> value, d_dy, d_dz;
  Point2 centre;
};

/// One edge of the contact strip: ends a, b, quadrature at a + t (b - a) with weights that add up to 1.
struct EdgeView {
  std::span<const int> nodes; ///< of the cell it belongs to
  Point2 a, b;
  std::span<const double> t, weight; ///< [point]
  std::span<const double> value;     ///< [point][local node]
};

/// A section's mesh with scalar Lagrange elements; each node carries the three displacements (x, y, z),
/// so that degree of freedom 3 node + component. Only section.cpp sees deal.II.
class Section {
public:
  /// Reads a gmsh mesh of quadrilaterals. Throws InputError for a missing file, a file that is not a mesh
  /// of quadrilaterals in two dimensions, or one without the groups `contact` and `held`.
  Section(const std::filesystem::path& mesh, int degree);
  ~Section();
  Section(const Section&) = delete;
  Section& operator=(const Section&) = delete;

  int degree() const;
  std::size_t cell_count() const;
  std::size_t node_count() const;
  const std::vector<Point2>& node_positions() const;
  const std::vector<char>& held() const; ///< per node

  void for_each_cell(const std::function<void(const CellView&)>& visit) const;
  void for_each_contact_edge(const std::function<void(const EdgeView&)>& visit) const;

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace bem_contact::fem
