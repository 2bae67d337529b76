#include "bem_contact/base/error.hpp"
#include "bem_contact/python/functions.hpp"
#include "bem_contact/python/result_object.hpp"
#include "bem_contact/python/stoppable.hpp"
#include "bem_contact/python/values.hpp"
#include "bem_contact/sequence/sequence.hpp"

#include <string>
#include <vector>

namespace py = pybind11;

namespace bem_contact {

namespace {

std::vector<Model> models_of(const py::object& names) {
  if (names.is_none())
    return {Model::halfspace, Model::fem};
  if (py::isinstance<py::str>(names) || !py::isinstance<py::iterable>(names))
    throw py::type_error("The models cannot be used (" + std::string(py::str(py::type::of(names))) +
                         " is no list) Give a list of names, as [\"halfspace\", \"fem\"].");
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
    out[py::str(std::string(name_of(r.model)))] = PythonResult{std::make_shared<const SceneResult>(r), {}};
  return out;
}

py::object creep_forces_of(const Comparison& c) {
  if (c.creep_forces.empty())
    return py::none();
  py::dict out, fx, errors;
  const auto column = [&](const auto& value) {
    std::vector<double> values;
    for (const CreepForces& forces : c.creep_forces)
      values.push_back(value(forces));
    return array_of(values);
  };
  out["xi_from_free_rolling"] = column([](const CreepForces& f) { return f.creepage; });
  for (std::size_t m = 0; m < c.models.size(); ++m) {
    const py::str name(std::string(name_of(c.models[m])));
    fx[name] = column([m](const CreepForces& f) { return f.Fx[m]; });
    errors[name] = column([m](const CreepForces& f) { return f.Fx_error[m]; });
  }
  out["Fx"] = fx;
  out["Fx_error"] = errors;
  return out;
}

py::dict compare(const py::object& scene, const py::object& models, const py::object& changes,
                 const py::object& folder) {
  const SceneFile file = scene_file_of(scene, folder, changes_of(changes));
  const Comparison c = stoppable([file, models = models_of(models)](const std::atomic<bool>* stop) {
    return Sequence().compare(file, models, stop);
  });
  using namespace py::literals;
  return py::dict("reference"_a = std::string(name_of(c.models[c.reference])),
                  "at_equal_forces"_a = results_of(c.at_forces), "creep_forces"_a = creep_forces_of(c),
                  "at_equal_position"_a = results_of(c.at_position));
}

} // namespace

void add_compare(py::module_& module) {
  using namespace py::literals;
  module.def(
      "compare", compare, "scene"_a, "models"_a = py::none(), "changes"_a = py::none(), py::kw_only(),
      "folder"_a = py::none(),
      "One scene with several models, half-space and fem unless `models` names others. A dict: "
      "\"at_equal_forces\" and \"at_equal_position\" are {model: Result}; \"creep_forces\" has "
      "\"xi_from_free_rolling\", an array, and \"Fx\" and \"Fx_error\", {model: array} (N); "
      "\"reference\" is the model that the others are compared with. A set that the scene does not have is "
      "None. `scene`, `changes`: as solve() takes "
      "them. Look at equal forces first: at equal position a hundredth of a millimetre makes most of the "
      "difference.");
}

} // namespace bem_contact
