#pragma once

#include "bem_contact/base/tuned.hpp"

/// The tuned numbers of this room (base/tuned.hpp).
namespace bem_contact {

// Tables of profiles.

/// mm. A profile is tabulated at least this finely: the contact search walks from node to node, and cubic
/// pieces this short follow every curvature of a rail or wheel.
BEM_CONTACT_TUNED(double, largest_table_step, 0.1);
/// mm. The table gets no finer, so that noise in a measured profile cannot make it endless.
BEM_CONTACT_TUNED(double, smallest_table_step, 2e-3);
/// mm. A step of the table is halved until its middle is this close to the curve; gaps are known as closely.
BEM_CONTACT_TUNED(double, table_tolerance, 1e-9);

// Contact locus.

/// rad. A node at which the tangent turns by less is no edge; rounding of the table stays below.
BEM_CONTACT_TUNED(double, smooth_turn, 1e-9);
/// rad. Turn of the tangent between two nodes of the locus at an edge: 0.1 mm of an edge rounded with 20 mm.
BEM_CONTACT_TUNED(double, edge_step, 0.005);

// Contact search.

/// mm. Minima of the distance with a barrier lower than this between them are one minimum: under a wheel load
/// bodies approach by a thousand times as much, so that elastically the two are the same.
BEM_CONTACT_TUNED(double, flat_distance, 2e-5);
/// 1 (node intervals, 0.1 mm each). How closely the end of a flat stretch is found.
BEM_CONTACT_TUNED(double, flat_end_width, 1e-6);
/// 1. Newton steps for the height of the rail at y. They converge quadratically; the number is a bound.
BEM_CONTACT_TUNED(int, height_newton_steps, 30);
/// 1 (share of an interval), and mm for y of 1 mm. Where these Newton steps end: a digit above rounding.
BEM_CONTACT_TUNED(double, height_tolerance, 1e-13);

// Undeformed distance.

/// mm. A row farther from the wheel has no undeformed distance: far beyond any approach and any flange root.
BEM_CONTACT_TUNED(double, farthest_row, 20.0);
/// mm. A wheel that overlaps the rail by more is the other side of the flange, not the contact.
BEM_CONTACT_TUNED(double, deepest_overlap, 2.0);
/// mm of the wheel's profile. How far the crossing with a section x = const may lie from that with the locus.
/// Half of a flange's width: rows and sections of one contact stay on the same side of the flange.
BEM_CONTACT_TUNED(double, section_margin, 6.0);
/// 1. The nearest node is looked for among every so many (1.2 mm), then downhill: no rail or wheel has two
/// minima of the distance so near to each other.
BEM_CONTACT_TUNED(int, node_stride, 12);
/// 1. Rows for which that is begun together. Larger groups have more nodes within their reach. Measured.
BEM_CONTACT_TUNED(int, rows_together, 16);
/// 1. Room for rounding in the square of that reach.
BEM_CONTACT_TUNED(double, rounding_of_reach, 1e-12);
/// 1. Steps of the search for a crossing: a bound. One in eight halves the bracket, so that it always
/// shrinks.
BEM_CONTACT_TUNED(int, crossing_steps, 60);
BEM_CONTACT_TUNED(int, crossing_halving_period, 8); ///< 1. As above.
/// 1 (share of an interval of 0.1 mm) and mm. Where that search ends: a digit above rounding.
BEM_CONTACT_TUNED(double, crossing_width, 1e-14);
BEM_CONTACT_TUNED(double, crossing_distance, 1e-13); ///< mm. As above.

// Roll of a wheelset.

/// 1. Steps to the roll at which both wheels stand on their rails. Each is a secant step; 3 or 4 are usual. A
/// bound.
BEM_CONTACT_TUNED(int, roll_steps, 40);

// Slices and planar rows.

/// mm. Width of the slices of the rail's head: 30 of them lie in a contact of 6 mm.
BEM_CONTACT_TUNED(double, slice_width, 0.2);
/// mm. A slice farther from the wheel is left out: three times the largest approach.
BEM_CONTACT_TUNED(double, farthest_slice, 3.0);
/// 1. Least curvature along x of a slice, in curvatures of the wheel: a yawed hollow wheel may have none, and
/// the estimate needs some.
BEM_CONTACT_TUNED(double, least_slice_curvature, 0.05);
/// mm. Steps in which the bracket of a planar row is found; the rail turns by little over each.
BEM_CONTACT_TUNED(double, planar_step, 0.5);

} // namespace bem_contact
