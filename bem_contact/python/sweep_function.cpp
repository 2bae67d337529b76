#include "bem_contact/python/executors.hpp"
#include "bem_contact/python/functions.hpp"
#include "bem_contact/python/stoppable.hpp"
#include "bem_contact/python/values.hpp"
#include "bem_contact/scene/sweep_check.hpp"
#include "bem_contact/task/tasks.hpp"
#include "bem_contact/uses/wheelset/solve_wheelset.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace bem_contact {

namespace {

namespace py = pybind11;
using namespace py::literals;

py::dict check(const py::object& scene, const py::object& changes, const py::object& model,
               const py::object& folder) {
  const SceneFile file = with_model(scene_file_of(scene, folder, changes_of(changes)), model_of(model));
  const SceneDescription found = stoppable([file](const std::atomic<bool>*) { return describe_scene(file); });
  return py::dict("lines"_a = found.lines, "warnings"_a = found.warnings.texts());
}

/// The values of a key, an array if they are numbers.
py::object values_of_key(const SweepFile& sweep, std::size_t axis) {
  const std::vector<SchemaValue>& values = sweep.axes[axis].values;
  std::vector<double> numbers;
  py::list texts;
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    const SchemaValue& value = values[sweep.indices(i)[axis]];
    if (const double* number = std::get_if<double>(&value))
      numbers.push_back(*number);
    if (const std::int64_t* number = std::get_if<std::int64_t>(&value))
      numbers.push_back(double(*number));
    const std::string* text = std::get_if<std::string>(&value);
    texts.append(text ? *text : to_text(value));
  }
  return numbers.size() == sweep.size() ? py::object(array_of(numbers)) : py::object(texts);
}

/// An array, or a list of names; nan and "" where there is no result.
py::object column_of(const SweepColumn& column, const std::vector<double>& values) {
  if (!is_model(column))
    return array_of(values);
  py::list names;
  for (const double value : values)
    names.append(std::isnan(value) ? std::string_view() : name_of(static_cast<Model>(value)));
  return names;
}

py::array_t<std::int64_t> whole(const std::vector<std::size_t>& numbers) {
  return py::array_t<std::int64_t>(py::cast(numbers));
}

/// The package's class, which is a dict.
py::object as_sweep(const py::dict& columns) {
  return py::module_::import("bem_contact").attr("Sweep")(columns);
}

/// One column of all, which is taken from its parts.
template <class Value, class Column> std::vector<Value> taken(AllSweepRows& rows, const Column& column) {
  std::vector<Value> out;
  for (auto& [first, part] : rows) {
    std::vector<Value>& some = column(part.numbers);
    out.insert(out.end(), some.begin(), some.end());
    std::vector<Value>().swap(some);
  }
  return out;
}

void add_cases(py::dict& out, const SweepFile& file, const AllSweepRows& rows) {
  py::list status, reason;
  std::vector<double> weights;
  for (const auto& [first, part] : rows)
    for (std::size_t i = 0; i < part.status.size(); ++i) {
      const auto why = part.reasons.find(first + i);
      status.append(name_of(part.status[i]));
      reason.append(why == part.reasons.end() ? std::string() : why->second);
      weights.push_back(file.weight(first + i));
    }
  out["status"] = status;
  out["reason"] = reason;
  out["weight"] = array_of(weights);
}

py::dict answer_of(const SweepFile& file, std::size_t swept, AllSweepRows rows) {
  py::dict out;
  for (std::size_t axis = 0; axis < swept; ++axis)
    out[file.axes[axis].key.c_str()] = values_of_key(file, axis);
  add_cases(out, file, rows);
  const SweepColumns& columns = columns_of(file);
  for (std::size_t k = 0; k < columns.cases.size(); ++k)
    out[columns.cases[k].name.c_str()] =
        column_of(columns.cases[k], taken<double>(
                                        rows, [k](SweepNumbers & n) -> auto& { return n.cases[k]; }));
  if (columns.patches.empty())
    return out;
  py::dict patches("case"_a = whole(taken<std::size_t>(rows, std::mem_fn(&SweepNumbers::patch_case))),
                   "patch"_a = whole(taken<std::size_t>(rows, std::mem_fn(&SweepNumbers::patch_rank))));
  for (std::size_t k = 0; k < columns.patches.size(); ++k)
    patches[columns.patches[k].name.c_str()] =
        column_of(columns.patches[k], taken<double>(
                                          rows, [k](SweepNumbers & n) -> auto& { return n.patches[k]; }));
  out["patches"] = patches;
  return out;
}

