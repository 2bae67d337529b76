#pragma once

#include "bem_contact/base/tuned.hpp"

/// Tuned numbers of sequence/solution. For the words see base/tuned.hpp.
namespace bem_contact {

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
/// Elements. A plan that follows a former solution has so many more on each side: with one, a sixth of the
/// contacts of data/scenes/cases_fem.toml did not fit, and were solved twice.
BEM_CONTACT_TUNED(int, cropped_margin, 2);
/// Elements. The same where the potential contact moved by less than an element, as in steps of a vehicle.
BEM_CONTACT_TUNED(int, cropped_margin_of_steps, 1);
/// GB. Largest influence numbers, and largest history, that are kept in memory.
BEM_CONTACT_TUNED(double, largest_memory, 8.0);
/// 1. Memory of a whole solution over that of its table of influence numbers, where they depend on both rows:
/// numbers of either body, of the pair, and spectra. 2.3 was measured of influence files.
BEM_CONTACT_TUNED(double, memory_by_rows, 4.0);
/// 1. The same of half-spaces, whose table is small: 144 bytes an element. 1.2 to 2 kB an element were
/// measured in all, the most of unlike materials.
BEM_CONTACT_TUNED(double, memory_by_distance, 16.0);

// Start from the case before.

/// 1. Two areas are the same contact if they overlap by this share of the smaller one.
BEM_CONTACT_TUNED(double, alike_overlap, 0.3);
/// mm. Least extent of an area: it may be one slice of the estimate.
BEM_CONTACT_TUNED(double, least_extent, 0.2);

// Warnings and stresses.

/// 1. Discretisation error above which the elements are said to be too large.
BEM_CONTACT_TUNED(double, poor_discretisation, 0.2);
/// 1. From so many steps of a history on, progress is reported.
BEM_CONTACT_TUNED(int, many_steps, 1000);

// Repeated results.

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
