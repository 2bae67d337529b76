#pragma once

#include <pybind11/pybind11.h>

namespace bem_contact {

/// Declares table(): what the command `bem_contact table` computes, as a dict of NumPy arrays.
void add_table(pybind11::module_& module);

} // namespace bem_contact
