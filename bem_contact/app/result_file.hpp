#pragma once

#include "bem_contact/influence/h5_table.hpp"
#include "bem_contact/sequence/comparison.hpp"

#include <string>

namespace bem_contact::app {

/// The attribute "format" of a result file.
inline constexpr const char* result_format = "bem_contact result 1";

/// A result file: coordinates of the grid at the top (x[mx], s, y, z, delta [ms], gap [ms][mx]), both
/// profiles near the contact, and a group with the model's name ("fem") with fields [ms][mx]: p_x, p_s, p_n,
/// slip_x, slip_s, deformed_distance, state (0 exterior, 1 adhesion, 2 slip). Totals and certificate are
/// attributes of the group. Every dataset has a unit.
H5Table to_table(const SceneResult& result, const std::string& scene);

/// A file of a comparison: groups equal_forces/MODEL and equal_position/MODEL, each with coordinates,
/// profiles, fields and attributes as above. Each result has a grid of its own: at equal forces the wheels
/// stand at different places.
H5Table to_table(const Comparison& comparison, const std::string& scene);

} // namespace bem_contact::app
