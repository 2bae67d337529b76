#pragma once

#include "bem_contact/inside/stresses_inside.hpp"

#include <cstdint>
#include <span>

namespace bem_contact::inside {

/// One load on a body, and what it does there.
struct LoadedInside {
  SurfaceTractions tractions;
  StressesInside stresses;
};

/// The tractions that a result (bem_contact solve -o) has on the body with this profile
/// (ProfileCurve::digest()), and the stresses of a half-space under them, at these points or below each
/// patch. Throws InputError if it is neither body of the result, or one of another material.
LoadedInside loaded_by(const record::Record& result, std::uint64_t profile_digest, double poisson,
                       std::span<const BelowSurface> own = {});

} // namespace bem_contact::inside
