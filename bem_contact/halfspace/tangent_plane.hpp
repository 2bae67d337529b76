#pragma once

#include "bem_contact/base/material.hpp"
#include "bem_contact/influence/influence_numbers.hpp"

#include <span>

namespace bem_contact::halfspace {

/// The middle of a row of elements on a curved strip, in the body's own frame (n into the body).
struct StripRow {
  Point2 position;
  double delta = 0; ///< inclination, rad
};

/// Grid of a curved strip; dx = 0: plane strain (offsets = 1).
struct StripGrid {
  double dx = 0, ds = 0; ///< mm
  int offsets = 1;
  double reference_distance = 100; ///< plane strain, mm: averaged_plane_strain()
};

/// Numbers of one body on a curved strip without finite elements: the surface field of a half-space, as far
/// away as the rows are (chord |P_I - P_J|, not arc), turned into the frames at both ends. With H the
/// half-space's number and Q the turn from the frame of J to that of I, Q H is the field of the loaded
/// element in its own tangent plane, H Q that in the plane of the displaced one. The mean of both keeps
/// Maxwell-Betti, which neither does alone (in plane strain they are the same).
///
/// In plane strain on a circle the half-space's field leaves tractions on the true surface: a uniform tension
/// P/(2 pi R) beside rigid parts (Flamant's stress on a circle; Michell 1899). Taking it off is
/// u_n = -(1 - 2 nu)/(4 pi G) P on a convex, -1/(4 pi G) P on a concave body, for a load P per length,
/// whatever R: with this term a pair of equal bodies is exact (Michell's pair, Persson's contact), without it
/// pmax is 1.6 % high at a half angle of 30 and 5 % at 60 degrees. In three dimensions it is left out. Rows
/// that turn equally from each to the next give a table translational in s.
InfluenceNumbers tangent_plane_numbers(const Material& material, const StripGrid& grid,
                                       std::span<const StripRow> rows);

} // namespace bem_contact::halfspace
