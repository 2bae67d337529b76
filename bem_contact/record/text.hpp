#pragma once

#include "bem_contact/record/record.hpp"

#include <string>

namespace bem_contact::record {

/// Everything that a record holds, for people: short texts and yes or no, then each number with its error and
/// what it means; of a table and a field the shape.
std::string to_text(const Record& record);

} // namespace bem_contact::record
