#pragma once

#include "bem_contact/base/conventions.hpp"
#include "bem_contact/profile/bodies/body_file.hpp"
#include "bem_contact/profile/profile_curve.hpp"
#include "fem_influence/harmonic/section_mesh.hpp"
#include "fem_influence/shared/elements.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace bem_contact::fem {

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

/// The shapes of a cell at a point in it.
struct PointShapes {
  std::vector<int> nodes;
  std::vector<double> value, d_dy, d_dz; ///< [local node]
};

/// One edge of the contact strip: ends a, b (on the profile curve), quadrature at the part t of the way from
/// a to b with weights that add up to 1. The edge is curved: t is the part of the arc length.
struct EdgeView {
  std::span<const int> nodes; ///< of the cell it belongs to
  Point2 a, b;
  std::span<const double> t, weight; ///< [point]
  std::span<const double> value;     ///< [point][local node]
};

/// A section's mesh with scalar Lagrange elements; each node carries the three displacements (x, y, z),
/// so that degree of freedom 3 node + component. No header includes deal.II.
class Section {
public:
  /// Reads and refines the mesh as make_section_mesh() does, and throws what that throws.
  Section(const std::filesystem::path& mesh, int degree, const ProfileCurve& curve,
          const BodyFile::Strip& strip, Refinement refinement = {});
  ~Section();
  Section(const Section&) = delete;
  Section& operator=(const Section&) = delete;

  std::size_t cell_count() const;
  std::size_t node_count() const;
  const std::vector<Point2>& node_positions() const;
  const std::vector<char>& held() const; ///< per node

  Elements cells() const; ///< nodes of each cell, as for_each_cell() has them
  void for_each_cell(const std::function<void(const CellView&)>& visit) const;
  /// At each of these points; no nodes where the section is not there.
  std::vector<PointShapes> shapes_at(std::span<const Point2> points) const;
  void for_each_contact_edge(const std::function<void(const EdgeView&)>& visit) const;

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace bem_contact::fem
