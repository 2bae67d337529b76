#pragma once

#include "bem_contact/geometry/rigid_slip.hpp"
#include "bem_contact/scene/grid_plan.hpp"
#include "bem_contact/scene/scene_file.hpp"

#include <optional>
#include <vector>

namespace bem_contact {

/// The geometry of a `patch` scene, all tables read. It has its own grid, rows centred about s = 0 and
/// columns about x = 0.
struct PatchGeometry {
  ContactGrid grid;          ///< plane strain: one element of dx = 1, forces are per mm
  bool plane_strain = false; ///< infinitely long along x
  std::vector<ContactRow> rows;
  std::vector<double> gap; ///< undeformed distance along n where the contact lies at x = 0, mm; field
  std::vector<double> rail_s, wheel_s; ///< arc length of each row on the lower and the upper body, mm
  SceneFile::Gap quadratic;            ///< of which `gap` is made, unless it comes from a table
  double radius = 0, upper_radius = 0; ///< of a curved strip and of the upper body, mm; 0: flat
  std::optional<RigidSlip> slip;       ///< instead of creepages
  std::vector<Tractions> start;        ///< from which a history starts; empty: from rest

  GridPlan plan() const;
  /// The undeformed distance where the contact lies at `x_of_contact` (mm): a x^2 + b s^2 + c x s, x from
  /// there, plus the exact distance from the circle of the lower body to that of the upper along the lower
  /// normal, where both radii are given; field.
  std::vector<double> gap_at(double x_of_contact) const;
};

/// Throws InputError for a grid that is none and for tables that do not fit it.
PatchGeometry read_patch(const SceneFile& scene);

/// Distance along the normal from the circle of radius R (> 0 convex) at arc length s to a circle of radius
/// `upper` (> 0 convex) that touches it at s = 0, mm; excluded_gap where the normal misses it.
double circular_gap(double radius, double upper, double s);

} // namespace bem_contact
