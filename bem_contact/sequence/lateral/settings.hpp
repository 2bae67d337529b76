#pragma once

#include "bem_contact/base/tuned.hpp"

/// The tuned numbers of this room (base/tuned.hpp).
namespace bem_contact::lateral {

/// mm. The search looks this far to either side of position.lateral: farther than a wheelset can move between
/// its flanges (about 7 mm to either side), so that it sees tread and flange.
BEM_CONTACT_TUNED(double, reach, 12.0);
/// mm. Distance of the displacements at which rough solutions show which branches there are: a tread's force
/// bends little over it.
BEM_CONTACT_TUNED(double, spacing, 2.0);
/// 1. Where a rough solution misses the force by no more than this, over the resultant of Fy and Fz, the
/// model itself is asked: rough forces differ from the model's by some per cent.
BEM_CONTACT_TUNED(double, near, 0.05);
/// 1. Forces that differ by less than this, over the resultant, count as alike where places are told by them:
/// rough solutions of S1002 on 60E1 are uneven by 0.0005.
BEM_CONTACT_TUNED(double, uneven, 1e-3);
/// mm. A larger stated error of the lateral displacement gives a warning: the force then hardly determines
/// it. A rail's gauge is measured to some tenths, and a flange takes up 20 kN within this. Steps of a search
/// begin with it.
BEM_CONTACT_TUNED(double, unsure, 0.05);

} // namespace bem_contact::lateral
