#include "bem_contact/conicity/conicity_columns.hpp"
#include "bem_contact/conicity/scene_wheelset.hpp"
#include "bem_contact/python/functions.hpp"
#include "bem_contact/python/stoppable.hpp"
#include "bem_contact/python/values.hpp"

#include <span>

namespace py = pybind11;

namespace bem_contact {

namespace {

template <class Column> py::dict dict_of(std::span<const Column> columns, const WheelsetConicity& c) {
  py::dict out;
  for (const Column& column : columns)
    out[column.name] = array_of(column.values(c));
  return out;
}

py::dict conicity(const py::object& scene, const py::object& changes, const std::string& left_wheel,
                  const std::string& left_rail, bool roll, double to, double step, const py::object& folder) {
  const std::vector<SceneChange> list = changes_of(changes);
  const SceneFile file = scene.is_none() ? scene_without_file(list) : scene_file_of(scene, folder, list);
  WheelsetOnTrack wheelset = wheelset_of(file, {.rail = left_rail, .wheel = left_wheel});
  wheelset.rolls = roll;
  const WheelsetConicity found = stoppable(
      [=](const std::atomic<bool>*) { return wheelset_conicity(wheelset, {.largest = to, .step = step}); });
  using namespace py::literals;
  return py::dict("function"_a = dict_of(stand_columns(), found),
                  "conicity"_a = dict_of(conicity_columns(), found),
                  "wheel_radius"_a = found.lengths.wheel_radius,
                  "contact_distance"_a = found.lengths.contact_distance, "rolls"_a = roll);
}

} // namespace

void add_conicity(py::module_& module) {
  using namespace py::literals;
  module.def(
      "conicity", conicity, "scene"_a = py::none(), "changes"_a = py::none(), py::kw_only(),
      "left_wheel"_a = "", "left_rail"_a = "", "roll"_a = false, "to"_a = 10.0, "step"_a = 1.0,
      "folder"_a = py::none(),
      "Rolling radius difference and equivalent conicity (EN 15302) of a rigid wheelset. Profiles and "
      "track come from a scene, from `changes`, as {\"wheel.profile\": \"S1002\", \"rail.profile\": "
      "\"60E1\", \"position.cant\": 0.025}, or from both; paths start at the scene's folder, without a "
      "scene at the working directory. A left side that differs has names of its own. `roll`: the "
      "wheelset rolls until both wheels stand. Amplitudes: step, 2 step, .. `to`, mm. A dict: "
      "\"function\" over the lateral displacement, \"conicity\" over the amplitude, mm and rad.");
}

} // namespace bem_contact
