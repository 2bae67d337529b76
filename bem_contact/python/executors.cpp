#include "bem_contact/python/executors.hpp"

#include "bem_contact/python/values.hpp"

#include <pybind11/functional.h>

namespace bem_contact {

namespace py = pybind11;

namespace {

void require_executor(const py::object& executor) {
  if (!py::hasattr(executor, "submit"))
    refuse_type("The executor cannot be used", "it has no method submit",
                "Give one of concurrent.futures, or another with its methods.");
}

} // namespace

py::list run_on(const py::object& executor, const char* kind, const py::list& tasks) {
  require_executor(executor);
  return py::module_::import("bem_contact.executors").attr("run_on")(executor, kind, tasks);
}

void run_each(const py::object& executor, const char* kind, const py::list& tasks,
              const std::function<void(std::size_t task, py::object result)>& take) {
  if (!executor.is_none())
    require_executor(executor);
  py::module_::import("bem_contact.executors")
      .attr("run_each")(executor, kind, tasks, py::cpp_function(take));
}

} // namespace bem_contact
