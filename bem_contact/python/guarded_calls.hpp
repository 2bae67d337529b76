#pragma once

#include <pybind11/pybind11.h>

namespace bem_contact {

/// Guards all functions and classes of the module, those of its classes among them, against what pybind11
/// lets through:
/// - A daemon thread that is in a function of ours when Python ends, and asks for Python's lock, would be
///   unwound through frames of C++. end_all_solutions() waits for it; one that comes later stays where it is.
/// - `Class.__new__(Class)` makes an object without an inside. It raises TypeError, as copy.copy() of one.
void guard_module(pybind11::module_& module);

} // namespace bem_contact
