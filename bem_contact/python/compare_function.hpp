#pragma once

#include <pybind11/pybind11.h>

namespace bem_contact {

/// Declares compare(): what the command `bem_contact compare` computes, as a dict.
void add_compare(pybind11::module_& module);

} // namespace bem_contact
