#pragma once

#include "bem_contact/base/tuned.hpp"

#include <array>

/// The tuned numbers of this room (base/tuned.hpp).
namespace bem_contact {

/// Threads. No case may ask for more: it would spend them waiting. Chosen.
BEM_CONTACT_TUNED(int, most_threads, 64);

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
/// mm. Touch points that are nearer than this are described by bem_contact check.
BEM_CONTACT_TUNED(double, described_distance, 1.0);

// Structural motion.

/// mm. The bodies stand still when a solution moves the contact by less: the lateral force on a gauge corner
/// then is good to about 10 N of 6e4.
BEM_CONTACT_TUNED(double, position_tolerance, 1e-4);
/// mm. A turn of a body counts as the motion that it makes at this distance from the reference point: half
/// the width of a contact.
BEM_CONTACT_TUNED(double, half_contact, 5.0);
/// 1. Most solutions until the bodies stand still: a bound.
BEM_CONTACT_TUNED(int, most_placements, 12);

// Grid.

/// 1. Most rows or columns of a grid, as grid.mx and grid.ms have it.
BEM_CONTACT_TUNED(int, most_rows, 4096);
/// 1. Rows and columns that a plan has beside the potential contact, on each side.
BEM_CONTACT_TUNED(int, spare_elements, 1);
/// 1. Fewest rows of a plan.
BEM_CONTACT_TUNED(int, fewest_rows, 3);
/// 1. How often a grid may grow. It grows by a quarter in s, an eighth on either side in x.
BEM_CONTACT_TUNED(int, most_growths, 6);
BEM_CONTACT_TUNED(int, row_growth_share, 4);    ///< 1. In s by one over this: a quarter.
BEM_CONTACT_TUNED(int, column_growth_share, 8); ///< 1. In x by one over this: an eighth.
BEM_CONTACT_TUNED(int, fewest_more_rows, 4);    ///< 1. Rows by which a grid grows at least.
BEM_CONTACT_TUNED(int, fewest_more_columns, 2); ///< 1. Columns by which it grows at least, on either side.
/// MB. Where influence numbers that depend on both rows would take so much, a rough solution says first which
/// rows and columns the contact needs: with 4,000 elements in contact that takes a third off time and memory.
BEM_CONTACT_TUNED(double, large_numbers, 100.0);
/// 1. Length and width of its elements over those of the plan. 4: its numbers take a 64th of the memory.
BEM_CONTACT_TUNED(int, trim_factor, 4);
/// 1. Its elements count as touching up to this share of the approach between the bodies: in a Hertzian
/// contact up to a fifteenth of the radius beyond the border.
BEM_CONTACT_TUNED(double, near_distance, 0.02);
/// GB. Largest influence numbers, and largest history, that are kept in memory.
BEM_CONTACT_TUNED(double, largest_memory, 8.0);

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
BEM_CONTACT_TUNED(double, least_retry,
                  1.3); ///< 1. It is multiplied by at least this if the case is solved again.
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
/// 1. How often one case may be solved for an accuracy.
BEM_CONTACT_TUNED(int, most_solves, 4);
/// 1. An influence file serves elements of at least 10 / (its largest wavenumber). Elements are chosen so
/// many times as long: a wheel's file means lengths at its reference radius, and the contact lies elsewhere.
BEM_CONTACT_TUNED(double, wavelength_reserve, 1.05);

// Lateral displacement for a lateral force.

/// mm. The search looks this far to either side of position.lateral: farther than a wheelset can move between
/// its flanges (about 7 mm to either side), so that it sees tread and flange.
BEM_CONTACT_TUNED(double, lateral_reach, 12.0);
/// mm. Distance of the displacements that are tried first: a tread's force bends little over it.
BEM_CONTACT_TUNED(double, first_lateral_samples, 2.0);
/// mm. No displacements nearer to each other are tried: a flange takes up its force within about this.
BEM_CONTACT_TUNED(double, lateral_step, 0.5);
/// 1. Forces that differ by less than this, over the resultant of Fy and Fz, count as alike where a tread is
/// sampled: rough solutions of S1002 on 60E1 are uneven by .0005.
BEM_CONTACT_TUNED(double, even_lateral_force, 1e-3);
/// 1. Elements in contact of the rough half-space solutions. Chosen: they only tell which branches there are.
BEM_CONTACT_TUNED(int, lateral_map_elements, 60);
/// mm. Precision of the displacement that rough solutions give to begin from, and of the other displacements
/// that a result names.
BEM_CONTACT_TUNED(double, lateral_root_width, 1e-4);
BEM_CONTACT_TUNED(double, other_lateral_width, 0.02);
/// mm. An extremum of the force is known to this: it changes by its square there.
BEM_CONTACT_TUNED(double, lateral_extremum_width, 0.05);
/// 1. How often the curve is refined at its extremes before a force that it does not reach is refused: the
/// first samples are 2 mm apart, and each round comes nearer. Chosen.
BEM_CONTACT_TUNED(int, extremum_rounds, 3);
/// mm. On a tread the force is uneven from element to element, over some tenths of a millimetre. If it is
/// almost the wanted one at position.lateral, the search tries this distance to either side, then doubles it.
BEM_CONTACT_TUNED(double, first_look_around, 0.1);
/// 1. Two solutions give a slope if their forces differ by this, over the resultant.
BEM_CONTACT_TUNED(double, telling_lateral_force, 1e-4);
/// mm. A larger stated error of the lateral displacement gives a warning: the force then hardly determines
/// it. A rail's gauge is measured to some tenths, and a flange takes up 20 kN within this.
BEM_CONTACT_TUNED(double, unsure_lateral, 0.05);
/// 1. Precision of a lateral force, over the resultant of Fy and Fz: what the certificate allows for
/// prescribed forces.
BEM_CONTACT_TUNED(double, lateral_tolerance, 1e-6);
/// 1. Where the model's lateral force has its extremum, one that falls short of the force asked for by no
/// more than this, over the resultant, counts as met: from element to element forces scatter by more.
BEM_CONTACT_TUNED(double, lateral_scatter, 1e-5);
/// 1. A secant step is lengthened by this, to bracket the force. Chosen.
BEM_CONTACT_TUNED(double, lateral_overshoot, 1.1);
BEM_CONTACT_TUNED(double, longest_lateral_step,
                  0.1); ///< mm. A flange's force changes by its size in a few of them.
BEM_CONTACT_TUNED(int, most_lateral_steps, 25);     ///< 1. Solutions until the force is bracketed. Chosen.
BEM_CONTACT_TUNED(int, most_lateral_calls, 40);     ///< 1. Solutions that narrow a bracket. Chosen.
BEM_CONTACT_TUNED(double, narrowest_lateral, 1e-9); ///< mm. A narrower bracket holds a jump of the force.

// Comparison of models.

/// 1. Creepages beyond free rolling at which longitudinal forces are compared: a driven wheel's on a good
/// track, the same doubled, and a start of full slip.
inline constexpr std::array<double, 3> compared_creepages{5e-4, 1e-3, 2e-3};
/// 1. A model whose lateral force at the reference's position is as near to the reference's as this, over the
/// resultant of Fy and Fz, is compared there. On a tread Fy hardly depends on the position: at cant 1:40 the
/// half-space's is within .0003. The place where it is exactly the same lies .28 mm off, where pmax is 12 %
/// off.
BEM_CONTACT_TUNED(double, same_lateral_force, 0.005);

// Start from the case before.

/// 1. From this number of elements on, a former case is no start if its elements were longer or wider by more
/// than coarse_former: what the solver itself finds on elements twice as large is nearer.
BEM_CONTACT_TUNED(int, many_elements, 2000);
BEM_CONTACT_TUNED(double, coarse_former, 1.5); ///< 1. Length and width over the wanted ones.
/// 1. Two areas are the same contact if they overlap by this share of the smaller one.
BEM_CONTACT_TUNED(double, alike_overlap, 0.3);
/// mm. Least extent of an area: it may be one slice of the estimate.
BEM_CONTACT_TUNED(double, least_extent, 0.2);
/// 1. Influence numbers of this many grids are kept: the numbers of one grid take up to 8 GB.
BEM_CONTACT_TUNED(int, numbers_kept, 6);
/// MB. But no more than this, the last grid's not counted; and the same for the rail's own numbers. A case of
/// 2 % accuracy has 2 to 20 MB.
BEM_CONTACT_TUNED(double, largest_kept_numbers, 200.0);
/// MB. No more influence functions than this are kept beside the pair used last and the rails of the kept
/// numbers. Chosen: five pairs of whole running surfaces, 400 stations each, which have 384 MB a pair.
BEM_CONTACT_TUNED(double, largest_kept_files, 2000.0);
BEM_CONTACT_TUNED(int, profiles_kept, 100); ///< 1. Pairs of profiles that are kept: 0.5 MB each. Chosen.
BEM_CONTACT_TUNED(int, operators_kept, 3);  ///< 1. Grids whose operators are kept: they take more.

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

/// 1 (rows). How much of a row must lie on the strip of an influence file, on either side of its middle: rows
/// of equal width on the rail are a hair shorter or longer on the wheel.
BEM_CONTACT_TUNED(double, row_on_strip, 0.49);
/// 1. Share of the wheel radius by which that of an influence file may differ.
BEM_CONTACT_TUNED(double, radius_tolerance, 0.01);
/// rad. How far the surface of a rail's file may turn otherwise than a patch.
BEM_CONTACT_TUNED(double, rail_turn_tolerance, 0.02);
/// rad. The same for the wheel's, whose surface need not follow the rail's.
BEM_CONTACT_TUNED(double, wheel_turn_tolerance, 0.2);

// Warnings and stresses.

/// 1. Discretisation error above which the elements are said to be too large.
BEM_CONTACT_TUNED(double, poor_discretisation, 0.2);
/// 1. Elements of a patch below which they are said to be few: an error is off by its own size there
/// (tools/BENCHMARKS.md).
BEM_CONTACT_TUNED(int, few_elements, 40);
/// 1. Elements across a patch below which they are said to be too large: each is a fifth of it.
BEM_CONTACT_TUNED(int, fewest_across, 5);
/// 1. A patch that bears less than this share of the largest one's force has no such warning.
BEM_CONTACT_TUNED(double, minor_patch, 0.05);
/// MPa. Least yield strength of wheels of grade ER7 (EN 13262); rails of grade R260 have about the same.
BEM_CONTACT_TUNED(double, yield_strength, 520.0);
/// 1. The mean pressure of a fully plastic contact is about so many times the yield strength (Tabor 1951).
BEM_CONTACT_TUNED(double, yield_factor, 3.0);
/// MPa. A body with a smaller Young's modulus is not of steel, and its strength is not known.
BEM_CONTACT_TUNED(double, least_steel_modulus, 1.5e5);
/// 1. A larger creepage is probably a mistake: a wheel that slides or spins as a whole.
BEM_CONTACT_TUNED(double, largest_creepage, 0.1);
/// mm. Contact lower than this below the top of the rail is beyond its head: gauge is measured 14 mm below
/// the top, and worn flanges touch little lower.
BEM_CONTACT_TUNED(double, head_depth, 18.0);
/// mm. Room that a strip gets on either side beyond the rows of the frictionless contact. Chosen.
BEM_CONTACT_TUNED(double, strip_reserve, 1.0);
/// mm. The station width of the body files of data/bodies.
BEM_CONTACT_TUNED(double, usual_station_width, 0.25);
/// 1. From so many steps of a history on, progress is reported.
BEM_CONTACT_TUNED(int, many_steps, 1000);
/// 1. Most points at which stresses are computed: some minutes.
BEM_CONTACT_TUNED(double, most_stress_points, 1e6);
BEM_CONTACT_TUNED(double, most_stress_sums, 1e9); ///< 1. Most products of points and elements: some minutes.
/// 1 (widths). Half length of a plane-strain element where stresses are summed.
BEM_CONTACT_TUNED(double, endless_element, 1e6);

// Repeated results.

/// mm. A length near zero is compared as if it were this long: a thousandth of a millimetre is what profiles
/// are measured to.
BEM_CONTACT_TUNED(double, least_length, 1e-3);
/// 1. The same for creepages: at a thousandth a wheel has left the range where force and creepage are
/// proportional.
BEM_CONTACT_TUNED(double, least_creepage, 1e-3);

/// 1. Two solutions with falling friction are two if their shear forces differ by more than this share of the
/// sum of mu p_n: a hundred times what the certificate allows.
BEM_CONTACT_TUNED(double, least_branch_difference, 1e-4);
/// 1. Sliding as a whole: steps between friction and heat, the part of each that is taken, and the change of
/// mu over mu(0) at which they end. A fifth settles where mu falls by as much as four times its own change.
BEM_CONTACT_TUNED(int, most_heat_changes, 100);
BEM_CONTACT_TUNED(double, heat_damping, 0.2);
BEM_CONTACT_TUNED(double, least_heat_change, 1e-4);
/// 1. Most steps of the search for its slip velocity, and bits of it: it is said with three digits.
BEM_CONTACT_TUNED(int, most_sliding_steps, 60);
BEM_CONTACT_TUNED(int, sliding_bits, 12);

} // namespace bem_contact
