#pragma once

#include "bem_contact/base/conventions.hpp"
#include "bem_contact/profile/body_file.hpp"
#include "bem_contact/profile/profile_curve.hpp"
#include "fem_influence/shared/elements.hpp"

#include <cstddef>
#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace bem_contact::fem {

/// Physical ids of a section's mesh (written by mesh_body).
inline constexpr int contact_id = 1, held_id = 2;

/// deal.II's messages fill a page: what the part after "Additional information" says, on one line.
std::string short_reason(const std::exception& error);

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

/// One edge of the contact strip: ends a, b (on the profile curve), quadrature at the part t of the way from
/// a to b with weights that add up to 1. The edge is curved: t is the part of the arc length.
struct EdgeView {
  std::span<const int> nodes; ///< of the cell it belongs to
  Point2 a, b;
  std::span<const double> t, weight; ///< [point]
  std::span<const double> value;     ///< [point][local node]
};

/// How often cells of the mesh that was read are halved: all of them, then those that touch the surface at
/// the border of two stations. There a station's load jumps and the stress has a logarithm, which leaves an
/// error of (h / p^2)^2 in averaged displacements whatever the degree p: each level at the borders takes it
/// down to a quarter.
struct Refinement {
  int everywhere = 0;
  int borders = 0;
};

/// A section's mesh with scalar Lagrange elements; each node carries the three displacements (x, y, z),
/// so that degree of freedom 3 node + component. Only section.cpp sees deal.II.
class Section {
public:
  /// Reads a gmsh mesh of quadrilaterals. Edges of the group `contact` follow the curve. Throws InputError
  /// for a missing file, a file that is not a mesh of quadrilaterals in two dimensions, one without the
  /// groups `contact` and `held`, or one whose contact edges do not lie on the curve.
  Section(const std::filesystem::path& mesh, int degree, const ProfileCurve& curve,
          const BodyFile::Strip& strip, Refinement refinement = {});
  ~Section();
  Section(const Section&) = delete;
  Section& operator=(const Section&) = delete;

  int degree() const;
  std::size_t cell_count() const;
  std::size_t node_count() const;
  const std::vector<Point2>& node_positions() const;
  const std::vector<char>& held() const; ///< per node

  Elements cells() const; ///< nodes of each cell, as for_each_cell() has them
  void for_each_cell(const std::function<void(const CellView&)>& visit) const;
  void for_each_contact_edge(const std::function<void(const EdgeView&)>& visit) const;

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace bem_contact::fem
