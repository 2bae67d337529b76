#pragma once

#include "bem_contact/sequence/scene_result.hpp"

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace bem_contact::app {

/// The object that --json prints. Its members "quantities" and "patches" hold every number under the name
/// that it has in all outputs (sequence/quantities.hpp), "frame" their units. Lengths mm, forces N, moments N
/// mm, pressures MPa, angles rad. Totals are the forces on the rail in the track frame (patch: the frame of
/// the rows), Mz about the vertical axis through the reference point. "extrapolated": totals and approach
/// freed of the leading discretisation error (contact/problem.hpp, Discretisation); null where not estimated.
nlohmann::json to_json(const SceneResult& result);

/// The same for people.
std::string to_text(const SceneResult& result);

/// Where s, y, z and inclination of the reference point are; a line for people, with the side of a left
/// wheel.
std::string reference_text(const SceneResult& result);

} // namespace bem_contact::app
