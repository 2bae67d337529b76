#pragma once

#include "bem_contact/base/tuned.hpp"

/// The tuned numbers of this room (base/tuned.hpp).
namespace bem_contact::halfspace {

// How an element's influence number is computed, by the distance of the two elements. Quadrature with N Gauss
// points on each half of an element pair's density is exact to (2 distance)^(-2N), so each switch costs
// 1e-14.

/// 1 (half of the element's longer side). Nearer pairs have the closed form, whose terms cancel farther away.
BEM_CONTACT_TUNED(double, closed_form_radius, 12.0);
/// 1 (as above). Six Gauss points up to here, then four;
BEM_CONTACT_TUNED(double, six_point_radius, 36.0);
/// 1 (as above). and beyond this, three.
BEM_CONTACT_TUNED(double, four_point_radius, 120.0);

// Plane strain.

/// mm. Where the displacement of plane strain is 0 unless the caller says otherwise. A convention: it shifts
/// the approach and nothing else.
BEM_CONTACT_TUNED(double, plane_strain_reference, 100.0);

// Curved strips.

/// rad. Rows whose turns differ by less turn evenly: the rounding of an inclination.
BEM_CONTACT_TUNED(double, equal_turn, 1e-10);
/// 1 (share of a row's width). Rows whose steps differ by less are equally far apart: rounding, as above.
BEM_CONTACT_TUNED(double, equal_step, 1e-9);
/// rad. A strip that turns by less altogether is flat.
BEM_CONTACT_TUNED(double, flat_turn, 1e-9);

// Resampling.

/// 1 (share of a number). Error of the interpolated half-space numbers. They are added and taken away again,
/// so it is a thousandth of what a file's own estimate is at best.
BEM_CONTACT_TUNED(double, near_field_accuracy, 1e-6);
/// 1 (share of a row's width). Distances that differ by less share their numbers: rounding.
BEM_CONTACT_TUNED(double, same_distance, 1e-12);
/// 1. Numbers in the lines that are kept: 16 MB, or 5,000 lines of 40 offsets (a case by influence files has
/// about a hundred). When there are more, all go. Chosen.
BEM_CONTACT_TUNED(int, most_line_values, 2000000);
/// 1 (station widths). A row this near to a station is that station: the rounding of s.
BEM_CONTACT_TUNED(double, station_snap, 1e-9);
/// 1 (row widths). How much of the outermost half row must lie on the strip. Less than a half, because rows
/// that are equally wide on one body are up to 1 % narrower or wider on the other.
BEM_CONTACT_TUNED(double, required_half_row, 0.49);
/// 1. Two bodies whose element sizes differ by less, relatively, have the same grid: rounding.
BEM_CONTACT_TUNED(double, same_grid, 1e-9);

} // namespace bem_contact::halfspace
