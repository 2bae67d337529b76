#pragma once

#include <functional>

namespace bem_contact {

/// The roll at which both wheels of a wheelset ask for the same height of the axle, rad. `unequal`: how much
/// more the right wheel has to be lowered than the left one at a roll, mm, until each stands. It is asked for
/// the roll that is returned last of all. The search begins at `roll` and ends where `unequal` is within
/// `tolerance`, mm; `contact_distance`: nominal, from one rail to the other, mm.
double level_roll(const std::function<double(double)>& unequal, double roll, double contact_distance,
                  double tolerance);

} // namespace bem_contact
