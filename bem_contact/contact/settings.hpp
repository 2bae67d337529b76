#pragma once

#include "bem_contact/base/tuned.hpp"

/// Tuned numbers of the room (bem_contact/base/tuned.hpp explains the form) and of its grid and check. Those
/// of operator, normal, tangential and coupled stand in their own settings.hpp, those of stated errors in
/// check/error_shares.hpp. "chosen" means that no
/// measurement is on record; tools/benchmarks/sensitivity shows what each changes.
namespace bem_contact::contact {

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

// --- tangential and coupled ---

/// 1. Forces and displacements settle at this times the tolerance asked for, which the solvers reach.
BEM_CONTACT_TUNED(double, settling_factor, 10);

// --- check ---

/// Terms. Direct sums of more take longer than a transform where numbers are translational. Where they are
/// not, direct sums are always quicker: 0.2 s against 2 s with 9,000 elements in contact, since the transform
/// would be made for one product.
BEM_CONTACT_TUNED(double, many_plane_terms, 2e7);
/// 1. The companion is solved with this tolerance, and accepted with this violation: an estimate is known to
/// some per cent at best.
BEM_CONTACT_TUNED(double, companion_tolerance, 1e-5);
BEM_CONTACT_TUNED(double, companion_violation, 1e-4);
BEM_CONTACT_RELATION(companion_tolerance <= companion_violation);
/// Elements of the companion in contact, at least; in a single row or column. Fewer say nothing: on Hertz
/// contacts with 12 elements across (28 in the companion) the two agree by chance.
BEM_CONTACT_TUNED(int, least_companion, 40);
BEM_CONTACT_TUNED(int, least_companion_line, 7);

// Where no error is stated. On smooth profiles the first two stay below 0.15 and 0.2 and the third below 0.4;
// with noise of 2 to 10 micrometres each case exceeds the second.

BEM_CONTACT_TUNED(double, largest_pmax_change, 0.25); ///< 1. Change of pmax over pmax.
BEM_CONTACT_TUNED(double, largest_curvature, 0.5);    ///< 1. Fall of p_n beside its peak over pmax.
/// 1. Roughness of the undeformed distance over the displacement of one element that bears pmax.
BEM_CONTACT_TUNED(double, largest_roughness, 0.5);

} // namespace bem_contact::contact
