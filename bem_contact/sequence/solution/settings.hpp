#pragma once

#include "bem_contact/base/tuned.hpp"

/// Tuned numbers of sequence/solution. For the words see base/tuned.hpp.
namespace bem_contact {

// Grid.

BEM_CONTACT_TUNED(int, row_growth_share, 4);    ///< 1. In s by one over this: a quarter.
BEM_CONTACT_TUNED(int, column_growth_share, 8); ///< 1. In x by one over this: an eighth.
BEM_CONTACT_TUNED(int, fewest_more_rows, 4);    ///< 1. Rows by which a grid grows at least.
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
BEM_CONTACT_RELATION(cropped_margin_of_steps <= cropped_margin);

// Planes (grid.planar).

/// rad. A patch's plane is moved where it is inclined by more against the rail, times the patch's share of
/// the load: the force then turns by no more. Chosen: 0.2 % of the load.
BEM_CONTACT_TUNED(double, plane_turn_of_force, 0.002);
/// rad. A patch whose plane is inclined by more against the rail is refused: its force would turn by 2 %.
BEM_CONTACT_TUNED(double, largest_plane_turn, 0.02);
/// 1. Share of the load of a patch whose plane may have any inclination. Chosen.
BEM_CONTACT_TUNED(double, negligible_patch, 0.01);
/// 1. Planes are moved so often at most. Chosen: two or three moves are usual.
BEM_CONTACT_TUNED(int, most_plane_moves, 10);
BEM_CONTACT_RELATION(plane_turn_of_force <= largest_plane_turn);
/// Elements of the grid on which the pressure alone says where planes lie: it is as rough as leaves so many.
/// Chosen: a third of them in contact say where its centre is to a hundredth of its width.
BEM_CONTACT_TUNED(int, fewest_for_planes, 500);

// What linear kinematics leaves open (slide_errors.hpp).

/// 1. How far shear moves the surfaces past each other, over the approach of a patch and Fs/Fn: a Hertzian
/// contact that slips yields to shear (2 - nu)/(2 (1 - nu)) times as much as to pressure (Johnson 1985,
/// section 7.2), steel 1.21.
BEM_CONTACT_TUNED(double, shear_slide, 1.2);
/// 1. A trial whose lateral force is off by so many times the wanted difference, or by one over it, still
/// tells how numbers change with it. Chosen: nearer ones show the elements, farther ones another contact.
BEM_CONTACT_TUNED(double, farthest_trial, 20.0);

// Influence functions of sections (section_ends.hpp).

/// mm. Rows of a contact may lie so far beside the points that correspond on the section of an influence
/// file. Chosen: a body's compliance changes over lengths as its own, 20 mm and more.
BEM_CONTACT_TUNED(double, farthest_correspondence, 3.0);
/// 1. Over the length of a contact the largest pressure, the force or the approach may change by this share
/// from one section to the next. Chosen: half of it, what the middle is off from either end, is 5 %.
BEM_CONTACT_TUNED(double, largest_section_change, 0.1);

// Start from the case before.

/// 1. Two areas are the same contact if they overlap by this share of the smaller one.
BEM_CONTACT_TUNED(double, alike_overlap, 0.3);
/// mm. Least extent of an area: it may be one slice of the estimate.
BEM_CONTACT_TUNED(double, least_extent, 0.2);

} // namespace bem_contact
