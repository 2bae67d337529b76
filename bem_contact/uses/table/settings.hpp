#pragma once

#include "bem_contact/base/tuned.hpp"

#include <cstddef>

/// The tuned numbers of this room (base/tuned.hpp).
namespace bem_contact::table {

/// 1. Cells whose middle is solved in one round of refining. The last round measures every cell. Fewer leave
/// large errors to that round; more cost solutions that refining throws away.
BEM_CONTACT_TUNED(std::size_t, cells_in_a_round, 400);
/// 1, of the largest error of a round: cells with a larger one are refined. Smaller ones often vanish with
/// the intervals that the others need.
BEM_CONTACT_TUNED(double, worst_share, 0.5);
/// 1, of the largest of a cell's errors along its axes: axes with a larger one are refined, all at once.
BEM_CONTACT_TUNED(double, axis_share, 0.7);
/// 1, of the tolerance: with nested axes, a larger error along the last axis is removed before the axes
/// before it are looked at. A table of a/b from 0.1 to 10 within 1 % takes 26516 points with it.
BEM_CONTACT_TUNED(double, inner_share, 0.5);
/// 1. Rounds, as a guard: each inserts a point at least, and 200 points on an axis are no table.
BEM_CONTACT_TUNED(int, most_rounds, 200);

/// 1. Rings and angles over which the forces of full slip are summed. With four times as many, the sums of
/// 750 poles in and around ellipses of a/b from 0.1 to 10 differ by 3e-5 in the median and 1.2e-3 at most.
BEM_CONTACT_TUNED(int, full_slip_rings, 60);
BEM_CONTACT_TUNED(int, full_slip_angles, 120);
/// 1, over the tolerance. w of the first point above zero: a Hertz contact loses the share w of its slope
/// (Vermeulen and Johnson 1964: F = 1 - (1 - w)^3 = 3 w (1 - w + ...)), so that slopes keep the tolerance.
BEM_CONTACT_TUNED(double, first_creepage, 1.0);
/// 1. Coefficients of linear theory in a creep table: 20 a decade of a/b. Readers take them from the file.
BEM_CONTACT_TUNED(int, coefficients_in_a_decade, 20);
/// 1. Elements at each side of the contact in a creep table: as large as the ellipse, and one more.
BEM_CONTACT_TUNED(int, border_elements, 1);

/// 1, of the length of an axis: a coordinate so little beyond its end is the end. Quotients and logarithms
/// leave the last of 16 digits open.
BEM_CONTACT_TUNED(double, axis_slack, 1e-12);

/// mm. Errors of positions and rolling radii are relative to their range in the table, or to this.
BEM_CONTACT_TUNED(double, shortest_range, 1.0);
/// rad. The same of angles.
BEM_CONTACT_TUNED(double, smallest_turn, 0.1);

} // namespace bem_contact::table
