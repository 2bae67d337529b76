#pragma once

#include "bem_contact/influence/influence_function.hpp"
#include "bem_contact/inside/surface_tractions.hpp"

#include <span>

namespace bem_contact::inside {

/// What the rows bear on each station, `width` mm wide, [station][column]: forces are kept. Throws InputError
/// where a loaded row lies beside the strip.
SurfaceTractions on_stations(const SurfaceTractions& tractions, std::span<const Station> stations,
                             double width);

} // namespace bem_contact::inside
