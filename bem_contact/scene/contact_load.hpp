#pragma once

#include "bem_contact/contact/problem.hpp"

namespace bem_contact {

/// What presses the bodies together.
struct ContactLoad {
  LoadKind kind = LoadKind::force;
  double force = 0;    ///< Fz, N (a patch: along z of its frame); kind == force
  double approach = 0; ///< mm; kind == approach
};

} // namespace bem_contact
