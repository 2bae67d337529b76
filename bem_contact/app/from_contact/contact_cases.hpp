#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace bem_contact::app {

/// A table beside a scene: the key that names it, and its lines.
struct SceneTableFile {
  std::string key; ///< "gap.table"
  std::string text;
};

/// A case of CONTACT as a scene, or several that are steps of one.
struct ContactCase {
  int first = 1, last = 1; ///< cases of the file, from 1
  int module = 0, line = 0;
  std::map<std::string, std::string> keys; ///< of the scene, as TOML writes their values
  std::vector<SceneTableFile> tables;
  std::vector<std::string> left_out; ///< what has no counterpart and is left out, in sentences
  std::vector<std::string> refused;  ///< why there is no scene: it would be another problem
};

/// Reads all cases. Throws InputError for what is no input file of CONTACT.
std::vector<ContactCase> read_contact_cases(const std::filesystem::path& file);

} // namespace bem_contact::app
