#pragma once

#include "bem_contact/base/temporary_folder.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

using bem_contact::TemporaryFolder;

inline std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}
