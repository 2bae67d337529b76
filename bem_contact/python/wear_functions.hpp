#pragma once

#include <pybind11/pybind11.h>

namespace bem_contact {

/// Adds `wear` and `fatigue`: what follows from a Result, and how profiles wear under a load collective.
void add_wear_functions(pybind11::module_& module);

} // namespace bem_contact
