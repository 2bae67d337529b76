#pragma once

#include "bem_contact/base/tuned.hpp"

/// The tuned numbers of this room (base/tuned.hpp).
namespace bem_contact {

// Tables of profiles.

/// mm. A profile is tabulated at least this finely: the contact search walks from node to node, and cubic
/// pieces this short follow every curvature of a rail or wheel.
BEM_CONTACT_TUNED(double, largest_table_step, 0.1);
/// mm. A step of the table is halved until its middle is this close to the curve; gaps are known as closely.
BEM_CONTACT_TUNED(double, table_tolerance, 1e-9);

// Contact locus.

/// rad. A node at which the tangent turns by less is no edge; rounding of the table stays below.
BEM_CONTACT_TUNED(double, smooth_turn, 1e-9);

// Contact search.

/// mm. Minima of the distance with a barrier lower than this between them are one minimum: under a wheel load
/// bodies approach by a thousand times as much, so that elastically the two are the same.
BEM_CONTACT_TUNED(double, flat_distance, 2e-5);
/// 1 (share of an interval), and mm for y of 1 mm. Where these Newton steps end: a digit above rounding.
BEM_CONTACT_TUNED(double, height_tolerance, 1e-13);

// Uneven wheels and rails.

/// mm. Steps in which a circle of the wheel is sampled: shorter than any contact, and than the rounded edge
/// of a flat that is worth telling from a sharp one.
BEM_CONTACT_TUNED(double, uneven_step, 0.5);
/// mm. Beyond the range of unevenness by this much the surfaces are looked at: a loaded contact reaches
/// there.
BEM_CONTACT_TUNED(double, uneven_margin, 0.1);
/// mm. Overlap at which the length of a contact on uneven bodies is estimated: half of the approach under a
/// wheel load, of which half again is overlap.
BEM_CONTACT_TUNED(double, uneven_depth, 0.03);

// Undeformed distance.

/// mm. A row farther from the wheel has no undeformed distance: far beyond any approach and any flange root.
BEM_CONTACT_TUNED(double, farthest_row, 20.0);
/// 1. Steps of the search for a crossing: a bound. One in eight halves the bracket, so that it always
/// shrinks.
BEM_CONTACT_TUNED(int, crossing_steps, 60);
BEM_CONTACT_TUNED(int, crossing_halving_period, 8); ///< 1. As above.
/// 1 (share of an interval of 0.1 mm) and mm. Where that search ends: a digit above rounding.
BEM_CONTACT_TUNED(double, crossing_width, 1e-14);
BEM_CONTACT_TUNED(double, crossing_distance, 1e-13); ///< mm. As above.

// Rails of sections.

/// rad. A rail is looked at along its line of corresponding points, as long as that is turned by less than
/// this off the rolling direction: on the steepest flank that rises 1:2.5 it is. At a blunt tip it leads
/// around the tip.
BEM_CONTACT_TUNED(double, farthest_turn, 0.4);

// Slices and planar rows.

/// mm. Width of the slices of the rail's head: 30 of them lie in a contact of 6 mm.
BEM_CONTACT_TUNED(double, slice_width, 0.2);
/// 1. Least half curvature along x of a slice, in curvatures of the wheel: a yawed hollow wheel may have
/// none, and the estimate needs some. Of a flat that lies on the rail there is as much less as it is longer.
BEM_CONTACT_TUNED(double, least_slice_curvature, 0.05);
/// mm. Steps in which the bracket of a planar row is found; the rail turns by little over each.
BEM_CONTACT_TUNED(double, planar_step, 0.5);

} // namespace bem_contact
