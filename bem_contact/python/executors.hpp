#pragma once

#include "bem_contact/task/engine.hpp"

#include <pybind11/pybind11.h>

#include <string>

namespace bem_contact {

/// Has an executor of Python (bem_contact/executors.py) answer portions of a task; None: this process, one
/// after the other. Throws TypeError for what is no executor; the engine, what a task raises and what a
/// signal handler of Python raises.
task::Engine engine_of(const pybind11::object& executor);

/// What executors call in the process or thread that they choose: a portion of the task of this name.
pybind11::bytes run_task(const std::string& name, const std::string& common, const std::string& portion);

} // namespace bem_contact
