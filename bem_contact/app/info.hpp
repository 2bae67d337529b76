#pragma once

#include <filesystem>
#include <string>

namespace bem_contact::app {

/// An influence file or a result file in words. Throws InputError for a file that is neither.
std::string describe_file(const std::filesystem::path& file);

} // namespace bem_contact::app
