#include "bem_contact/python/executors.hpp"

#include "bem_contact/python/values.hpp"

namespace bem_contact {

namespace py = pybind11;

py::list run_on(const py::object& executor, const char* kind, const py::list& tasks) {
  if (!py::hasattr(executor, "submit"))
    refuse_type("The executor cannot be used", "it has no method submit",
                "Give one of concurrent.futures, or another with its methods.");
  return py::module_::import("bem_contact.executors").attr("run_on")(executor, kind, tasks);
}

} // namespace bem_contact
