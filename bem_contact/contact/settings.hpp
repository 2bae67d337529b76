#pragma once

#include "bem_contact/base/tuned.hpp"

/// Tuned numbers of the room (bem_contact/base/tuned.hpp explains the form) and of its grid and check. Those
/// of operator, normal, tangential and coupled stand in their own settings.hpp. "chosen" means that no
/// measurement is on record; tools/benchmarks/sensitivity shows what each changes.
namespace bem_contact::contact {

// --- work.cpp: the budget of one case ---

/// Units of work (work.hpp). Some minutes: about 10 times what the costliest accepted case takes (7e8).
BEM_CONTACT_TUNED(double, most_work, 1e10);
/// Rows. A product A p with influence numbers that depend on both rows (that are not translational) costs
/// 1 + rows / this units an element (measured).
BEM_CONTACT_TUNED(double, rows_per_unit, 20.0);
/// 1. Before the first such product the numbers are transformed. For each pair of components that costs
/// rows^2 columns^2 / this units (measured).
BEM_CONTACT_TUNED(double, spectra_terms_per_unit, 75);
/// Units. A Gauss-Seidel sweep costs this times the square of its elements (measured).
BEM_CONTACT_TUNED(double, sweep_units, 0.08);

// --- grid/boxes.cpp: operators on boxes around the contact ---

/// Rows. Between two boxes there are at least so many rows without contact. Chosen: every box is widened by a
/// margin (normal_margin_divisor), so that boxes nearer to each other save nothing.
BEM_CONTACT_TUNED(int, rows_between_boxes, 8);
/// Boxes. Chosen: the work of several boxes grows with their square.
BEM_CONTACT_TUNED(int, most_boxes, 3);
/// 1. Several boxes are used if they have fewer elements than this share of the one box around all.
BEM_CONTACT_TUNED(double, several_boxes_share, 0.6);
/// 1. Boxes of former elements are used again up to this many times the size that is needed. Chosen.
BEM_CONTACT_TUNED(double, box_reuse_factor, 2.5);

// --- grid/larger_elements.cpp ---

/// 1. An undeformed distance beyond this times the largest in contact means that there is no opposite
/// surface. Chosen: real distances next to a contact are below it, missing surfaces are far above it.
BEM_CONTACT_TUNED(double, distance_without_surface, 10);

// --- tangential and coupled ---

/// 1. Forces and displacements settle at this times the tolerance asked for, which the solvers reach.
BEM_CONTACT_TUNED(double, settling_factor, 10);

// --- check ---

/// Terms. Direct sums of more take longer than a transform where numbers are translational. Where they are
/// not, direct sums are always quicker: 0.2 s against 2 s with 9,000 elements in contact, since the transform
/// would be made for one product.
BEM_CONTACT_TUNED(double, many_plane_terms, 2e7);
/// Direct sums confirm a transform at an element of each row in contact and at so many all over the grid, and
/// agree with it so closely (relative).
BEM_CONTACT_TUNED(int, confirmed_elsewhere, 30);
BEM_CONTACT_TUNED(double, agreement_of_sums, 1e-9);
/// 1. The certificate's slip scale is at least this times pmax times the largest self number: displacements
/// have rounding errors in proportion to that product. In steady rolling slip is the difference of
/// displacements one element apart, which has less of them; shift_slip_rounding is for all other motions.
BEM_CONTACT_TUNED(double, steady_slip_rounding, 1e-12);
BEM_CONTACT_TUNED(double, shift_slip_rounding, 1e-9);
/// 1. The slip scale is also at least this times the creepage found: where that cancels the prescribed rigid
/// slip, the sum of both is only rounding.
BEM_CONTACT_TUNED(double, creepage_rounding, 1e-9);
/// 1. The companion is solved with this tolerance, and accepted with this violation: an estimate is known to
/// some per cent at best.
BEM_CONTACT_TUNED(double, companion_tolerance, 1e-5);
BEM_CONTACT_TUNED(double, companion_violation, 1e-4);
/// 1. What a rough creepage of free rolling may be off by, over its stated error.
BEM_CONTACT_TUNED(double, free_creepage_share, 0.1);
/// Elements of the companion in contact, at least; in a single row or column. Fewer say nothing: on Hertz
/// contacts with 12 elements across (28 in the companion) the two agree by chance.
BEM_CONTACT_TUNED(int, least_companion, 40);
BEM_CONTACT_TUNED(int, least_companion_line, 7);

// Stated errors of printed numbers: a share of the change from elements twice as large, and a local part.
// They are fitted to random cases of tools/benchmarks/estimates: those of shear to 870 (seeds 1, 2, 6 and 7),
// the others to 415 (1 and 2), so that about 96 in 100 true errors are
// below the stated ones and the median of stated over true is least. Those of pmax and of shear were set anew
// on 1200 (8 to 11), those of temperatures on 720 (1, 2, 6 to 9 and 12 to 17). shear_local, shear_deviation,
// both of adhesion and those of creepages were set anew on 1357 by half-spaces (8, 9, 41 and
// 51; 906 of them with free rolling), those of a prescribed Fs and normal_adhesion on 346 (111 to 141).
// tools/BENCHMARKS.md, section 9, judges them on other cases.

BEM_CONTACT_TUNED(double, pmax_change, 0.02);     ///< 1. Share of the change of pmax,
BEM_CONTACT_TUNED(double, pmax_local, 0.092);     ///< 1. and of how far p_n falls beside its peak,
BEM_CONTACT_TUNED(double, pmax_rough, 0.06);      ///< 1. and of the roughness of the gap, as a pressure.
BEM_CONTACT_TUNED(double, area_border, 0.16);     ///< 1. Share of the area of the elements on the border.
BEM_CONTACT_TUNED(double, adhesion_change, 0.25); ///< 1. Share of the change of the adhesive share,
BEM_CONTACT_TUNED(double, adhesion_local, 1.2);   ///< 1. elements whose state is in doubt anyway,
BEM_CONTACT_TUNED(double, adhesion_border, 1.05); ///< 1. and for the root of the border of adhesion.
/// 1. Fx, Fs, Fy, Mz and those of patches are sums over elements. Their error is the sum of three parts. The
/// first is this share of the change of the sum.
BEM_CONTACT_TUNED(double, shear_change, 0.475);
/// 1. The second is this share of the mean absolute value of an element: the border of the contact is known
/// to a part of an element only.
BEM_CONTACT_TUNED(double, shear_local, 0.85);
/// 1. The second part is bounded. Compare the shear of each element with the share of the sum that its
/// pressure would give it: the bound takes this many times the mean deviation in place of the mean absolute
/// value.
BEM_CONTACT_TUNED(double, shear_deviation, 6.0);
/// 1. The third is this share of the root of the sum of squares over the elements in adhesion, because the
/// errors of these elements are taken as independent.
BEM_CONTACT_TUNED(double, shear_adhesion, 0.5);
/// 1. The third part of Fx. It is smaller: the p_x that spin causes has opposite signs on both sides of the
/// contact and cancels. In Fs spin leaves a difference of tractions, whose error is as large as theirs.
BEM_CONTACT_TUNED(double, shear_adhesion_x, 0.3);
/// 1. The errors of these sums grow with this power of Region::elongation(). On elements longer than wide, as
/// scenes without [grid] have them, 88 to 94 % of 100 cases were within errors without it (seed 191).
BEM_CONTACT_TUNED(double, shear_elongation, 0.75);
/// 1. The same for the moment about the normal: with the power above 92 % of 100 cases were within.
BEM_CONTACT_TUNED(double, moment_elongation, 0.95);
/// 1. The third part of the normal force of a patch. Shear changes this force where normals turn within the
/// contact.
BEM_CONTACT_TUNED(double, normal_adhesion, 0.6);
/// 1. The pressure changes it there too: by this share of what its sum exceeds its resultant by, divided by
/// the number of elements in contact. Chosen on columns without friction: "one column" of
/// tools/benchmarks/estimates, seeds 291, 301 and 311.
BEM_CONTACT_TUNED(double, normal_bent, 0.15);
/// 1. Fy has an error from the direction of the pressure too: this share of the pressure beside its mean
/// direction, divided by the number of elements in contact. The border of the contact is known to a part of
/// an element only.
BEM_CONTACT_TUNED(double, direction_local, 0.5);
/// 1. The local part of Mz is this share of the same formula: moments have smaller errors than forces.
BEM_CONTACT_TUNED(double, moment_share, 0.87);
BEM_CONTACT_TUNED(double, temperature_change, 0.17); ///< 1. Share of the change of the highest temperature,
BEM_CONTACT_TUNED(double, temperature_peak, 0.11);   ///< 1. of how far it falls beside its peak,
BEM_CONTACT_TUNED(double, temperature_local, 0.17);  ///< 1. and of its rise over the elements in contact.
BEM_CONTACT_TUNED(double, approach_change, 0.2);     ///< 1. Share of the change of the approach,
BEM_CONTACT_TUNED(double, approach_local, 0.3);      ///< 1. of it over the elements in contact,
BEM_CONTACT_TUNED(double, approach_peak, 0.018); ///< 1. and of it times the relative fall beside the peak.
BEM_CONTACT_TUNED(double, overlap_change, 0.11); ///< 1. Approach of a patch: the same.
BEM_CONTACT_TUNED(double, overlap_local, 0.9);   ///< 1. As above.
BEM_CONTACT_TUNED(double, overlap_peak, 0.034);  ///< 1. As above.
/// 1. The error of a creepage that is found is the sum of three parts. The first is this share of its change.
BEM_CONTACT_TUNED(double, creepage_change, 0.36);
/// 1. The second is this share of the force that larger elements carry elsewhere, times the creepage per unit
/// of force.
BEM_CONTACT_TUNED(double, creepage_moved, 0.058);
/// 1. The third is this share of the force of the elements in adhesion, divided by the root of their number,
/// times the creepage per unit of force.
BEM_CONTACT_TUNED(double, creepage_adhesion, 0.2);
/// 1. The creepage of a prescribed Fs has this share of all three,
BEM_CONTACT_TUNED(double, creepage_s_share, 0.82);
/// 1. and this share of the change of the rigid slip w_s from one element to the next. The front of the
/// contact is known to a part of an element only, and under spin another place has another w_s.
BEM_CONTACT_TUNED(double, creepage_turn, 0.088);

// On one row or one column of elements these stand in place of the numbers above. They are fitted to 720
// lines of 20 to 120 elements (kinds "one row", "one row, forces" and "one column" of
// tools/benchmarks/estimates).
/// 1. Of pmax_local.
BEM_CONTACT_TUNED(double, line_pmax_local, 0.22);
/// 1. Of area_border. Each of the two ends may be off by half an element, and they do not cancel.
BEM_CONTACT_TUNED(double, line_border, 0.62);
/// 1. Local parts of sums of shear count this share: each row of a wider contact has a border of its own.
BEM_CONTACT_TUNED(double, line_shear, 0.34);
/// 1. The same of those of the adhesive share.
BEM_CONTACT_TUNED(double, line_adhesion, 0.42);
/// 1. Of approach_peak and overlap_peak. The parts that count elements vanish: they were 300 times the error.
BEM_CONTACT_TUNED(double, line_approach_peak, 0.034);
BEM_CONTACT_TUNED(double, line_overlap_peak, 0.062);

// Where no error is stated. On smooth profiles the first two stay below 0.15 and 0.2 and the third below 0.4;
// with noise of 2 to 10 micrometres each case exceeds the second.

BEM_CONTACT_TUNED(double, largest_pmax_change, 0.25); ///< 1. Change of pmax over pmax.
BEM_CONTACT_TUNED(double, largest_curvature, 0.5);    ///< 1. Fall of p_n beside its peak over pmax.
/// 1. Roughness of the undeformed distance over the displacement of one element that bears pmax.
BEM_CONTACT_TUNED(double, largest_roughness, 0.5);

} // namespace bem_contact::contact
