#include "bem_contact/python/conicity_function.hpp"

#include "bem_contact/conicity/scene_wheelset.hpp"
#include "bem_contact/conicity/wheelset_conicity.hpp"
#include "bem_contact/python/values.hpp"

#include <pybind11/numpy.h>

#include <limits>

namespace py = pybind11;

namespace bem_contact {

namespace {

template <class Range, class Of> py::array_t<double> line(const Range& range, const Of& of) {
  std::vector<double> values;
  for (const auto& element : range)
    values.push_back(of(element));
  return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

py::dict function_of(const WheelsetConicity& c) {
  using S = WheelsetStand;
  py::dict out;
  const auto add = [&](const char* name, auto of) { out[name] = line(c.stands, of); };
  add("lateral", [](const S& s) { return s.lateral; });
  add("difference", [](const S& s) { return s.difference(); });
  add("roll", [](const S& s) { return s.roll; });
  for (const auto& [side, touch] : {std::pair("right", &S::right), std::pair("left", &S::left)}) {
    const auto of_side = [&, side = std::string(side), touch = touch](const char* name, auto of) {
      add((side + name).c_str(), [&](const S& s) { return of(s.*touch); });
    };
    of_side("_radius", [](const WheelTouch& t) { return t.radius; });
    of_side("_wheel_y", [](const WheelTouch& t) { return t.wheel.y; });
    of_side("_wheel_s", [](const WheelTouch& t) { return t.wheel_s; });
    of_side("_rail_y", [](const WheelTouch& t) { return t.rail.y; });
    of_side("_rail_s", [](const WheelTouch& t) { return t.rail_s; });
    of_side("_delta", [](const WheelTouch& t) { return t.delta; });
  }
  return out;
}

py::dict conicity_of(const WheelsetConicity& c) {
  py::dict out;
  out["amplitude"] = line(c.values, [](const auto& v) { return v.amplitude; });
  const auto add = [&](const char* name, double EquivalentConicity::*member) {
    out[name] = line(c.values, [&](const auto& v) {
      return v.motion ? (*v.motion).*member : std::numeric_limits<double>::quiet_NaN();
    });
  };
  add("tan_gamma", &EquivalentConicity::tan_gamma);
  add("wavelength", &EquivalentConicity::wavelength);
  add("from", &EquivalentConicity::from);
  add("to", &EquivalentConicity::to);
  return out;
}

py::dict conicity(const py::object& scene, const py::object& changes, const std::string& left_wheel,
                  const std::string& left_rail, bool roll, double to, double step, const py::object& folder) {
  const std::vector<SceneChange> list = changes_of(changes);
  const SceneFile file = scene.is_none() ? scene_without_file(list) : scene_file_of(scene, folder, list);
  WheelsetOnTrack wheelset = wheelset_of(file, {.rail = left_rail, .wheel = left_wheel});
  wheelset.rolls = roll;
  const WheelsetConicity found = [&] {
    const py::gil_scoped_release others_may_run;
    return wheelset_conicity(wheelset, {.largest = to, .step = step});
  }();
  using namespace py::literals;
  return py::dict("function"_a = function_of(found), "conicity"_a = conicity_of(found),
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
