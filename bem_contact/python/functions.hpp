#pragma once

#include <pybind11/pybind11.h>

namespace bem_contact {

// Functions of the module. Each computes what the command of its name computes, and returns a dict.
void add_compare(pybind11::module_& module);
void add_conicity(pybind11::module_& module);
void add_creep_curves(pybind11::module_& module);
void add_table(pybind11::module_& module);
/// `wear` and `fatigue` of a Result, and how profiles wear under a load collective.
void add_wear_functions(pybind11::module_& module);
void add_wheelset(pybind11::module_& module);

} // namespace bem_contact
