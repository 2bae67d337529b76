#pragma once

#include "bem_contact/base/material.hpp"
#include "bem_contact/influence/influence_numbers.hpp"

#include <array>
#include <span>

namespace bem_contact::halfspace {

/// 3 x 3, row i = displacement, column j = traction, mm/MPa.
using Matrix3 = std::array<std::array<double, 3>, 3>;

/// Displacement at the surface point (x, s) under unit uniform traction on the rectangle 2a x 2b about the
/// origin, of the half-space n > 0 (n into the body). Boussinesq-Cerruti: Love 1929; Kalker 1990, app. E.
Matrix3 at_point(const Material& material, double x, double s, double a, double b);

/// The same averaged over a rectangle of the same size 2a x 2b whose centre is (x, s): the influence number
/// the whole project uses, symmetric by Maxwell-Betti to the last digits.
Matrix3 averaged(const Material& material, double x, double s, double a, double b);

/// `averaged` at x = 0, dx, 2 dx, ... for elements dx by ds: element m of `line` is the number at x = m dx.
/// Equal to it to 1e-13 and about thirty times as fast, since neighbours share corners and quadrature points.
void averaged_line(const Material& material, double s, double dx, double ds, std::span<Matrix3> line);

/// Numbers of one body on a flat strip (translational in s): mx + 2 offsets for steady rolling.
InfluenceNumbers numbers(const Material& material, double dx, double ds, int offsets, int rows);

/// Plane strain: strip `ds` wide, infinitely long, averaged over an equal strip whose centre is s away.
/// u = 0 at `reference_distance` (Johnson 1985, section 2.3; u_x: a line load along x, antiplane).
Matrix3 averaged_plane_strain(const Material& material, double s, double ds, double reference_distance);

/// The table of averaged_plane_strain for a flat strip of equal rows.
InfluenceNumbers plane_strain_numbers(const Material& material, double ds, int rows,
                                      double reference_distance);

} // namespace bem_contact::halfspace
