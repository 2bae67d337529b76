#pragma once

#include "bem_contact/base/tuned.hpp"

/// The tuned numbers of this room (base/tuned.hpp).
namespace bem_contact::fatigue {

/// 1. Points along x and along s of a patch at which the search for the largest stress begins. Stresses below
/// the surface are smoother than the tractions; twice as many found the same peaks in the tests.
BEM_CONTACT_TUNED(int, search_points, 9);
/// 1. Depths at each of these points, between the least depth and the patch's smaller side.
BEM_CONTACT_TUNED(int, search_depths, 10);
/// 1 (element's smaller side). Nothing is searched nearer to the surface: there the stress is that of the
/// steps between elements.
BEM_CONTACT_TUNED(double, least_depth, 1.0);
/// 1 (element's smaller side). The search ends when its steps are smaller.
BEM_CONTACT_TUNED(double, last_step, 0.02);
/// 1. Bound of its steps.
BEM_CONTACT_TUNED(int, most_search_steps, 200);

/// 1 (half width of a long contact). Where limit_below() looks for the largest shear: it lies between the
/// edges, and at most 0.5 deep.
BEM_CONTACT_TUNED(double, shakedown_extent, 1.5);
/// 1. Step of that search: with a tenth of it limits fall by less than 1e-4 of themselves.
BEM_CONTACT_TUNED(double, shakedown_step, 0.01);

} // namespace bem_contact::fatigue