py::object sweep(const py::object& scene, const py::object& changes, const py::object& model,
                 const py::object& folder, const py::object& executor, const py::object& output,
                 const py::object& progress) {
  if (model.is_none() && py::isinstance<py::str>(changes)) // the model was the second argument
    return sweep(scene, py::none(), changes, folder, executor, output, progress);
  const bool shared = !executor.is_none() || !output.is_none() || !progress.is_none();
  const task::SharedSweep asked{scene_of(scene, folder), changes_of(changes), model_of(model),
                                output.is_none() ? std::filesystem::path()
                                                 : std::filesystem::absolute(path_of(output)),
                                shared ? task::most_portions : 1};
  const SweepFile file = asked.sweep();
  columns_of(file); // refuses derivatives that are no columns
  check_cases(file, file.all());
  with_model(file.first_scene(), asked.model); // refuses what is no model
  std::size_t done = 0;
  const auto say = [&](std::size_t more) {
    if (!progress.is_none())
      progress(done += more, file.size());
  };
  return as_sweep(answer_of(file, file.axes.size() - asked.changes.size(),
                            task::sweep_by(engine_of(executor), asked, say)));
}

} // namespace

void add_check_and_sweep(py::module_& module) {
  module.def(
      "check", &check, "scene"_a, "changes"_a = py::none(), "model"_a = py::none(), py::kw_only(),
      "folder"_a = py::none(),
      "What would be solved, and whether the influence files suffice; nothing is solved. `scene`, `changes`, "
      "`model`: as solve() takes them, or as wheelset() does. A dict: `lines`, the text that `bem_contact "
      "check` prints, and `warnings`. Raises InputError where solve() or wheelset() would before it solves.");
  module.def(
      "sweep", &sweep, "scene"_a, "changes"_a = py::none(), "model"_a = py::none(), py::kw_only(),
      "folder"_a = py::none(), "executor"_a = py::none(), "output"_a = py::none(), "progress"_a = py::none(),
      "Solves a scene for the lists of its table [sweep], as `bem_contact sweep` does. "
      "`scene`, `changes`, `model`: as solve() takes them. A dict of columns, one entry for each case: the "
      "keys swept "
      "over, under their names (\"position.lateral\"; an array, or a list of texts), `status` (certified, "
      "not "
      "certified or refused), `reason` (what is wrong or doubtful, in words), `model`, `weight`, and the "
      "numbers of a Result under their names (\"pmax\", \"Fx\", \"Fx_error\" ...; nan where there is no "
      "result); `to_frame()` makes a DataFrame of pandas of them; `patches`: the same of all patches, with "
      "`case` (from 0) and `patch` (from 1, the largest force first). Of wheelsets, the numbers of "
      "wheelset(), and `patches` with `left` (1: of the left wheel). mm, N, MPa, rad. Raises "
      "InputError for a scene without [sweep] and a value that no scene has. `executor`: any of "
      "concurrent.futures, or with its methods, shares the cases; the numbers are the same. `output`: a "
      "folder; each task "
      "writes its cases to a file there, and after a stop, or where a worker was killed, the same call "
      "solves "
      "what is missing (`bem_contact sweep SCENE --join FOLDER` reads these files, too, if there are no "
      "changes). `progress`: called as progress(cases that are done, all) after each task.");
}

} // namespace bem_contact
