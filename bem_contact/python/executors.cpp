#include "bem_contact/python/executors.hpp"

#include "bem_contact/python/stoppable.hpp"
#include "bem_contact/python/values.hpp"

#include <pybind11/functional.h>

namespace bem_contact {

namespace py = pybind11;

task::Engine engine_of(const py::object& executor) {
  if (!executor.is_none() && !py::hasattr(executor, "submit"))
    refuse_type("The executor cannot be used", "it has no method submit",
                "Give one of concurrent.futures, or another with its methods.");
  return [executor](const task::Portions& all) {
    py::list asked;
    for (const std::string& one : all.asked)
      asked.append(py::bytes(one));
    const auto take = [&all](std::size_t portion, const std::string& answer) { all.take(portion, answer); };
    py::module_::import("bem_contact.executors")
        .attr("run_each")(executor, all.task.name, py::bytes(all.common), asked, py::cpp_function(take));
  };
}

py::bytes run_task(const std::string& name, const std::string& common, const std::string& portion) {
  const task::Task& task = task::task_named(name);
  return stoppable([=, &task](const std::atomic<bool>* stop) { return task.run(common, portion, stop); });
}

} // namespace bem_contact
