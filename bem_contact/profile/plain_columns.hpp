#pragma once

#include "bem_contact/profile/measured_points.hpp"

#include <string>
#include <string_view>

namespace bem_contact {

/// The points of a text in two columns "y z". Comments begin with #, !, %, a quotation mark or (at the start
/// of a line) with //; one line of column names may come first. `source` names the file in messages. Throws
/// InputError for any other line.
MeasuredPoints plain_points(std::string_view text, const std::string& source);

} // namespace bem_contact
