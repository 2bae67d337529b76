#pragma once

#include <pybind11/pybind11.h>

namespace bem_contact {

// Functions of the module. Each computes what the command of its name computes, and returns a dict.
/// `check`, and `sweep` over a table [sweep].
void add_check_and_sweep(pybind11::module_& module);
/// `profile`: a profile file.
void add_profile(pybind11::module_& module);
/// `conicity` of a wheelset, and of many (a map).
void add_conicity(pybind11::module_& module);
/// compare, creep_curves, fit, wheelset.
void add_functions(pybind11::module_& module);
/// `shakedown` of a Result.
void add_shakedown(pybind11::module_& module);
/// `table`, and tables to look up in.
void add_table(pybind11::module_& module);
/// `wear` and `fatigue` of a Result, and how profiles wear under a load collective.
void add_wear_functions(pybind11::module_& module);

} // namespace bem_contact
