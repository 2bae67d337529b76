#pragma once

#include "bem_contact/influence/expand.hpp"
#include "bem_contact/influence/expand_scope.hpp"

/// Private to this room.
namespace bem_contact {

/// The Fourier series of the kernel. Throws InputError where the structure cannot be removed.
InfluenceNumbers expand_kernel(const InfluenceFunction& function, const ExpandOptions& options,
                               StationRange range, const Scaling& scaling, const ChangeLines& change);

} // namespace bem_contact
