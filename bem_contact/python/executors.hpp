#pragma once

#include <pybind11/pybind11.h>

#include <cstddef>
#include <functional>

namespace bem_contact {

/// Has an executor (bem_contact/executors.py) do each of `tasks`: tuples of arguments of the function
/// `_KIND_part` of this module. Their results, in the order of the tasks. All of it can be pickled. Throws
/// what a task raises, TypeError for what is no executor, and what a signal handler of Python raises.
pybind11::list run_on(const pybind11::object& executor, const char* kind, const pybind11::list& tasks);

/// The same for tasks with many results: `take` gets the number of each task and its result as soon as it is
/// there, in any order, and nobody else keeps it. None as executor: one after the other, here.
void run_each(const pybind11::object& executor, const char* kind, const pybind11::list& tasks,
              const std::function<void(std::size_t task, pybind11::object result)>& take);

} // namespace bem_contact
