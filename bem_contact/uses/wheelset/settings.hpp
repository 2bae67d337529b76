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
/// 1. Exponent of the approach in Hertz's law Fz ~ q^(3/2): the stiffness of a contact is this times Fz / q.
BEM_CONTACT_TUNED(double, hertz_exponent, 1.5);
/// mm. Approach under 100 kN, where no solution under a given load says it: the search begins there.
BEM_CONTACT_TUNED(double, usual_approach, 0.09);

} // namespace bem_contact
