#pragma once

#include "bem_contact/explore/start.hpp"

#include <string>

namespace bem_contact::explore {

/// The page: HTML that needs no other file. What it shows first is in it. Throws InputError if this build has
/// no plotting library.
std::string explore_page(const Start& start);

} // namespace bem_contact::explore
