#pragma once

#include <pybind11/pybind11.h>

namespace bem_contact {

/// Declares conicity(): what the command `bem_contact conicity` computes, as a dict of NumPy arrays.
void add_conicity(pybind11::module_& module);

} // namespace bem_contact
