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

} // namespace bem_contact::fatigue
