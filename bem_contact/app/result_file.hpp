#pragma once

#include "bem_contact/influence/h5_table.hpp"
#include "bem_contact/sequence/scene_result.hpp"

#include <span>
#include <string>

namespace bem_contact::app {

/// The attribute "format" of a result file.
inline constexpr const char* result_format = "bem_contact result 1";

/// A result file: coordinates of the grid at the top (x[mx], s, y, z, delta [ms], gap [ms][mx]), both
/// profiles near the contact, and one group per result ("halfspace", "fem") with fields [ms][mx]: p_x, p_s,
/// p_n, slip_x, slip_s, deformed_distance, state (0 exterior, 1 adhesion, 2 slip); the totals and the
/// certificate are attributes of the group. Every dataset has a unit. All results share one grid.
H5Table to_table(std::span<const SceneResult* const> results, const std::string& scene);

} // namespace bem_contact::app
