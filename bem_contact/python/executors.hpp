#pragma once

#include <pybind11/pybind11.h>

namespace bem_contact {

/// Has an executor (bem_contact/executors.py) do each of `tasks`: tuples of arguments of the function
/// `_KIND_part` of this module. Their results, in the order of the tasks. All of it can be pickled. Throws
/// what a task raises, TypeError for what is no executor, and what a signal handler of Python raises.
pybind11::list run_on(const pybind11::object& executor, const char* kind, const pybind11::list& tasks);

} // namespace bem_contact
