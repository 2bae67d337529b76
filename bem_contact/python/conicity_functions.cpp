#include "bem_contact/python/executors.hpp"
#include "bem_contact/python/functions.hpp"
#include "bem_contact/python/record_object.hpp"
#include "bem_contact/python/stoppable.hpp"
#include "bem_contact/python/values.hpp"
#include "bem_contact/uses/conicity/conicity_map.hpp"
#include "bem_contact/uses/conicity/wheelset_conicity.hpp"

#include <pybind11/stl.h>

#include <array>
#include <atomic>
#include <optional>
#include <string>
#include <tuple>
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

/// `scene`: its text for another process (tuple_of()), or None.
py::dict conicity_of(const py::object& scene, const py::object& changes, const py::object& left_wheel,
                     const py::object& left_rail, bool roll, double to, double step) {
  const std::vector<SceneChange> list = changes_of(changes);
  const SceneFile file =
      scene.is_none() ? scene_without_file(list) : parse_scene_file(scene_text_of(scene), list);
  WheelsetOnTrack wheelset = wheelset_of(file, {.rail = profile_named(left_rail, "left_rail"),
                                                .wheel = profile_named(left_wheel, "left_wheel")});
  wheelset.rolls = roll;
  const WheelsetConicity found = stoppable([=](const std::atomic<bool>* stop) {
    return wheelset_conicity(wheelset, {.largest = to, .step = step}, stop);
  });
  return as_dict(record_of(found, wheelset));
}

py::dict conicity(const py::object& scene, const py::object& changes, const py::object& left_wheel,
                  const py::object& left_rail, bool roll, double to, double step, const py::object& folder,
                  const py::object& executor) {
  const py::object text = scene.is_none() ? scene : tuple_of(scene_of(scene, folder));
  if (executor.is_none())
    return conicity_of(text, changes, left_wheel, left_rail, roll, to, step);
  py::list tasks; // one: it is done sooner than a process is started
  tasks.append(py::make_tuple(text, changes, left_wheel, left_rail, roll, to, step));
  return run_on(executor, "conicity", tasks)[0];
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

/// Noise, draws and seed of a scatter.
using Scatter = std::tuple<double, int, int>;
/// Numbers of one gauge, and in how many draws a motion has the amplitude.
using MapEntry = std::pair<std::array<double, 11>, int>;

constexpr std::array<double ConicityMap::Entry::*, 11> entry_numbers = {
    &ConicityMap::Entry::gauge,
    &ConicityMap::Entry::tan_gamma,
    &ConicityMap::Entry::wavelength,
    &ConicityMap::Entry::rail_travel,
    &ConicityMap::Entry::wheel_travel,
    &ConicityMap::Entry::play,
    &ConicityMap::Entry::rated_amplitude,
    &ConicityMap::Entry::nonlinearity,
    &ConicityMap::Entry::mean,
    &ConicityMap::Entry::spread,
    &ConicityMap::Entry::nonlinearity_spread};

/// The scene with the profiles of one pair; "": its own.
SceneFile scene_of_pair(const py::object& scene, const py::object& changes, const std::string& wheel,
                        const std::string& rail) {
  std::vector<SceneChange> list = changes_of(changes);
  for (const auto& [key, name] : {std::pair{"wheel.profile", &wheel}, {"rail.profile", &rail}})
    if (!name->empty())
      list.push_back({key, *name});
  return scene.is_none() ? scene_without_file(list) : parse_scene_file(scene_text_of(scene), list);
}

/// One task, here or in a process of an executor: the entries of one pair, by gauge.
std::vector<MapEntry> map_part(const py::object& scene, const py::object& changes, const std::string& wheel,
                               const std::string& rail, const std::vector<double>& gauges, double amplitude,
                               bool roll, const std::optional<Scatter>& scatter) {
  ConicityMapRange range{
      .wheels = {wheel}, .rails = {rail}, .gauges = gauges, .amplitude = amplitude, .rolls = roll};
  if (scatter)
    range.scatter = std::make_from_tuple<ProfileScatter>(*scatter);
  const SceneFile file = scene_of_pair(scene, changes, wheel, rail);
  const ConicityMap map = stoppable([&](const std::atomic<bool>* stop) {
    return conicity_map(
        range, [&](const auto&, const auto&) { return file; }, [] {}, stop);
  });
  std::vector<MapEntry> out;
  for (const ConicityMap::Entry& entry : map.entries) {
    MapEntry& made = out.emplace_back();
    for (std::size_t k = 0; k < entry_numbers.size(); ++k)
      made.first[k] = entry.*entry_numbers[k];
    made.second = entry.draws;
  }
  return out;
}

ConicityMap::Entry entry_of(const MapEntry& made, std::size_t wheel, std::size_t rail) {
  ConicityMap::Entry entry{.wheel = wheel, .rail = rail};
  for (std::size_t k = 0; k < entry_numbers.size(); ++k)
    entry.*entry_numbers[k] = made.first[k];
  entry.draws = made.second;
  return entry;
}

py::dict map_of(const py::object& scene, const py::object& changes, const py::object& wheels,
                const py::object& rails, const py::object& gauges, double amplitude,
                const std::optional<double>& noise, int draws, int seed, bool roll, const py::object& folder,
                const py::object& executor) {
  const py::object text = scene.is_none() ? scene : tuple_of(scene_of(scene, folder));
  ConicityMap map{
      .wheels = names_in(wheels, "wheels"), .rails = names_in(rails, "rails"), .amplitude = amplitude};
  if (map.wheels.empty() || map.rails.empty()) {
    const auto first = [](const std::vector<std::string>& names) {
      return names.empty() ? "" : names.front();
    };
    const SceneFile file = scene_of_pair(text, changes, first(map.wheels), first(map.rails));
    if (map.wheels.empty())
      map.wheels = {file.wheel.profile};
    if (map.rails.empty())
      map.rails = {file.rail.profile};
  }
  std::optional<Scatter> scatter;
  if (noise) {
    scatter = Scatter{*noise, draws, seed};
    map.scatter = std::make_from_tuple<ProfileScatter>(*scatter);
  }
  const std::vector<double> given = gauges.is_none() ? std::vector<double>() : numbers_in(gauges, "gauges");
  std::vector<std::vector<MapEntry>> parts;
  py::list tasks;
  for (const std::string& wheel : map.wheels)
    for (const std::string& rail : map.rails)
      if (executor.is_none())
        parts.push_back(map_part(text, changes, wheel, rail, given, amplitude, roll, scatter));
      else
        tasks.append(py::make_tuple(text, changes, wheel, rail, given, amplitude, roll, scatter));
  if (!executor.is_none())
    for (const py::handle part : run_on(executor, "conicity_map", tasks))
      parts.push_back(part.cast<std::vector<MapEntry>>());
  for (std::size_t pair = 0; pair < parts.size(); ++pair)
    for (const MapEntry& made : parts[pair])
      map.entries.push_back(entry_of(made, pair / map.rails.size(), pair % map.rails.size()));
  return as_dict(record_of(map));
}

} // namespace

