#pragma once

#include "bem_contact/base/conventions.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace bem_contact {

/// The points of a text in two columns "y z". Comment lines start with #, !, % or //; one line of column
/// names may come first. `source` names the file in messages. Throws InputError for any other line.
std::vector<Point2> plain_points(std::string_view text, const std::string& source);

} // namespace bem_contact
