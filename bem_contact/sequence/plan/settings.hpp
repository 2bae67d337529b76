#pragma once

#include "bem_contact/base/tuned.hpp"

/// Tuned numbers of sequence/plan. For the words see base/tuned.hpp.
namespace bem_contact {

// Estimate of the contact.

/// 1 (share of the approach). Where the undeformed distance is below this share the bodies may touch: the
/// estimate's own contact needs 0.55, and the rest is for what the estimate is off by. A contact that reaches
/// the edge is solved again on a larger grid, and so is one whose approach lets the bodies meet elsewhere.
BEM_CONTACT_TUNED(double, potential_share, 0.75);
/// mm. Least approach for which a potential contact is planned: a grid is needed under no load too.
BEM_CONTACT_TUNED(double, least_approach, 1e-4);
/// 1. Creepage at which about half of a contact slips. It says which part of full friction bears load in the
/// estimate.
BEM_CONTACT_TUNED(double, half_slip_creepage, 0.002);
/// 1. Least value of the vertical force of pressure and shear over that of the pressure: where friction takes
/// all of it away, the estimate would be without end.
BEM_CONTACT_TUNED(double, least_lift, 0.05);
BEM_CONTACT_TUNED(double, most_lift, 4.0); ///< 1. Largest value of the same ratio.
/// 1. With shear, the approach of the estimate may be so many times largest_approach (scene/settings.hpp): an
/// overestimate costs a grid that is too coarse.
BEM_CONTACT_TUNED(double, most_approach_with_shear, 2.0);
/// 1 (slices). Distance from the deepest slice at which its own part of an integral over 1/r is taken.
BEM_CONTACT_TUNED(double, slice_self_distance, 0.25);
/// 1. Where the arithmetic-geometric mean ends: its error is the square of this.
BEM_CONTACT_TUNED(double, elliptic_tolerance, 1e-9);
/// 1/mm. Least half of the curvature along x that the estimate of a given distance takes: of a wheel of
/// radius 50 m. Chosen.
BEM_CONTACT_TUNED(double, least_half_curvature, 1e-5);

// Grid.

/// 1. Most rows or columns of a grid, as grid.mx and grid.ms have it.
BEM_CONTACT_TUNED(int, most_rows, 4096);
/// 1. Rows and columns that a plan has beside the potential contact, on each side.
BEM_CONTACT_TUNED(int, spare_elements, 1);
/// 1. Fewest rows of a plan.
BEM_CONTACT_TUNED(int, fewest_rows, 3);

// Number of elements.

/// 1. Fewest elements in contact: the error is estimated by a companion with a quarter of them, which
/// needs 40.
BEM_CONTACT_TUNED(int, fewest_elements, 180);
/// 1. Elements in contact that are tried first; the median contact has an error of usual_error with them.
BEM_CONTACT_TUNED(int, usual_elements, 200);
BEM_CONTACT_TUNED(double, usual_error, 0.003); ///< 1. That error, relative.
/// 1. One contact in a hundred has this relative error with usual_elements.
BEM_CONTACT_TUNED(double, rare_error, 0.02);
BEM_CONTACT_TUNED(double, rare_factor, 7.0); ///< 1. It needs so many times the median contact's elements.
/// 1. Order of the estimated error in the number of elements: adhesion is of first order in their length
/// (0.5), the normal problem of second (1).
BEM_CONTACT_TUNED(double, error_order, 0.65);
/// 1. Elements beyond what the accuracy is predicted to need.
BEM_CONTACT_TUNED(double, element_reserve, 1.1);
/// 1. Errors scatter: the number of elements comes down to no less than this share of the last one.
BEM_CONTACT_TUNED(double, least_change, 0.35);
/// 1. It is multiplied by at least this if the case is solved again. 1.3 takes an error down by a sixth only,
/// which is less than errors scatter. With 1.6 sequences by influence files take 4 % less and their slowest
/// cases a fifth less; those by the half-space as long.
BEM_CONTACT_TUNED(double, least_retry, 1.6);
BEM_CONTACT_TUNED(double, most_change, 4.0); ///< 1. It is never multiplied by more than this.
/// 1. The next case begins between the usual number of elements and what this one needed: at this share of
/// the way in the logarithm. A case that needed many says little of the next. With .5 the cases of
/// data/scenes/cases_*.toml take .5 to 1 times the processor's time that they take with 1, with 0 more.
BEM_CONTACT_TUNED(double, learnt_share, 0.5);
/// 1. Elements in contact that are tried at most for an accuracy: a second or a few.
BEM_CONTACT_TUNED(int, most_elements, 12000);
BEM_CONTACT_TUNED(int, most_elements_full, 4000); ///< 1. The same with numbers that depend on both rows.
/// 1. Fewest elements in contact for usual_accuracy with influence files; for another accuracy in proportion
/// to its power -0.5. Of 180 to 900 elements tried on the cases of data/scenes/cases_fem.toml, 180, 300 and
/// 400 take the least time for 5, 2 and 1 %: fewer are solved more often, more are dear each time.
BEM_CONTACT_TUNED(int, fewest_elements_bodies, 300);
BEM_CONTACT_TUNED(double, usual_accuracy, 0.02); ///< 1. Of `fewest_elements_bodies`.
/// 1. Length of elements over their width at the most.
BEM_CONTACT_TUNED(double, longest_element, 1.1);
/// 1. The same with influence numbers that depend on both rows. The cost of a product A p grows there as the
/// square of the rows: short elements in few rows are cheaper.
BEM_CONTACT_TUNED(double, longest_element_full, 0.8);
/// 1. Length of elements over their width at the least, in a contact that is wider than long.
BEM_CONTACT_TUNED(double, shortest_element_aspect, 0.4);
/// 1. Where elements cannot get shorter, they get no narrower than this share of their length: ever narrower
/// rows would cost much and say little.
BEM_CONTACT_TUNED(double, narrowest_element_share, 0.25);
/// 1. Sizes of elements are powers of 2^(1/this), so that influence numbers serve several cases.
BEM_CONTACT_TUNED(int, sizes_per_octave, 4);
/// mm. Length of elements where the estimate has no contact.
BEM_CONTACT_TUNED(double, default_dx, 0.5);
BEM_CONTACT_TUNED(double, default_ds, 0.25); ///< mm. Width of elements there.
/// 1. Former cases teach the area in contact over the predicted area. For a contact of another kind (not
/// alike()) this ratio is raised to at least this.
BEM_CONTACT_TUNED(double, least_area_ratio, 0.7);
BEM_CONTACT_TUNED(double, most_area_ratio, 1.4); ///< 1. There it is lowered to at most this.
/// 1. An influence file serves elements of at least 10 / (its largest wavenumber). Elements are chosen so
/// many times as long: a wheel's file means lengths at its reference radius, and the contact lies elsewhere.
BEM_CONTACT_TUNED(double, wavelength_reserve, 1.05);

// Choice of the model: what is predicted that a model misses.

/// 1. Half-space in plane strain: this times (turn of the normal / 2)^2 of the largest pressure. Hertz
/// against Persson (1964) is low by 0.39, against the sphere in a spherical seat by 0.66 to 0.61: the largest
/// of them.
BEM_CONTACT_TUNED(double, halfspace_error, 0.66);
/// 1. Tangent planes in plane strain, likewise, on what is no circle of equal bodies: against the influence
/// functions of a 60E1 rail and an S1002 wheel 0.04 to 0.22.
BEM_CONTACT_TUNED(double, tangent_plane_error, 0.24);

// In three dimensions, at equal forces. Bounds of what was seen in the 108 scenes of seed 1
// (tools/benchmarks/model_choice), against finite elements on the same elements.

BEM_CONTACT_TUNED(double, least_pressure_error, 0.001); ///< 1. Of pmax, of either model.
/// 1/rad. Half-space: this times the turn. At most 0.019 was seen, at 0.14 to 1.4 rad.
BEM_CONTACT_TUNED(double, halfspace_turn_error, 0.021);
BEM_CONTACT_TUNED(double, tangent_plane_turn_error, 0.0025); ///< 1/rad. Of tangent planes.
/// 1/rad. Either, more of it between unlike materials: steel on aluminium is off by 0.008.
BEM_CONTACT_TUNED(double, unlike_turn_error, 0.01);
/// 1. Effect of a body's end on the largest pressure: this times (size of the contact / distance)^2. Chosen
/// to be safe: a wheel whose outer end stands on the rail is off by 0.3 % where this predicts 27 %.
BEM_CONTACT_TUNED(double, edge_error, 0.05);
/// mm. Bodies stretch along the normal by force / (E* this), and what of it points along y counts as
/// position: 0.022 mm under 1e5 N at a gauge corner, for which this gives 0.024 mm.
BEM_CONTACT_TUNED(double, stretch_depth, 20.0);
/// mm. Least distance by which the wheel is moved aside to see how steep results are in its position. Chosen.
BEM_CONTACT_TUNED(double, least_aside, 1e-3);
/// mm. Of a wheel on a rail the creepage of free rolling differs by approach / this, times 1 +
/// creep_inclination times the inclination: by 1e-5 to 6e-5 on the tread, 1e-4 and more at the flange.
BEM_CONTACT_TUNED(double, wheel_creep_radius, 1100.0);
BEM_CONTACT_TUNED(double, creep_inclination, 7.0); ///< 1/rad.
/// mm. The same of rollers in grooves, small bodies whose surfaces stretch differently: 4e-5 to 2e-4.
BEM_CONTACT_TUNED(double, roller_creep_radius, 190.0);
/// 1. Kalker's C11 of a circle, nu = 0.28.
BEM_CONTACT_TUNED(double, creep_coefficient, 4.2);
/// 1. Least slope of the shear force over that without slip: spin and yaw leave some of it. Chosen.
BEM_CONTACT_TUNED(double, least_slope_share, 0.05);
/// 1. If only the longitudinal force is given, the lateral creepage is prescribed: its error counts by this
/// share.
BEM_CONTACT_TUNED(double, side_creep_share, 0.45);
BEM_CONTACT_TUNED(double, least_shear_error, 0.001); ///< 1. Of shear forces, of either model.
BEM_CONTACT_TUNED(double, shear_turn_error, 0.02);   ///< 1/rad. Of them: this times the turn.
BEM_CONTACT_TUNED(double, least_power_error, 0.004); ///< 1. Of friction's power, of either model.
BEM_CONTACT_TUNED(double, power_turn_error, 0.01);   ///< 1/rad. Of it: this times the turn.
/// 1. Of it where creepages are given: this times the error of creepage over the slip.
BEM_CONTACT_TUNED(double, given_creep_power, 1.5);
/// 1. Power of friction on a rail: both of these terms count by this share, because spin does most of the
/// work there. At most 0.15 was seen.
BEM_CONTACT_TUNED(double, rail_power_share, 0.2);
/// 1. Of it where creepages are found: this times their error over least_creepage.
BEM_CONTACT_TUNED(double, found_creep_power, 0.5);
/// 1. Hertz: this times what the undeformed distance departs from a quadratic, over the approach. A waviness
/// as long as the contact does not do more to the pressure.
BEM_CONTACT_TUNED(double, hertz_deviation_error, 5.0);
/// rad. Rows turn by the same angle, if it is to within this.
BEM_CONTACT_TUNED(double, equal_turn, 1e-9);

// Hertz's closed form.

/// 1. Rows and columns of the smallest window in which a quadratic is fitted.
BEM_CONTACT_TUNED(int, smallest_window, 5);
/// 1. Rounds of window and fit; the window stops to change after a few.
BEM_CONTACT_TUNED(int, fit_rounds, 10);
/// 1. Determinant of a quadratic over its squared trace, below which it is curved one way only.
BEM_CONTACT_TUNED(double, least_curvature_ratio, 1e-12);

// Influence functions.

/// 1. Share of the wheel radius by which that of an influence file may differ.
BEM_CONTACT_TUNED(double, radius_tolerance, 0.01);

} // namespace bem_contact
