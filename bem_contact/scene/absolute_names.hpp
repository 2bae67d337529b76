#pragma once

#include "bem_contact/scene/scene_text.hpp"

#include <filesystem>
#include <string>

namespace bem_contact {

/// The text of a scene with names of files that hold from any folder. A text that names no file stays, as
/// does a text that is no TOML: whoever reads it says what is wrong. Comments go.
std::string with_absolute_names(const SceneText& scene);

/// A name that holds from any folder, if it names a file seen from this one; else the text as it is.
std::string absolute_name(const std::string& text, const std::filesystem::path& folder);

} // namespace bem_contact
