#pragma once

#include "bem_contact/contact/problem.hpp"
#include "bem_contact/scene/scene_file.hpp"

#include <vector>

namespace bem_contact {

/// One contact problem, all but its influence numbers, and where its rows lie on the two bodies.
struct PreparedContact {
  ContactProblem problem;
  std::vector<double> rail_s, wheel_s; ///< arc length of each row on the lower and the upper body, mm
  double contact_radius = 0;           ///< of a wheel, at the contact, mm; 0: none
  bool plane_strain = false;
};

/// A `patch` scene. Rows are centred about s = 0, columns about x = 0. Undeformed distance: gap.table, or
/// a x^2 + b s^2 + c x s plus, with strip.radius and strip.upper_radius, the exact distance from the circle
/// of the lower body to that of the upper along the lower normal (excluded where the normal misses it).
/// Throws InputError for tables that do not fit the grid.
PreparedContact prepare_patch(const SceneFile& scene);

/// The undeformed distance of a patch scene without gap.table whose contact lies at `x_of_contact`, mm.
void set_gap(ContactProblem& problem, const SceneFile& scene, double x_of_contact);

/// Distance along the normal from the circle of radius R (> 0 convex) at arc length s to a circle of radius
/// `upper` (> 0 convex) that touches it at s = 0, mm; excluded_gap where the normal misses it.
double circular_gap(double radius, double upper, double s);

} // namespace bem_contact
