#include "bem_contact/base/error.hpp"
#include "bem_contact/base/stopped.hpp"
#include "bem_contact/python/functions.hpp"
#include "bem_contact/python/stoppable.hpp"
#include "bem_contact/python/values.hpp"
#include "bem_contact/scene/sweep_file.hpp"
#include "bem_contact/sequence/quantities.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "bem_contact/sequence/uncertified.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace bem_contact {

namespace {

namespace py = pybind11;
using namespace py::literals;

py::dict check(const py::object& scene, const py::object& changes, const py::object& model,
               const py::object& folder) {
  const SceneFile file = with_model(scene_file_of(scene, folder, changes_of(changes)), model_of(model));
  const SceneDescription found =
      stoppable([file](const std::atomic<bool>*) { return Sequence().check(file); });
  return py::dict("lines"_a = found.lines, "warnings"_a = found.warnings);
}

/// What is kept of one case. Numbers are empty where there is no result.
struct Case {
  std::string status, reason, model;
  std::vector<double> numbers;
  std::vector<std::vector<double>> patches;
};

Case case_of(const SceneResult& r) {
  Case out{.status = certified(r) ? "certified" : "not certified",
           .reason = why_uncertified(r),
           .model = std::string(name_of(r.model)),
           .numbers = values_of(quantities(), r),
           .patches = {}};
  for (const std::string& warning : r.warnings)
    out.reason += (out.reason.empty() ? "" : "; ") + warning;
  for (std::size_t i = 0; i < r.result.patches.size(); ++i)
    out.patches.push_back(values_of(patch_quantities(), r, i));
  return out;
}

Case solved(Sequence& sequence, const SceneFile& scene, const std::atomic<bool>* stop) {
  try {
    return case_of(sequence.solve(scene, stop));
  } catch (const Stopped&) {
    throw;
  } catch (const ConvergenceError& error) {
    return {.status = "not certified", .reason = error.what(), .model = "", .numbers = {}, .patches = {}};
  } catch (const InputError& error) {
    return {.status = "refused", .reason = error.what(), .model = "", .numbers = {}, .patches = {}};
  }
}

/// The values of a key, an array if they are numbers.
py::object column_of(const SweepFile& sweep, std::size_t axis) {
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

/// One array for each name of a table, of rows that are as long; nan where a row is empty.
template <class Table> void add_columns(py::dict& out, const Table& table, const auto& rows) {
  std::size_t k = 0;
  with_errors(table, [&](const std::string& name, const QuantityUnit&, auto, const char*) {
    std::vector<double> column;
    for (const std::vector<double>& row : rows)
      column.push_back(row.empty() ? std::numeric_limits<double>::quiet_NaN() : row[k]);
    out[name.c_str()] = array_of(column);
    ++k;
  });
}

py::dict patches_of(const std::vector<Case>& cases) {
  std::vector<double> of_case, number;
  std::vector<std::vector<double>> rows;
  for (std::size_t i = 0; i < cases.size(); ++i)
    for (std::size_t k = 0; k < cases[i].patches.size(); ++k) {
      of_case.push_back(double(i));
      number.push_back(double(k + 1));
      rows.push_back(cases[i].patches[k]);
    }
  py::dict out("case"_a = py::array_t<double>(array_of(of_case)).attr("astype")("int"),
               "patch"_a = py::array_t<double>(array_of(number)).attr("astype")("int"));
  add_columns(out, patch_quantities(), rows);
  return out;
}

/// Reads every case first, so that wrong input is found before anything is solved.
std::vector<SceneFile> scenes_of(const SweepFile& sweep, const std::string& model) {
  std::vector<SceneFile> scenes;
  for (std::size_t i = 0; i < sweep.size(); ++i)
    scenes.push_back(with_model(sweep.scene(i), model));
  if (scenes.front().wheelset.force)
    throw InputError("bem_contact.sweep does not solve wheelsets", "the scene has wheelset.force",
                     "Call the command: python3 -m bem_contact sweep SCENE.toml -o S.h5.");
  return scenes;
}

py::dict sweep(const py::object& scene, const py::object& model, const py::object& folder) {
  const SweepFile file = parse_sweep_file(scene_of(scene, folder));
  const std::vector<Case> cases =
      stoppable([scenes = scenes_of(file, model_of(model))](const std::atomic<bool>* stop) {
        Sequence sequence({.displacements = false});
        std::vector<Case> out;
        for (const SceneFile& one : scenes)
          out.push_back(solved(sequence, one, stop));
        return out;
      });
  py::dict out;
  for (std::size_t axis = 0; axis < file.axes.size(); ++axis)
    out[file.axes[axis].key.c_str()] = column_of(file, axis);
  py::list status, reason, models;
  std::vector<double> weights;
  std::vector<std::vector<double>> rows;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    status.append(cases[i].status);
    reason.append(cases[i].reason);
    models.append(cases[i].model);
    weights.push_back(file.weight(i));
    rows.push_back(cases[i].numbers);
  }
  out["status"] = status;
  out["reason"] = reason;
  out["model"] = models;
  out["weight"] = array_of(weights);
  add_columns(out, quantities(), rows);
  out["patches"] = patches_of(cases);
  return out;
}

} // namespace

void add_check_and_sweep(py::module_& module) {
  module.def(
      "check", &check, "scene"_a, "changes"_a = py::none(), "model"_a = py::none(), py::kw_only(),
      "folder"_a = py::none(),
      "What would be solved, and whether the influence files suffice; nothing is solved. `scene`, `changes`, "
      "`model`: as solve() takes them. A dict: `lines`, the text that `bem_contact check` prints, and "
      "`warnings`. Raises InputError where solve() would before it solves.");
  module.def(
      "sweep", &sweep, "scene"_a, "model"_a = py::none(), py::kw_only(), "folder"_a = py::none(),
      "Solves a scene for the lists of its table [sweep], one case after the other, each from the one "
      "before. "
      "`scene`, `model`: as solve() takes them. A dict of columns, one entry for each case: the keys swept "
      "over, under their names (\"position.lateral\"; an array, or a list of texts), `status` (certified, "
      "not "
      "certified or refused), `reason` (what is wrong or doubtful, in words), `model`, `weight`, and the "
      "numbers of a Result under their names (\"pmax\", \"Fx\", \"Fx_error\" ...; nan where there is no "
      "result); `patches`: the same of all patches, with `case` (from 0) and `patch` (from 1, the largest "
      "force first). mm, N, MPa, rad. Raises InputError for a scene without [sweep], a value that no scene "
      "has, and wheelsets. `bem_contact sweep` solves the same with several processes, keeps fields, and "
      "goes "
      "on after it was stopped.");
}

} // namespace bem_contact