void add_conicity(py::module_& module) {
  module.def("conicity", conicity, "scene"_a = py::none(), "changes"_a = py::none(), py::kw_only(),
             "left_wheel"_a = "", "left_rail"_a = "", "roll"_a = false, "to"_a = 10.0, "step"_a = 1.0,
             "folder"_a = py::none(), "executor"_a = py::none(),
             "Rolling radius difference and equivalent conicity (EN 15302) of a rigid wheelset. Profiles and "
             "track come from a scene, from `changes`, as {\"wheel.profile\": \"S1002\", \"rail.profile\": "
             "\"60E1\", \"position.rail_inclination\": 0.025}, or from both; paths start at the scene's "
             "folder, without a "
             "scene at the working directory. A left side that differs has names of its own. `roll`: the "
             "wheelset rolls until both wheels stand. Amplitudes: step, 2 step, .. `to`, mm. A dict: "
             "\"function\" over the lateral displacement, \"conicity\" over the amplitude, mm and rad. "
             "`executor`: any "
             "of concurrent.futures does it elsewhere, as one task, because it takes a tenth of a second.");
  module.def("_conicity_part", conicity_of, "scene"_a, "changes"_a, "left_wheel"_a, "left_rail"_a, "roll"_a,
             "to"_a, "step"_a);
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
  module.def("_conicity_map_part", map_part, "scene"_a, "changes"_a, "wheel"_a, "rail"_a, "gauges"_a,
             "amplitude"_a, "roll"_a, "scatter"_a);
}

} // namespace bem_contact
