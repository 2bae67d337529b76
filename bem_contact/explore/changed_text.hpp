#pragma once

#include "bem_contact/scene/scene_file.hpp"

#include <span>
#include <string>

namespace bem_contact::explore {

/// The text of a scene with other values, which stays as it was given in all else: comments, order, layout.
/// Where a value cannot be written into the text, the scene with every key instead. Throws InputError for
/// what is no scene.
std::string changed_text(const SceneText& given, std::span<const SceneChange> changes);

} // namespace bem_contact::explore
