#pragma once

#include "bem_contact/app/command.hpp"

#include <filesystem>
#include <string>

namespace bem_contact::app {

/// `bem_contact info FILE`.
Command add_info(CLI::App& program);

/// An influence file, a result file, a sweep or plain influence numbers in words. Throws InputError for any
/// other file.
std::string describe_file(const std::filesystem::path& file);

} // namespace bem_contact::app
