#pragma once

#include "bem_contact/base/tuned.hpp"

/// The tuned numbers of this room (base/tuned.hpp).
namespace bem_contact::wear {

/// rad. Influence functions serve a worn profile while its surface has turned by less than this from the
/// shape they were computed for. 1 mm off S1002 on 60E1 turns it by 0.146; what keeping them so far costs was
/// measured (tools/BENCHMARKS.md, section 11).
BEM_CONTACT_TUNED(double, usual_kept_turn, 0.15);

} // namespace bem_contact::wear
