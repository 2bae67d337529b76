#include "bem_contact/base/error.hpp"
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
#include <optional>
#include <string>
#include <string_view>
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

/// Chunk by chunk, as the program.
std::vector<SweepCase> solve_all(const SweepFile& sweep, const SweepOptions& options) {
  const auto files = shared_files();
  std::optional<SweepSolver> solver;
  std::vector<SweepCase> out;
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    if (i % chunk_size(sweep.size()) == 0)
      solver.emplace(files);
    out.push_back(solve_case(*solver, sweep, i, options));
  }
  return out;
}

/// Gives every case of the sweep a key's value.
void change_all(SweepFile& sweep, const SceneChange& change) {
  if (std::ranges::count(sweep.axes, change.key, &SweepFile::Axis::key) > 0)
    throw InputError("The change of " + change.key + " cannot be made",
                     "the sweep gives it a value in each case", "Leave it out, or take it out of [sweep].");
  sweep.axes.push_back({change.key, std::vector<SchemaValue>(sweep.zip ? sweep.size() : 1, change.value)});
}

/// The package's class, which is a dict.
py::object as_sweep(const py::dict& columns) {
  return py::module_::import("bem_contact").attr("Sweep")(columns);
}

py::object sweep(const py::object& scene, const py::object& changes, const py::object& model,
                 const py::object& folder) {
  if (model.is_none() && py::isinstance<py::str>(changes)) // the model was the second argument
    return sweep(scene, py::none(), changes, folder);
  SweepFile file = parse_sweep_file(scene_of(scene, folder));
  const std::size_t swept = file.axes.size();
  for (const SceneChange& change : changes_of(changes))
    change_all(file, change);
  const std::string name = model_of(model);
  check_values(file);
  with_model(file.scene(0), name); // refuses what is no model
  const std::vector<SweepCase> cases = stoppable(
      [file, name](const std::atomic<bool>* stop) { return solve_all(file, {.model = name, .stop = stop}); });
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
      "folder"_a = py::none(),
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
      "InputError for a scene without [sweep] and a value that no scene has. The program solves with several "
      "processes, keeps fields, and goes on after it was stopped.");
}

} // namespace bem_contact
