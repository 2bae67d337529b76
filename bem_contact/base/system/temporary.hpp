#pragma once

#include <filesystem>
#include <system_error>

namespace bem_contact::system {

/// Makes a new folder that is its user's alone, among those of the system for temporary files.
std::filesystem::path new_temporary_folder(std::error_code& problem);

/// From now on a signal that ends the program removes the folder. `folder` itself stays where it is in
/// memory.
void remove_at_signals(const std::filesystem::path& folder);
void keep_at_signals(const std::filesystem::path& folder); ///< no longer

} // namespace bem_contact::system
