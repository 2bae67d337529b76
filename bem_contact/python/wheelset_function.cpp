#include "bem_contact/python/functions.hpp"
#include "bem_contact/python/result_object.hpp"
#include "bem_contact/python/stoppable.hpp"
#include "bem_contact/python/values.hpp"
#include "bem_contact/wheelset/quantities.hpp"

namespace py = pybind11;

namespace bem_contact {

namespace {

py::dict wheel_of(const WheelsetResult& r, WheelSide side) {
  py::dict track;
  for (const WheelQuantity& q : wheel_quantities())
    track[q.name] = q.value(r.state, side);
  py::dict out;
  out["track"] = track;
  out["result"] = PythonResult{std::make_shared<const SceneResult>(r.state.solved(side)), {}};
  return out;
}

py::dict wheelset(const py::object& scene, const py::object& changes, const py::object& model,
                  const py::object& folder) {
  const SceneFile file = with_model(scene_file_of(scene, folder, changes_of(changes)), model_of(model));
  const WheelsetResult found =
      stoppable([file](const std::atomic<bool>* stop) { return solve_wheelset(file, stop); });
  py::dict totals;
  for (const WheelsetQuantity& q : wheelset_quantities())
    totals[q.name] = q.value(found);
  using namespace py::literals;
  return py::dict("wheelset"_a = totals, "right"_a = wheel_of(found, WheelSide::right),
                  "left"_a = wheel_of(found, WheelSide::left), "certified"_a = found.state.certified(),
                  "warnings"_a = found.warnings, "seconds"_a = found.seconds);
}

} // namespace

void add_wheelset(py::module_& module) {
  using namespace py::literals;
  module.def(
      "wheelset", wheelset, "scene"_a, "changes"_a = py::none(), "model"_a = py::none(), py::kw_only(),
      "folder"_a = py::none(),
      "Both wheels of a wheelset under the forces on its axle. `scene` has a table [wheelset]; `scene`, "
      "`changes`, `model`: as solve() takes them. A dict: \"wheelset\" (displacement, roll, sums), \"right\" "
      "and \"left\", each with \"track\" (numbers in the track frame, y to the right) and \"result\" (a "
      "Result, in the frame of its side), \"certified\", \"warnings\", \"seconds\". N, mm, rad.");
}

} // namespace bem_contact
