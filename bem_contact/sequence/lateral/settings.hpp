#pragma once

#include "bem_contact/base/tuned.hpp"

/// Tuned numbers of sequence/lateral. For the words see base/tuned.hpp.
namespace bem_contact {

// Lateral displacement for a lateral force.

/// mm. The search looks this far to either side of position.lateral: farther than a wheelset can move between
/// its flanges (about 7 mm to either side), so that it sees tread and flange.
BEM_CONTACT_TUNED(double, lateral_reach, 12.0);
/// mm. Distance of the displacements that are tried first: a tread's force bends little over it.
BEM_CONTACT_TUNED(double, first_lateral_samples, 2.0);
/// mm. No displacements nearer to each other are tried: a flange takes up its force within about this.
BEM_CONTACT_TUNED(double, lateral_step, 0.5);
/// 1. Forces that differ by less than this, over the resultant of Fy and Fz, count as alike where a tread is
/// sampled: rough solutions of S1002 on 60E1 are uneven by .0005.
BEM_CONTACT_TUNED(double, even_lateral_force, 1e-3);
/// mm. Precision of the displacement that rough solutions give to begin from, and of the other displacements
/// that a result names.
BEM_CONTACT_TUNED(double, lateral_root_width, 1e-4);
BEM_CONTACT_TUNED(double, other_lateral_width, 0.02);
/// mm. An extremum of the force is known to this: it changes by its square there.
BEM_CONTACT_TUNED(double, lateral_extremum_width, 0.05);
/// 1. How often the curve is refined at its extremes before a force that it does not reach is refused: the
/// first samples are 2 mm apart, and each round comes nearer. Chosen.
BEM_CONTACT_TUNED(int, extremum_rounds, 3);
/// mm. On a tread the force is uneven from element to element, over some tenths of a millimetre. If it is
/// almost the wanted one at position.lateral, the search tries this distance to either side, then doubles it.
BEM_CONTACT_TUNED(double, first_look_around, 0.1);
/// 1. Two solutions give a slope if their forces differ by this, over the resultant.
BEM_CONTACT_TUNED(double, telling_lateral_force, 1e-4);
/// mm. A larger stated error of the lateral displacement gives a warning: the force then hardly determines
/// it. A rail's gauge is measured to some tenths, and a flange takes up 20 kN within this.
BEM_CONTACT_TUNED(double, unsure_lateral, 0.05);
/// 1. Precision of a lateral force, over the resultant of Fy and Fz: what the certificate allows for
/// prescribed forces.
BEM_CONTACT_TUNED(double, lateral_tolerance, 1e-6);
/// 1. Where the model's lateral force has its extremum, one that falls short of the force asked for by no
/// more than this, over the resultant, counts as met: from element to element forces scatter by more.
BEM_CONTACT_TUNED(double, lateral_scatter, 1e-5);
/// 1. A secant step is lengthened by this, to bracket the force. Chosen.
BEM_CONTACT_TUNED(double, lateral_overshoot, 1.1);
BEM_CONTACT_TUNED(double, longest_lateral_step,
                  0.1); ///< mm. A flange's force changes by its size in a few of them.
BEM_CONTACT_TUNED(int, most_lateral_steps, 25);     ///< 1. Solutions until the force is bracketed. Chosen.
BEM_CONTACT_TUNED(int, most_lateral_calls, 40);     ///< 1. Solutions that narrow a bracket. Chosen.
BEM_CONTACT_TUNED(double, narrowest_lateral, 1e-9); ///< mm. A narrower bracket holds a jump of the force.

} // namespace bem_contact
