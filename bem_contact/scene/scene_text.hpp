#pragma once

#include <concepts>
#include <filesystem>
#include <string>
#include <utility>

namespace bem_contact {

/// A scene before it is read. All that reads one takes this value, so it knows where the paths start.
struct SceneText {
  std::string toml;             ///< the text
  std::string source;           ///< its name, for messages
  std::filesystem::path folder; ///< where relative paths start; "": in the working directory

  SceneText(std::convertible_to<std::string> auto text, std::string name = "text",
            std::filesystem::path start = {})
      : toml(std::move(text)), source(std::move(name)), folder(std::move(start)) {} ///< a text alone will do
};

/// A scene file, whose paths start in its own folder. It is read once, so it may be a pipe. Throws
/// InputError.
SceneText read_scene_text(const std::filesystem::path& file);

} // namespace bem_contact
