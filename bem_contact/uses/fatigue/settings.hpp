#pragma once

#include "bem_contact/base/tuned.hpp"

/// The tuned numbers of this room (base/tuned.hpp).
namespace bem_contact::fatigue {

/// 1 (element's smaller side). Nothing is searched nearer to the surface: there the stress is that of the
/// steps between elements.
BEM_CONTACT_TUNED(double, least_depth, 1.0);
/// 1 (element's smaller side). The search ends when its steps are smaller.
BEM_CONTACT_TUNED(double, last_step, 0.02);

} // namespace bem_contact::fatigue
