#pragma once

#include "bem_contact/influence/influence_function.hpp"
#include "fem_influence/harmonic/section.hpp"
#include "fem_influence/shared/sparse_columns.hpp"

#include <span>

namespace bem_contact::fem {

/// Six functionals of a displacement v that say how the remote section moves as a whole (THEORY.md, 6): with
/// <.> the weighted mean over it and y, z from its centroid, columns 0 .. 5 are
///     <v_x>, <v_y>, <v_z>, <y v_z - z v_y>/<y^2 + z^2>, <z v_x>/<z^2>, -<y v_x>/<y^2>  [mm, mm, mm, rad,
///     rad, rad];
/// rows 3 node + component.
///
/// The remote section lies between one and two times `distance` D from the strip, weighted with
/// sin^2(pi (d / D - 1)) at the distance d from the nearest station's centre. D in mm; 0: 20 mm, or 0.8 of
/// the root of the section's mean square distance where that is less. The section is near enough to move with
/// the material under the strip when web, foot or disc bend, and far enough to be out of the contact's own
/// field. Throws InputError where no cell is that far.
SparseColumns remote_functionals(const Section& section, std::span<const Station> stations, double distance);

} // namespace bem_contact::fem
