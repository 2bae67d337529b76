#include "bem_contact/python/executors.hpp"
#include "bem_contact/python/functions.hpp"
#include "bem_contact/python/record_object.hpp"
#include "bem_contact/python/stoppable.hpp"
#include "bem_contact/python/values.hpp"
#include "bem_contact/task/tasks.hpp"
#include "bem_contact/uses/conicity/wheelset_conicity.hpp"

#include <pybind11/stl.h>

#include <atomic>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace bem_contact {

namespace {

using namespace py::literals;

/// The name of a profile, or a path (as that of a Profile).
std::string profile_named(const py::object& given, const char* what) {
  return py::hasattr(given, "__fspath__") ? path_of(given) : text_of(given, what);
}

std::optional<SceneText> text_or_none(const py::object& scene, const py::object& folder) {
  return scene.is_none() ? std::nullopt : std::optional(scene_of(scene, folder));
}

SceneFile file_of(const std::optional<SceneText>& scene, const std::vector<SceneChange>& changes) {
  return scene ? parse_scene_file(*scene, changes) : scene_without_file(changes);
}

py::dict conicity(const py::object& scene, const py::object& changes, const py::object& left_wheel,
                  const py::object& left_rail, bool roll, double to, double step, const py::object& folder) {
  WheelsetOnTrack wheelset = wheelset_of(
      file_of(text_or_none(scene, folder), changes_of(changes)),
      {.rail = profile_named(left_rail, "left_rail"), .wheel = profile_named(left_wheel, "left_wheel")});
  wheelset.rolls = roll;
  const WheelsetConicity found = stoppable([=](const std::atomic<bool>* stop) {
    return wheelset_conicity(wheelset, {.largest = to, .step = step}, stop);
  });
  return as_dict(record_of(found, wheelset));
}

/// Names of profiles in a list; None: none are given.
std::vector<std::string> names_in(const py::object& names, const char* what) {
  if (names.is_none())
    return {};
  if (py::isinstance<py::str>(names) || py::hasattr(names, "__fspath__") ||
      !py::isinstance<py::iterable>(names))
    refuse_type(std::string("The ") + what + " cannot be used",
                std::string(py::str(py::type::of(names))) + " is no list",
                "Give a list of standards, files and Profiles, as [\"S1002\", \"LMA\"].");
  std::vector<std::string> out;
  for (const py::handle name : names)
    out.push_back(profile_named(py::reinterpret_borrow<py::object>(name), what));
  return out;
}

py::dict map_of(const py::object& scene, const py::object& changes, const py::object& wheels,
                const py::object& rails, const py::object& gauges, double amplitude,
                const std::optional<double>& noise, int draws, int seed, bool roll, const py::object& folder,
                const py::object& executor) {
  const std::optional<SceneText> text = text_or_none(scene, folder);
  std::vector<SceneChange> list = changes_of(changes);
  ConicityMapRange range{.wheels = names_in(wheels, "wheels"),
                         .rails = names_in(rails, "rails"),
                         .gauges = gauges.is_none() ? std::vector<double>() : numbers_in(gauges, "gauges"),
                         .amplitude = amplitude,
                         .rolls = roll};
  if (noise)
    range.scatter = ProfileScatter{*noise, draws, seed};
  for (const auto& [key, names] : {std::pair{"wheel.profile", &range.wheels}, {"rail.profile", &range.rails}})
    if (!names->empty())
      list.push_back({key, names->front()});
  const SceneFile first = file_of(text, list);
  if (range.wheels.empty())
    range.wheels = {first.wheel.profile};
  if (range.rails.empty())
    range.rails = {first.rail.profile};
  return as_dict(record_of(task::conicity_map_by(engine_of(executor), text, changes_of(changes), range)));
}

} // namespace

void add_conicity(py::module_& module) {
  module.def("conicity", conicity, "scene"_a = py::none(), "changes"_a = py::none(), py::kw_only(),
             "left_wheel"_a = "", "left_rail"_a = "", "roll"_a = false, "to"_a = 10.0, "step"_a = 1.0,
             "folder"_a = py::none(),
             "Rolling radius difference and equivalent conicity (EN 15302) of a rigid wheelset. Profiles and "
             "track come from a scene, from `changes`, as {\"wheel.profile\": \"S1002\", \"rail.profile\": "
             "\"60E1\", \"position.rail_inclination\": 0.025}, or from both; paths start at the scene's "
             "folder, without a "
             "scene at the working directory. A left side that differs has names of its own. `roll`: the "
             "wheelset rolls until both wheels stand. Amplitudes: step, 2 step, .. `to`, mm. A dict: "
             "\"function\" over the lateral displacement, \"conicity\" over the amplitude, mm and rad.");
  module.def(
      "conicity_map", map_of, "scene"_a = py::none(), "changes"_a = py::none(), py::kw_only(),
      "wheels"_a = py::none(), "rails"_a = py::none(), "gauges"_a = py::none(), "amplitude"_a = 3.0,
      "noise"_a = py::none(), "draws"_a = 20, "seed"_a = 1, "roll"_a = false, "folder"_a = py::none(),
      "executor"_a = py::none(),
      "Equivalent conicities of many wheelsets: every wheel on every rail at every gauge (mm). `scene`, "
      "`changes`, `roll`: as conicity() takes them. `wheels`, `rails`: lists of standards, files and "
      "Profiles; those of the scene where none are given. `amplitude` of the motion, mm. `noise`: the points "
      "of both profiles scatter by so much (standard deviation, mm), `draws` times from `seed`. A dict: "
      "\"wheels\" and \"rails\" (names), \"map\" (arrays, a value for each wheel, rail and gauge; \"wheel\" "
      "and \"rail\" are places in the lists of names), nan where there is no motion. `executor`: any of "
      "concurrent.futures shares the pairs; the numbers are the same.");
}

} // namespace bem_contact
