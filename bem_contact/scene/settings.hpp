#pragma once

#include "bem_contact/base/tuned.hpp"

/// The tuned numbers of this room (base/tuned.hpp).
namespace bem_contact {

// Where linear elasticity ends.

/// 1. Share of the softer body's Young's modulus that no pressure may exceed: strains are tens of percent
/// there, and the theory is one of small strains. (Steel yields at a hundredth of that.)
BEM_CONTACT_TUNED(double, largest_pressure_share, 0.2);
/// mm. No approach of a wheel and a rail may be larger: a hundred times that at which steel yields.
BEM_CONTACT_TUNED(double, largest_approach, 1.0);

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
/// 1 (share of the force). The search ends here, far below what such an estimate is off by.
BEM_CONTACT_TUNED(double, approach_tolerance, 1e-10);
BEM_CONTACT_TUNED(int, approach_steps, 60); ///< 1. Bound of the steps of that search.

// Warnings.

/// 1. A friction coefficient above this is probably a mistake: wheels and rails stay below 0.8, dry and
/// sanded.
BEM_CONTACT_TUNED(double, highest_friction, 1.0);
/// N. A wheel load below this is probably in kN: an empty wagon has 20 kN on a wheel, a roller rig of 1/5
/// scale some 500 N.
BEM_CONTACT_TUNED(double, least_wheel_load, 300.0);
/// MPa. A Young's modulus above this is probably one in another unit: somewhat above diamond.
BEM_CONTACT_TUNED(double, stiffest_modulus, 1.3e6);
/// MPa. A Young's modulus below this is probably in GPa: below hard plastics, and 210 is steel.
BEM_CONTACT_TUNED(double, softest_modulus, 1000);
/// 1. A spin times the wheel's radius above this is probably in 1/m: a wheel that rolls on a vertical face of
/// its flange has 1.
BEM_CONTACT_TUNED(double, largest_spin, 10.0);
/// mm. The thinnest flange of a wheel in service (EN 15313): with it the wheelset moves farthest until the
/// other wheel's flange meets its rail.
BEM_CONTACT_TUNED(double, thinnest_flange, 22.0);
/// mm. A wheel radius above this is probably a diameter: the largest of railways in service is 625 mm.
BEM_CONTACT_TUNED(double, largest_wheel_radius, 750.0);
/// 1. A velocity above this share of the speed, or a rolling radius that differs from the wheel's by more, is
/// probably in another unit.
BEM_CONTACT_TUNED(double, largest_motion_share, 0.3);
/// mm/s. Where the speed sets slip velocities or temperatures, one below this is probably in m/s or km/h:
/// half of walking pace, and slower than the theory of flash temperatures is for.
BEM_CONTACT_TUNED(double, least_speed, 700.0);
/// mm. Contact this near to the height of a flange's tip is contact on the tip.
BEM_CONTACT_TUNED(double, flange_tip_depth, 2.0);

// Pictures.

/// mm. How much of both profiles a picture shows finely on either side of the rows.
BEM_CONTACT_TUNED(double, outline_margin, 12.0);
/// mm. Of the points that it shows of the rest: a fillet of 10 mm still looks round.
BEM_CONTACT_TUNED(double, outline_spacing, 1.0);

/// mm. The approach of a plane-strain contact is relative to a point this far away; on a curved strip to one
/// at the distance of its radius.
BEM_CONTACT_TUNED(double, plane_strain_distance, 100.0);

} // namespace bem_contact
