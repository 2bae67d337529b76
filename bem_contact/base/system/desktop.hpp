#pragma once

#include <filesystem>

namespace bem_contact::system {

/// Whether there may be one that shows pages.
bool has_desktop();
/// In the browser that the user has chosen. Where there is none nothing happens.
void show_page(const std::filesystem::path& page);

} // namespace bem_contact::system
