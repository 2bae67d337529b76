#pragma once

#include "bem_contact/sequence/scene_result.hpp"

#include <string>

namespace bem_contact::app {

/// A result for people; --json prints its record (sequence/result_record.hpp).
std::string to_text(const SceneResult& result);

/// Where s, y, z and inclination of the reference point are; a line for people, with the side of a left
/// wheel.
std::string reference_text(const SceneResult& result);

} // namespace bem_contact::app
