#pragma once

#include "bem_contact/record/record.hpp"

#include <string>

namespace bem_contact::app {

/// Prints an answer as JSON, or for people: what was found (record/found.hpp), and below it `text`, all else.
void print_answer(const record::Record& answer, bool json, const std::string& text);

} // namespace bem_contact::app
