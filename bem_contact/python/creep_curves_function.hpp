#pragma once

#include <pybind11/pybind11.h>

namespace bem_contact {

/// Declares creep_curves(): what the command `bem_contact creep-curves` computes, as a dict of NumPy arrays.
void add_creep_curves(pybind11::module_& module);

} // namespace bem_contact
