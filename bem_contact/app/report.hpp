#pragma once

#include "bem_contact/sequence/scene_result.hpp"

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace bem_contact::app {

/// The object that --json prints. Lengths mm, forces N, moments N mm, pressures MPa, angles rad. Totals are
/// the forces on the rail in the track frame (patch: the frame of the rows), Mz about the vertical axis
/// through the reference point. "extrapolated": totals and approach freed of the leading discretisation error
/// (contact/problem.hpp, Discretisation); null where not estimated.
nlohmann::json to_json(const SceneResult& result);
/// {"halfspace": ..., "fem": ..., "difference": ...}, the differences as fem minus half-space over half-space
/// (null where half-space gives zero).
nlohmann::json to_json(const Comparison& comparison);

/// The same for people.
std::string to_text(const SceneResult& result);
std::string to_text(const Comparison& comparison);

} // namespace bem_contact::app
