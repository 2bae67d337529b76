#pragma once

#include "bem_contact/base/tuned.hpp"

/// The tuned numbers of this room (base/tuned.hpp).
namespace bem_contact {

/// 1. The wheelset stands if no residual is larger: sums of forces over the vertical force, moments over that
/// times half the distance of the contacts (the torque: times the wheel's radius). The certificate allows as
/// much for a prescribed force.
BEM_CONTACT_TUNED(double, equilibrium_tolerance, 1e-6);
/// 1. The same for the sum of the lateral forces. At each displacement the rest is balanced ten times as well
/// as equilibrium_tolerance, and on a flange the lateral force is some three times the vertical one.
BEM_CONTACT_TUNED(double, lateral_balance, 1e-6);
/// 1. Most steps to the equilibrium at one lateral displacement: 3 to 5 are usual. A bound.
BEM_CONTACT_TUNED(int, equilibrium_steps, 40);
/// 1. A step that does not lessen the residual is halved so often at most.
BEM_CONTACT_TUNED(int, step_halvings, 6);
/// 1. A step leaves each wheel at least this share of its approach, so that no wheel is lifted by accident,
BEM_CONTACT_TUNED(double, least_approach_share, 0.3);
/// 1. and gives it at most so many times of it: forces then grow fivefold.
BEM_CONTACT_TUNED(double, most_approach_share, 3.0);
/// 1. A wheel that bears less than this share of the vertical force, and still too much, lifts.
BEM_CONTACT_TUNED(double, lifted_share, 1e-4);
/// 1. A wheel of whose elements in contact fewer adhere slides: near full slip some stay in adhesion about
/// the spin's pole. Chosen.
BEM_CONTACT_TUNED(double, sliding_adhesion, 0.05);
/// 1. Step of differences, over the smaller approach: forces then change by some percent.
BEM_CONTACT_TUNED(double, difference_share, 0.02);
/// 1. Exponent of the approach in Hertz's law Fz ~ q^(3/2): the stiffness of a contact is this times Fz / q.
BEM_CONTACT_TUNED(double, hertz_exponent, 1.5);
/// mm. Approach under 100 kN, where no solution under a given load says it: the search begins there.
BEM_CONTACT_TUNED(double, usual_approach, 0.09);
/// 1. Kalker's C11 of a circle of steel (4.2): the slope of the longitudinal force at small creepage.
BEM_CONTACT_TUNED(double, kalker_c11, 4.2);
/// 1. Least share of that slope that is left when friction is used up: of the theory of Vermeulen and
/// Johnson, whose slope vanishes there, and a search could go anywhere.
BEM_CONTACT_TUNED(double, least_creep_slope, 0.03);
/// 1. Creepage that counts in steps like an approach of 1 mm: both then change forces by about their own
/// size.
BEM_CONTACT_TUNED(double, creepage_scale, 0.05);
/// 1. Most that the rolling radius changes in one step, as a creepage: more lies beyond full slip.
BEM_CONTACT_TUNED(double, largest_creepage_step, 3e-3);
/// mm. Heights of both wheels on their rails, before anything is solved, agree within this.
BEM_CONTACT_TUNED(double, stand_tolerance, 1e-4);

/// mm. First step of the lateral search, and factor by which the next one is longer as long as the force is
/// not passed.
BEM_CONTACT_TUNED(double, first_lateral_step, 0.25);
BEM_CONTACT_TUNED(double, lateral_step_growth, 1.4); ///< 1. As above.
/// mm. Longest step: a flange takes up its force within a few tenths, and holds it for some millimetres.
BEM_CONTACT_TUNED(double, largest_lateral_step, 1.0);
/// mm. Shortest step towards displacements at which the wheelset does not stand: two flanges in their gauge
/// corners have some hundredths.
BEM_CONTACT_TUNED(double, least_lateral_step, 2e-3);
/// mm. The search ends so far from position.lateral: a wheelset has some 7 mm to either side.
BEM_CONTACT_TUNED(double, lateral_search_reach, 14.0);
/// 1. Elements of the rough half-space solutions are so many times as long and wide.
BEM_CONTACT_TUNED(double, rough_elements, 2.0);
/// 1. Residuals of rough solutions: on the tread the lateral force changes by some 1e-3 of the vertical one
/// in rough_lateral_width.
BEM_CONTACT_TUNED(double, rough_tolerance, 1e-5);
/// 1. An interval that holds such a displacement gets narrower by at least this share of it.
BEM_CONTACT_TUNED(double, least_narrowing, 0.15);
/// mm. Rough displacements are found within this.
BEM_CONTACT_TUNED(double, rough_lateral_width, 0.03);

/// 1. Elements are chosen for so much of the accuracy asked for, because they are chosen near the
/// equilibrium, not at it: a second round costs more than smaller elements.
BEM_CONTACT_TUNED(double, accuracy_reserve, 0.8);
/// 1. Elements of both wheels count as alike if those of one are no more than so many times as long and wide:
/// the smaller ones for both then cost about twice the elements at most.
BEM_CONTACT_TUNED(double, alike_elements, 1.5);
/// 1. Most rounds in which elements are chosen again for the accuracy asked for.
BEM_CONTACT_TUNED(int, most_element_rounds, 3);

} // namespace bem_contact
