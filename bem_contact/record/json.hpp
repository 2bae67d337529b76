#pragma once

#include "bem_contact/record/record.hpp"

#include <functional>
#include <string>
#include <string_view>

namespace bem_contact::record {

/// For programs: each number once, under its path; its error beside it as NAME_error; nan and what an answer
/// does not have are null. A table is a list of rows or an object of columns (Layout), a field of several
/// dimensions a list of lists. At the end "units" has the unit of each name; a name with several units is
/// there with its path. An answer begins with what was found (found.hpp): "found" and "next".
std::string to_json(const Record& record);

/// For the page of the room report, in one line: a group is an object, and its short texts and its yes or no
/// (1 or 0) are in "attributes"; a number, a column and a field are {unit, description, shape, values}, with
/// "errors" where they have some; a text is {text, description}. `left_out(path)`: what no figure draws.
std::string to_described_json(const Record& record, const std::function<bool(std::string_view)>& left_out);

} // namespace bem_contact::record
