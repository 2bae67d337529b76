#include "bem_contact/base/input_file.hpp"

#include "bem_contact/base/error.hpp"

#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <sstream>

namespace bem_contact {

std::string read_text_file(const std::string& file, std::string_view what) {
  if (std::filesystem::is_directory(file))
    throw InputError(fmt::format("{} '{}' cannot be read", what, file), "it is a folder", "Name a file.");
  std::ifstream in(file, std::ios::binary);
  if (!in)
    throw InputError(fmt::format("{} '{}' cannot be read", what, file),
                     std::filesystem::exists(file) ? "no permission" : "there is no such file",
                     "Check the path; relative paths start in the folder of the file that names them.");
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

} // namespace bem_contact
