#pragma once

#include "bem_contact/base/tuned.hpp"

/// The tuned numbers of this room (base/tuned.hpp).
namespace bem_contact {

// Where linear elasticity ends.

/// mm. No approach of a wheel and a rail may be larger: a hundred times that at which steel yields.
BEM_CONTACT_TUNED(double, largest_approach, 1.0);

// Where rounding begins.

/// N. No force of a wheel on a rail may be smaller: the bodies would approach by 1e-9 mm, and the coordinates
/// of profiles are rounded to 1e-13 mm.
BEM_CONTACT_TUNED(double, least_force, 1e-6);
BEM_CONTACT_TUNED(double, least_approach, 1e-9); ///< mm. As above.

// Where creepages refer to.

/// 1. Share of the approach within which two bodies that overlap without deforming touch when they deform
/// (Kik and Piotrowski 1996).
BEM_CONTACT_TUNED(double, penetration_share, 0.55);
/// mm. Depth of the elastic foundation whose pressure is depth E* / this. A Hertzian contact with a pressure
/// of some 100 to 1000 MPa at an approach of 0.05 mm has about that.
BEM_CONTACT_TUNED(double, foundation_depth, 10.0);
/// mm. Where the search for an approach starts to double, and where it gives up.
BEM_CONTACT_TUNED(double, first_approach, 1e-4);
BEM_CONTACT_TUNED(double, last_approach, 10.0); ///< mm. As above: ten times the largest one allowed.
BEM_CONTACT_RELATION(first_approach < largest_approach && largest_approach < last_approach);
/// 1 (share of the force). The search ends here, far below what such an estimate is off by.
BEM_CONTACT_TUNED(double, approach_tolerance, 1e-10);
BEM_CONTACT_TUNED(int, approach_steps, 60); ///< 1. Bound of the steps of that search.

// Warnings.

/// MPa. A Young's modulus below this is probably in GPa: below hard plastics, and 210 is steel.
BEM_CONTACT_TUNED(double, softest_modulus, 1000);
/// mm/s. Where the speed sets slip velocities or temperatures, one below this is probably in m/s or km/h:
/// half of walking pace, and slower than the theory of flash temperatures is for.
BEM_CONTACT_TUNED(double, least_speed, 700.0);

} // namespace bem_contact
