#pragma once

#include "bem_contact/record/record.hpp"

#include <pybind11/pybind11.h>

namespace bem_contact {

/// Python's picture of a record: a group is a dict; a number a float (a count an int; None where it is not
/// known), its error beside it as NAME_error; a field a NumPy array; a table a list of dicts or a dict of
/// arrays (record::Layout); texts are str and lists of str. Arrays are copies.
pybind11::object as_object(const record::Content& content);
pybind11::dict as_dict(const record::Record& record);

/// A table as a dict of arrays, whatever its layout.
pybind11::dict columns_of(const record::Table& table);

} // namespace bem_contact
