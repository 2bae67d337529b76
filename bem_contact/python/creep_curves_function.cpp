#include "bem_contact/base/error.hpp"
#include "bem_contact/curves/creep_columns.hpp"
#include "bem_contact/python/functions.hpp"
#include "bem_contact/python/stoppable.hpp"
#include "bem_contact/python/values.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <variant>

namespace py = pybind11;

namespace bem_contact {

namespace {

py::array_t<double> matrix(const CreepMatrix& m) {
  return py::array_t<double>({3, 3}, m.front().data());
}

py::dict curve_of(const CreepCurve& curve) {
  py::dict out;
  out["creepage"] = array_of(creepages_of(curve));
  for (const CreepColumn& column : creep_columns())
    out[column.name] = array_of(column.values(curve));
  return out;
}

py::dict dict_of(const CreepCurves& c) {
  using namespace py::literals;
  py::dict curves;
  for (const CreepCurve& curve : c.curves)
    curves[py::str(std::string(name_of(curve.which)))] = curve_of(curve);
  const CreepForceValues forces = forces_of(c.solution);
  py::dict out("curves"_a = curves, "forces"_a = py::array_t<double>(3, forces.data()), "bound"_a = c.bound,
               "radius"_a = c.radius, "model"_a = std::string(name_of(c.solution.model)),
               "certified"_a = c.certified());
  for (const CreepMatrixEntry& entry : creep_matrices()) {
    const CreepMatrix* m = entry.of(c);
    out[entry.name] = m ? py::object(matrix(*m)) : py::none();
  }
  return out;
}

/// Numbers in a list or an array of one dimension; None: no curve.
void add_range(std::vector<CreepRange>& ranges, CreepKind kind, const py::object& values) {
  if (values.is_none())
    return;
  const std::string key(name_of(kind));
  py::dict one;
  one[py::str(key)] = values;
  const SchemaValue value = changes_of(one).front().value;
  if (const auto* numbers = std::get_if<std::vector<double>>(&value); numbers && !numbers->empty())
    ranges.push_back({kind, *numbers});
  else
    throw py::type_error(Error("The values of " + key + " cannot be used", "they are no list of numbers",
                               "Give a list or an array, as [0, 1e-3, 2e-3].")
                             .what());
}

py::dict curves(const py::object& scene, const py::object& changes, const py::object& model,
                const py::object& xi, const py::object& eta, const py::object& phi,
                const py::object& folder) {
  const SceneFile file = with_model(scene_file_of(scene, folder, changes_of(changes)), model_of(model));
  std::vector<CreepRange> ranges;
  add_range(ranges, CreepKind::xi, xi);
  add_range(ranges, CreepKind::eta, eta);
  add_range(ranges, CreepKind::phi, phi);
  if (ranges.empty())
    ranges = {{CreepKind::xi, {}}, {CreepKind::eta, {}}, {CreepKind::phi, {}}};
  return dict_of(stoppable([=](const std::atomic<bool>* stop) { return creep_curves(file, ranges, stop); }));
}

} // namespace

void add_creep_curves(py::module_& module) {
  using namespace py::literals;
  module.def(
      "creep_curves", curves, "scene"_a, "changes"_a = py::none(), "model"_a = py::none(), py::kw_only(),
      "xi"_a = py::none(), "eta"_a = py::none(), "phi"_a = py::none(), "folder"_a = py::none(),
      "Forces over creepages. `scene`, `changes`, `model`: as solve() takes them. `xi`, `eta`, `phi`: the "
      "values of a curve over this creepage, the other two being the scene's; without any, three curves "
      "from full slip to full slip. A dict: \"curves\" (a dict of arrays for each creepage), and matrices "
      "[Fx, Fs, Mz][xi, eta, phi]: \"slopes\" without creepage, \"kalker\" (linear theory for the nearest "
      "ellipse, or None), \"sensitivities\" at the scene's creepages, by differences, and \"linearised\", "
      "by one linear system with the pressure held (or None); \"forces\" there. N, mm.");
}

} // namespace bem_contact
