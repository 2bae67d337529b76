#pragma once

#include "bem_contact/base/tuned.hpp"
#include "bem_contact/contact/settings.hpp"
#include "bem_contact/scene/settings.hpp"

/// Tuned numbers of sequence/plan. For the words see base/tuned.hpp.
namespace bem_contact {

// Estimate of the contact.

/// 1 (share of the approach). Where the undeformed distance is below this share the bodies may touch: the
/// estimate's own contact needs penetration_share, and the rest is for what the estimate is off by. A contact
/// that reaches the edge is solved again on a larger grid, and so is one whose approach lets the bodies meet
/// elsewhere.
BEM_CONTACT_TUNED(double, potential_share, 0.75);
BEM_CONTACT_RELATION(potential_share > penetration_share);
/// 1. Creepage at which about half of a contact slips. It says which part of full friction bears load in the
/// estimate.
BEM_CONTACT_TUNED(double, half_slip_creepage, 0.002);
/// 1 (slices). Distance from the deepest slice at which its own part of an integral over 1/r is taken.
BEM_CONTACT_TUNED(double, slice_self_distance, 0.25);
/// 1. Where the arithmetic-geometric mean ends: its error is the square of this.
BEM_CONTACT_TUNED(double, elliptic_tolerance, 1e-9);

// Grid.

/// 1. Rows and columns that a plan has beside the potential contact, on each side.
BEM_CONTACT_TUNED(int, spare_elements, 1);
/// 1. Fewest rows of a plan.
BEM_CONTACT_TUNED(int, fewest_rows, 3);

// Number of elements.

/// 1. Fewest elements in contact: the error is estimated by a companion with a quarter of them.
BEM_CONTACT_TUNED(int, fewest_elements, 180);
BEM_CONTACT_RELATION(fewest_elements >= 4 * contact::least_companion);
/// 1. Elements in contact that are tried first; the median contact has an error of usual_error with them.
BEM_CONTACT_TUNED(int, usual_elements, 200);
BEM_CONTACT_TUNED(double, rare_factor, 7.0); ///< 1. It needs so many times the median contact's elements.
/// 1. Order of the estimated error in the number of elements: adhesion is of first order in their length
/// (0.5), the normal problem of second (1).
BEM_CONTACT_TUNED(double, error_order, 0.65);
/// 1. Elements beyond what the accuracy is predicted to need.
BEM_CONTACT_TUNED(double, element_reserve, 1.1);
/// 1. It is multiplied by at least this if the case is solved again. 1.3 takes an error down by a sixth only,
/// which is less than errors scatter. With 1.6 sequences by influence files take 4 % less and their slowest
/// cases a fifth less; those by the half-space as long.
BEM_CONTACT_TUNED(double, least_retry, 1.6);
BEM_CONTACT_TUNED(double, most_change, 4.0); ///< 1. It is never multiplied by more than this.
/// 1. Elements in contact that are tried at most for an accuracy: a second or a few.
BEM_CONTACT_TUNED(int, most_elements, 12000);
BEM_CONTACT_TUNED(int, most_elements_full, 4000); ///< 1. The same with numbers that depend on both rows.
/// 1. Length of elements over their width at the most.
BEM_CONTACT_TUNED(double, longest_element, 1.1);
/// 1. The same with influence numbers that depend on both rows. The cost of a product A p grows there as the
/// square of the rows: short elements in few rows are cheaper.
BEM_CONTACT_TUNED(double, longest_element_full, 0.8);
/// 1. Sizes of elements are powers of 2^(1/this), so that influence numbers serve several cases.
BEM_CONTACT_TUNED(int, sizes_per_octave, 4);
/// 1. Former cases teach the area in contact over the predicted area. For a contact of another kind (not
/// alike()) this ratio is raised to at least this.
BEM_CONTACT_TUNED(double, least_area_ratio, 0.7);
BEM_CONTACT_TUNED(double, most_area_ratio, 1.4); ///< 1. There it is lowered to at most this.
BEM_CONTACT_RELATION(least_area_ratio <= most_area_ratio);

// Choice of the model: what is predicted that a model misses.

/// 1. Half-space in plane strain: this times (turn of the normal / 2)^2 of the largest pressure. Hertz
/// against Persson (1964) is low by 0.39, against the sphere in a spherical seat by 0.66 to 0.61: the largest
/// of them.
BEM_CONTACT_TUNED(double, halfspace_error, 0.66);

// In three dimensions, at equal forces. Bounds of what was seen in the 108 scenes of seed 1
// (tools/benchmarks/model_choice), against finite elements on the same elements.

BEM_CONTACT_TUNED(double, least_pressure_error, 0.001); ///< 1. Of pmax, of either model.
/// 1/rad. Half-space: this times the turn. At most 0.019 was seen, at 0.14 to 1.4 rad.
BEM_CONTACT_TUNED(double, halfspace_turn_error, 0.021);
BEM_CONTACT_TUNED(double, tangent_plane_turn_error, 0.0025); ///< 1/rad. Of tangent planes.
/// 1. Effect of a body's end on the largest pressure: this times (size of the contact / distance)^2. Chosen
/// to be safe: a wheel whose outer end stands on the rail is off by 0.3 % where this predicts 27 %.
BEM_CONTACT_TUNED(double, edge_error, 0.05);
/// mm. Bodies stretch along the normal by force / (E* this), and what of it points along y counts as
/// position: 0.022 mm under 1e5 N at a gauge corner, for which this gives 0.024 mm.
BEM_CONTACT_TUNED(double, stretch_depth, 20.0);
/// rad. Rows turn by the same angle, if it is to within this.
BEM_CONTACT_TUNED(double, equal_turn, 1e-9);

} // namespace bem_contact
