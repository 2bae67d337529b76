#pragma once

#include <pybind11/pybind11.h>

namespace bem_contact {

/// Declares wheelset(): what the command `bem_contact wheelset` computes, as a dict.
void add_wheelset(pybind11::module_& module);

} // namespace bem_contact
