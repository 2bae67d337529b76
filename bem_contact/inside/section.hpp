#pragma once

#include "bem_contact/halfspace/stress.hpp"
#include "bem_contact/inside/surface_tractions.hpp"

#include <span>
#include <vector>

namespace bem_contact::inside {

/// A point below the surface: of the nearest point of the surface the arc length, and the depth along n; mm.
struct BelowSurface {
  double s = 0, depth = 0;
};

/// A block of the section (s, n) below a patch, and the passage of the patch over it.
struct Section {
  std::vector<double> s;      ///< points, mm, rising: in the middle of rows, some beside the patch
  std::vector<double> depths; ///< points, mm, rising; the first is the surface, 0
  /// Points of the passage, in columns of the grid from its first one, rising; some lie before the first
  /// column and behind the last.
  std::vector<int> columns;
  std::vector<double> s_knots, depth_knots; ///< of residual stresses (uses/shakedown), mm
  double size = 0;                          ///< smaller half width of the patch, mm

  std::size_t count() const { return s.size() * depths.size(); }
  /// Number of a point: depth fastest.
  std::size_t point(std::size_t is, std::size_t id) const { return is * depths.size() + id; }
  std::vector<BelowSurface> points() const; ///< in this order
};

/// The block below these elements.
Section section_below(const SurfaceTractions& tractions, std::span<const int> elements);

/// Columns of a passage of all loaded elements, as section_below() takes them of one patch.
std::vector<int> passage_of(const SurfaceTractions& tractions);

/// Stresses of the half-space under all tractions at each point and column of the passage, [point][column],
/// in the frame (x, s, n), MPa, tension positive. Distances are taken along the arc, as if the surface were
/// unrolled into a plane. On the surface they are those in the middle of the elements.
std::vector<std::vector<halfspace::Stress>> halfspace_stresses(const SurfaceTractions& tractions,
                                                               std::span<const BelowSurface> points,
                                                               std::span<const int> columns);

/// The same at one point below any place x, by a sum over the loaded elements.
halfspace::Stress halfspace_stress(const SurfaceTractions& tractions, const BelowSurface& point, double x);

} // namespace bem_contact::inside
