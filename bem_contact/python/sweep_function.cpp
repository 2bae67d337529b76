#include "bem_contact/base/error.hpp"
#include "bem_contact/python/executors.hpp"
#include "bem_contact/python/functions.hpp"
#include "bem_contact/python/stoppable.hpp"
#include "bem_contact/python/values.hpp"
#include "bem_contact/sequence/shared_files.hpp"
#include "bem_contact/uses/sweep/sweep_columns.hpp"
#include "bem_contact/uses/wheelset/solve_wheelset.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
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
  return py::dict("lines"_a = found.lines, "warnings"_a = found.warnings);
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

void add_columns(py::dict& out, const std::vector<SweepColumn>& columns,
                 const std::vector<std::vector<double>>& values) {
  for (std::size_t k = 0; k < columns.size(); ++k)
    out[columns[k].name.c_str()] = column_of(columns[k], values[k]);
}

py::array_t<std::int64_t> whole(const std::vector<std::size_t>& numbers) {
  return py::array_t<std::int64_t>(py::cast(numbers));
}

/// Gives every case of the sweep a key's value.
void change_all(SweepFile& sweep, const SceneChange& change) {
  if (std::ranges::count(sweep.axes, change.key, &SweepFile::Axis::key) > 0)
    throw InputError("The change of " + change.key + " cannot be made",
                     "the sweep gives it a value in each case", "Leave it out, or take it out of [sweep].");
  sweep.axes.push_back({change.key, {change.value}});
}

/// The package's class, which is a dict.
py::object as_sweep(const py::dict& columns) {
  return py::module_::import("bem_contact").attr("Sweep")(columns);
}

/// The cases of a scene, with changes of all of them.
SweepFile sweep_of(SceneText scene, const py::object& changes) {
  SweepFile file = parse_sweep_file(std::move(scene));
  for (const SceneChange& change : changes_of(changes))
    change_all(file, change);
  return file;
}

std::vector<SweepCase> solve_range(const SweepFile& sweep, CaseRange cases, const std::string& model) {
  return stoppable([=](const std::atomic<bool>* stop) {
    std::vector<SweepCase> out;
    solve_cases(sweep, cases, {.model = model, .stop = stop}, shared_files(), [&](SweepCase one) {
      out.push_back(std::move(one));
      return true;
    });
    return out;
  });
}

/// In a process or thread of an executor: the cases of a range as tuples, which can be pickled.
py::list solve_sweep_part(const py::tuple& scene, const py::object& changes, const std::string& model,
                          std::size_t first, std::size_t last) {
  py::list out;
  for (const SweepCase& one : solve_range(sweep_of(scene_text_of(scene), changes), {first, last}, model))
    out.append(py::make_tuple(one.index, static_cast<int>(one.status), one.reason, one.seconds,
                              one.cpu_seconds, one.summary, one.patches));
  return out;
}

/// By solve_sweep_part(), in tasks of whole chunks, so that what is found is what one process finds.
std::vector<SweepCase> solve_sweep_with(const py::object& executor, const SweepFile& sweep,
                                        const py::object& changes, const std::string& model) {
  constexpr std::size_t most_tasks = 1000; // each reads its files again
  const std::size_t chunk = cut_of(sweep, model, *shared_files()).chunk,
                    chunks = (sweep.size() + chunk - 1) / chunk,
                    size = chunk * ((chunks + most_tasks - 1) / most_tasks);
  py::list tasks;
  for (std::size_t first = 0; first < sweep.size(); first += size)
    tasks.append(
        py::make_tuple(tuple_of(sweep.text), changes, model, first, std::min(sweep.size(), first + size)));
  std::vector<SweepCase> out;
  for (const py::handle part : run_on(executor, "sweep", tasks))
    for (const py::handle item : part) {
      const auto one = py::reinterpret_borrow<py::tuple>(item);
      out.push_back({one[0].cast<std::size_t>(), static_cast<CaseStatus>(one[1].cast<int>()),
                     one[2].cast<std::string>(), one[3].cast<double>(), one[4].cast<double>(),
                     one[5].cast<std::vector<double>>(), one[6].cast<std::vector<std::vector<double>>>()});
    }
  return out;
}

py::object sweep(const py::object& scene, const py::object& changes, const py::object& model,
                 const py::object& folder, const py::object& executor) {
  if (model.is_none() && py::isinstance<py::str>(changes)) // the model was the second argument
    return sweep(scene, py::none(), changes, folder, executor);
  SweepFile file = parse_sweep_file(scene_of(scene, folder));
  const std::size_t swept = file.axes.size();
  file = sweep_of(file.text, changes);
  const std::string name = model_of(model);
  check_values(file);
  with_model(file.scene(0), name); // refuses what is no model
  const std::vector<SweepCase> cases = executor.is_none() ? solve_range(file, file.all(), name)
                                                          : solve_sweep_with(executor, file, changes, name);
  py::dict out;
  for (std::size_t axis = 0; axis < swept; ++axis)
    out[file.axes[axis].key.c_str()] = values_of_key(file, axis);
  py::list status, reason;
  std::vector<double> weights;
  for (const SweepCase& one : cases) {
    status.append(name_of(one.status));
    reason.append(one.reason);
    weights.push_back(file.weight(one.index));
  }
  out["status"] = status;
  out["reason"] = reason;
  out["weight"] = array_of(weights);
  const SweepColumns& columns = columns_of(file);
  const SweepNumbers numbers = numbers_of(cases, columns);
  add_columns(out, columns.cases, numbers.cases);
  if (columns.patches.empty())
    return as_sweep(out);
  py::dict patches("case"_a = whole(numbers.patch_case), "patch"_a = whole(numbers.patch_rank));
  add_columns(patches, columns.patches, numbers.patches);
  out["patches"] = patches;
  return as_sweep(out);
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
      "folder"_a = py::none(), "executor"_a = py::none(),
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
      "concurrent.futures, or with its methods, shares the cases; the numbers are the same. The program "
      "keeps fields, and goes on after it was stopped.");
  module.def("_sweep_part", &solve_sweep_part, "scene"_a, "changes"_a, "model"_a, "first"_a, "last"_a);
}

} // namespace bem_contact
