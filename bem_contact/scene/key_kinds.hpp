#pragma once

#include "bem_contact/scene/choices.hpp"

#include <string>
#include <vector>

/// Private to this room: the kinds of scenes that a key is for.
namespace bem_contact {

inline const std::vector<std::string> wheel_rail_alone{std::string(name_of(SceneKind::wheel_rail))};
inline const std::vector<std::string> patch_alone{std::string(name_of(SceneKind::patch))};

} // namespace bem_contact
