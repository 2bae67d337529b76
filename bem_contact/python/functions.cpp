#include "bem_contact/python/functions.hpp"

#include "bem_contact/base/comma_separated.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/python/executors.hpp"
#include "bem_contact/python/record_object.hpp"
#include "bem_contact/python/result_object.hpp"
#include "bem_contact/python/stoppable.hpp"
#include "bem_contact/python/values.hpp"
#include "bem_contact/record/hdf5.hpp"
#include "bem_contact/scene/absolute_names.hpp"
#include "bem_contact/scene/csv_table.hpp"
#include "bem_contact/sequence/quantities.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "bem_contact/task/tasks.hpp"
#include "bem_contact/uses/curves/creep_record.hpp"
#include "bem_contact/uses/curves/measured_forces.hpp"
#include "bem_contact/uses/fit/fit_curve.hpp"
#include "bem_contact/uses/fit/fit_record.hpp"
#include "bem_contact/uses/wheelset/quantities.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace py = pybind11;

namespace bem_contact {

namespace {

using namespace py::literals;

std::vector<Model> models_of(const py::object& names) {
  if (names.is_none())
    return models_to_compare();
  if (py::isinstance<py::str>(names) || !py::isinstance<py::iterable>(names))
    refuse_type("The models cannot be used", std::string(py::str(py::type::of(names))) + " is no list",
                "Give a list of names, as [\"halfspace\", \"fem\"].");
  std::vector<Model> models;
  for (const py::handle name : names) {
    const std::optional<Model> model = model_named(model_of(py::reinterpret_borrow<py::object>(name)));
    if (!model)
      throw InputError("The model auto cannot be compared", "it stands for one of the others",
                       "Name those to compare, for instance halfspace and fem.");
    models.push_back(*model);
  }
  return models;
}

/// {model: Result}; None where the scene has no such set.
py::object results_of(const std::vector<SceneResult>& results) {
  if (results.empty())
    return py::none();
  py::dict out;
  for (const SceneResult& r : results)
    out[py::str(std::string(name_of(r.choice.model)))] =
        PythonResult{std::make_shared<const SceneResult>(r), {}};
  return out;
}

py::dict compare(const py::object& scene, const py::object& models, const py::object& changes,
                 const py::object& folder) {
  const SceneFile file = scene_file_of(scene, folder, changes_of(changes));
  const Comparison c = stoppable([file, models = models_of(models)](const std::atomic<bool>* stop) {
    return Sequence().compare(file, models, stop);
  });
  py::dict out = as_dict(record_of(c, {.fields = false}));
  out["at_equal_forces"] = results_of(c.at_forces);
  out["at_equal_position"] = results_of(c.at_position);
  return out;
}

/// None: no curve.
void add_range(std::vector<CreepRange>& ranges, CreepKind kind, const py::object& values) {
  if (!values.is_none())
    ranges.push_back({kind, numbers_in(values, name_of(kind))});
}

/// A table that was measured.
struct GivenTable {
  std::string source;
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;
};

/// A CSV file, or a dict of columns.
GivenTable table_of(const py::object& given) {
  if (!py::isinstance<py::dict>(given)) {
    const std::filesystem::path file = path_of(given);
    const std::vector<std::string> columns = csv_columns(file);
    return {file.string(), columns, read_csv(file, columns)};
  }
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;
  for (const auto& [name, values] : py::reinterpret_borrow<py::dict>(given)) {
    columns.push_back(text_of(py::reinterpret_borrow<py::object>(name), "a column"));
    const std::vector<double> numbers =
        numbers_in(py::reinterpret_borrow<py::object>(values), columns.back());
    rows.resize(columns.size() == 1 ? numbers.size() : rows.size());
    if (numbers.size() != rows.size())
      throw InputError("The measured forces cannot be used",
                       columns.back() + " has another length than " + columns.front(),
                       "Give one number of each for every point.");
    for (std::size_t i = 0; i < rows.size(); ++i)
      rows[i].push_back(numbers[i]);
  }
  return {"measured", columns, rows};
}

MeasuredForces measured_of(const py::object& given) {
  const GivenTable table = table_of(given);
  return measured_forces(table.source, table.columns, table.rows);
}

/// One table, or a list of them.
fit::Measurements measurements_of(const py::object& given) {
  fit::Measurements out;
  const auto add = [&](const py::object& one) {
    const GivenTable table = table_of(one);
    add_measured(out, table.source, table.columns, table.rows);
  };
  if (py::isinstance<py::list>(given) || py::isinstance<py::tuple>(given))
    for (const py::handle one : given)
      add(py::reinterpret_borrow<py::object>(one));
  else
    add(given);
  return out;
}

py::dict curves(const py::object& scene, const py::object& changes, const py::object& model,
                const py::object& xi, const py::object& eta, const py::object& phi, const py::object& folder,
                const py::object& executor, const py::object& measured) {
  const SceneText text = scene_of(scene, folder);
  const SceneFile file = with_model(parse_scene_file(text, changes_of(changes)), model_of(model));
  std::vector<CreepRange> ranges;
  add_range(ranges, CreepKind::xi, xi);
  add_range(ranges, CreepKind::eta, eta);
  add_range(ranges, CreepKind::phi, phi);
  if (ranges.empty())
    ranges = {{CreepKind::xi, {}}, {CreepKind::eta, {}}, {CreepKind::phi, {}}};
  std::optional<MeasuredForces> beside;
  if (!measured.is_none())
    beside = measured_of(measured);
  const auto solve = [=](const std::atomic<bool>* stop, const CreepSolver& solver) {
    if (!beside)
      return record_of(creep_curves(file, ranges, stop, solver));
    MeasuredForces points = *beside;
    record::Record out = record_of(creep_curves_beside(points, file, ranges, stop, solver));
    return out.add("measured", record_of(points));
  };
  if (!executor.is_none())
    return as_dict(solve(nullptr, task::creep_points_by(engine_of(executor), text, changes_of(changes))));
  return as_dict(stoppable([=](const std::atomic<bool>* stop) { return solve(stop, nullptr); }));
}

/// One text with commas between, or several.
std::vector<std::string> keys_of(const py::object& given) {
  if (py::isinstance<py::str>(given))
    return comma_separated(text_of(given, "a key"));
  if (!py::isinstance<py::iterable>(given))
    refuse_type("The parameters cannot be used", std::string(py::str(py::type::of(given))) + " is no list",
                "Give a list of keys, as [\"layer.compliance\"].");
  std::vector<std::string> keys;
  for (const py::handle key : given)
    keys.push_back(text_of(py::reinterpret_borrow<py::object>(key), "a key"));
  return keys;
}

py::dict fit_forces(const py::object& scene, const py::object& measured, const py::object& parameters,
                    const py::object& changes, const py::object& model, const py::object& folder) {
  const fit::Question question{.text = scene_of(scene, folder),
                               .changes = changes_of(changes),
                               .model = model_of(model),
                               .measured = measurements_of(measured),
                               .keys = keys_of(parameters)};
  return as_dict(stoppable(
      [question](const std::atomic<bool>* stop) { return record_of(fit::fit_curve(question, stop)); }));
}

py::dict wheelset(const py::object& scene, const py::object& changes, const py::object& model,
                  const py::object& folder) {
  const SceneFile file = with_model(scene_file_of(scene, folder, changes_of(changes)), model_of(model));
  const WheelsetResult found =
      stoppable([file](const std::atomic<bool>* stop) { return solve_wheelset(file, stop); });
  py::dict out = as_dict(record_of(found, {.fields = false}));
  for (const WheelSide side : both_sides)
    out[py::str(std::string(name_of(side)))]["result"] =
        PythonResult{std::make_shared<const SceneResult>(found.state.solved(side)), {}};
  return out;
}

} // namespace

void add_functions(py::module_& module) {
  module.def("_text_for_any_folder", [](const py::object& scene, const py::object& folder) {
    return with_absolute_names(scene_of(scene, folder));
  });
  module.def("_read_record",
             [](const std::filesystem::path& file) { return as_dict(record::read_hdf5(file)); });
  module.def(
      "compare", compare, "scene"_a, "models"_a = py::none(), "changes"_a = py::none(), py::kw_only(),
      "folder"_a = py::none(),
      "One scene with several models, half-space and fem unless `models` names others. A dict: "
      "\"at_equal_forces\" and \"at_equal_position\" are {model: Result}; \"creep_forces\" has "
      "\"xi_from_free_rolling\", an array, and \"Fx\" and \"Fx_error\", {model: array} (N); "
      "\"reference\" is the model that the others are compared with. A set that the scene does not have is "
      "None. `scene`, `changes`: as solve() takes them. Look at equal forces first: at equal position a "
      "hundredth of a millimetre makes "
      "most of the difference.");
  module.def(
      "creep_curves", curves, "scene"_a, "changes"_a = py::none(), "model"_a = py::none(), py::kw_only(),
      "xi"_a = py::none(), "eta"_a = py::none(), "phi"_a = py::none(), "folder"_a = py::none(),
      "executor"_a = py::none(), "measured"_a = py::none(),
      "Forces over creepages. `scene`, `changes`, `model`: as solve() takes them. `xi`, `eta`, `phi`: the "
      "values of a curve over this creepage, the other two being the scene's; without any, three curves "
      "from full slip to full slip. A dict: \"curves\" (a dict of arrays for each creepage), and matrices "
      "[Fx, Fs, Mz][xi, eta, phi]: \"slopes\" without creepage, \"kalker\" (linear theory for the nearest "
      "ellipse, or None) and \"sensitivities\" at the scene's creepages; \"forces\" there. N, mm. "
      "`measured`: a CSV "
      "file or a dict of "
      "measured forces (columns xi,Fx or xi,Fx,scatter); \"measured\" then has them beside the computed "
      "ones. `executor`: any of "
      "concurrent.futures, or with its methods, shares the points in chunks that start cold: the forces are "
      "the same within the certificate, and do not depend on how many share them.");
  module.def(
      "fit", fit_forces, "scene"_a, "measured"_a, "parameters"_a, "changes"_a = py::none(),
      "model"_a = py::none(), py::kw_only(), "folder"_a = py::none(),
      "Keys of a scene by measured forces or pressures, by least squares. `scene`, `changes`, `model`: as "
      "solve() takes them; their values are the first guess. `measured`: a CSV file, or a dict of columns, "
      "or "
      "a list of these: a creepage (xi, eta, phi), a force (Fx, Fs, Mz), and the scatter of the force where "
      "it "
      "is known; or s,pn or x,pn (mm, MPa: the largest pressure along the other axis). `parameters`: keys, "
      "as [\"layer.compliance\", \"motion.friction\"]. A dict: \"parameters\" ({key: {\"value\", \"low\", "
      "\"high\", \"standard_error\", ...}}, intervals of 95 % by a bootstrap of the points), "
      "\"correlation\", "
      "\"not_determined\" (what the points do not say), \"measured\" (\"measured_2\" ...) and \"pressures\", "
      "and with forces \"band\" and what creep_curves() gives at the found values. N, mm.");
  module.def("_run_task", run_task, "task"_a, "common"_a, "portion"_a);
  module.def(
      "wheelset", wheelset, "scene"_a, "changes"_a = py::none(), "model"_a = py::none(), py::kw_only(),
      "folder"_a = py::none(),
      "Both wheels of a wheelset under the forces on its axle. `scene` has a table [wheelset]; `scene`, "
      "`changes`, `model`: as solve() takes them. A dict: \"wheelset\" (displacement, roll, sums), \"right\" "
      "and \"left\", each with \"track\" (numbers in the track frame, y to the right, and their errors) and "
      "\"result\" (a "
      "Result, in the frame of its side), \"certified\", \"warnings\", \"seconds\". N, mm, rad.");
}

} // namespace bem_contact
