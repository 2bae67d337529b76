#include "bem_contact/base/error.hpp"
#include "bem_contact/base/temporary_folder.hpp"
#include "bem_contact/python/executors.hpp"
#include "bem_contact/python/functions.hpp"
#include "bem_contact/python/record_object.hpp"
#include "bem_contact/python/result_object.hpp"
#include "bem_contact/python/stoppable.hpp"
#include "bem_contact/python/values.hpp"
#include "bem_contact/scene/sweep_file.hpp"
#include "bem_contact/task/tasks.hpp"
#include "bem_contact/uses/fatigue/fatigue_of_result.hpp"
#include "bem_contact/uses/wear/rates.hpp"
#include "bem_contact/uses/wear/study.hpp"
#include "bem_contact/uses/wear/wear_of_result.hpp"

#include <fmt/format.h>
#include <optional>
#include <pybind11/stl.h>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace bem_contact {

/// Anything but a Result: pybind11 tries all functions of a name without conversions first, and one that
/// takes any object would take a Result whose `hardness` is a whole number.
class NoResult : public pybind11::object {
  static bool is_no_result(PyObject* given) { return !pybind11::isinstance<PythonResult>(given); }

public:
  PYBIND11_OBJECT_DEFAULT(NoResult, object, is_no_result)
};

} // namespace bem_contact

template <> struct pybind11::detail::handle_type_name<bem_contact::NoResult> {
  static constexpr auto name = const_name("object");
};

namespace bem_contact {

namespace {

namespace py = pybind11;
using namespace py::literals;

const SceneResult& solved(const PythonResult& result, const char* function) {
  if (!result.solved)
    throw InputError(fmt::format("{} needs a result that was solved here", function),
                     "one that was pickled holds only its properties", "Solve the scene again.");
  return *result.solved;
}

py::array_t<double> field(const SceneResult& r, const std::vector<double>& values) {
  return py::array_t<double>({r.problem.grid.ms, r.problem.grid.mx}, values.data());
}

using NumberList = std::vector<double>;

std::optional<wear::WearMap>
map_of(const std::optional<std::tuple<NumberList, NumberList, std::vector<NumberList>>>& given) {
  if (!given)
    return std::nullopt;
  wear::WearMap map{std::get<0>(*given), std::get<1>(*given), {}};
  for (const NumberList& row : std::get<2>(*given))
    map.coefficients.insert(map.coefficients.end(), row.begin(), row.end());
  return map;
}

py::dict wear_of(const PythonResult& result, const std::string& law, double hardness, double speed,
                 const std::optional<std::tuple<NumberList, NumberList, std::vector<NumberList>>>& map) {
  const SceneResult& r = solved(result, "wear");
  const wear::Wear w = wear::wear_of(r, wear::law_named(law, hardness, speed, map_of(map)));
  py::dict out("rate"_a = field(r, w.rate), "s"_a = array_of(w.rail.s), "wheel_s"_a = array_of(w.wheel.s),
               "depth"_a = array_of(w.rail.depth), "sliding_distance"_a = array_of(w.sliding_over_s),
               "volume_per_distance"_a = w.volume_per_distance);
  if (r.motion.rolling.radius > 0) // a wheel on a rail
    out.attr("update")(as_dict(
        record::numbers_of(wear::rate_columns(), false, wear::rates_of(r, w, 2 * r.result.totals.Fz))));
  return out;
}

using States = std::vector<wear::WornPair>; ///< by step, the unworn one first

/// `of`: the points of a profile in one of the states.
template <class Of> py::array_t<double> points_of(const States& states, const Of& of) {
  py::array_t<double> out({states.size(), of(states.front())->size(), std::size_t(2)});
  double* at = out.mutable_data();
  for (const wear::WornPair& state : states)
    for (const Point2& p : *of(state))
      *at++ = p.y, *at++ = p.z;
  return out;
}

/// Of a rail of sections: each with its place, what is gone from it in the end, and its profiles by step.
py::list sections_of(const States& states) {
  py::list out;
  const std::vector<wear::SectionRow> rows = wear::section_rows(states.back().sections);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    py::dict one;
    for (const auto& column : wear::section_columns())
      one[py::str(column.name)] = column.value(rows[i]);
    one["profile"] = points_of(states, [i](const wear::WornPair& p) { return &p.sections[i].worn.points; });
    out.append(std::move(one));
  }
  return out;
}

/// Takes what is named from `rest`, if it is there; else `option` stays what it is. Throws TypeError for
/// another type.
template <class Value> void take(py::kwargs& rest, const char* name, Value& option) {
  if (!rest.contains(name))
    return;
  try {
    option = rest.attr("pop")(name).cast<Value>();
  } catch (const py::cast_error&) {
    refuse_type(fmt::format("'{}' of wear() cannot be used", name), "it has another type",
                std::is_same_v<Value, double> ? "Give a number." : "Give a text.");
  }
}

wear::StudyOptions study_options(double depth, py::kwargs given) {
  wear::StudyOptions out{.depth = depth};
  for (const auto& [name, text] : {std::pair{"law", &out.law}, {"body", &out.body}})
    take(given, name, *text);
  for (const auto& [name, number] : {std::pair{"hardness", &out.hardness},
                                     {"speed", &out.speed},
                                     {"cap", &out.steps.cap},
                                     {"smoothing", &out.steps.smoothing},
                                     {"passages", &out.steps.passages},
                                     {"kept_turn", &out.steps.kept_turn}})
    take(given, name, *number);
  refuse_unknown("wear",
                 {"law", "hardness", "speed", "body", "cap", "smoothing", "passages", "kept_turn", "model",
                  "folder", "executor"},
                 {}, given);
  return out;
}

States worn_by(wear::Study study, const std::atomic<bool>* stop) {
  study.options.stop = stop;
  const TemporaryFolder folder;
  States states{wear::unworn(study.scene())};
  wear::KeptPair influence;
  if (wear::needs_influence(study.scene()))
    influence = wear::unworn_influence(study.scene(), states.front());
  wear::evolve(
      study, states.front(), folder.path(), [&](const wear::WornPair&) { return influence; },
      [&](const wear::WornPair& pair) { states.push_back(pair); });
  return states;
}

SweepFile collective_of(const py::object& scene, const py::object& folder) {
  return parse_sweep_file(scene_of(scene, folder));
}

py::dict wear_under(const NoResult& scene, double depth, const py::object& model, const py::object& folder,
                    const py::object& executor, const py::kwargs& options) {
  const wear::StudyOptions asked = study_options(depth, options);
  const SweepFile sweep = collective_of(scene, folder);
  wear::Study study = wear::study_of(sweep, model_of(model), asked);
  if (!executor.is_none())
    study.options.solve = task::wear_by(engine_of(executor), sweep, model_of(model), asked);
  const States states =
      executor.is_none() ? stoppable([study](const std::atomic<bool>* stop) { return worn_by(study, stop); })
                         : worn_by(study, nullptr);
  std::vector<wear::WearRow> rows;
  for (const wear::WornPair& state : states)
    rows.push_back(
        wear::history_row(static_cast<int>(rows.size()), state, study.scene().position.wheel_radius));
  py::dict out;
  if (states.front().sections.empty())
    out["rail"] = points_of(states, [](const wear::WornPair& p) { return &p.rail.points; });
  else
    out["sections"] = sections_of(states);
  out["wheel"] = points_of(states, [](const wear::WornPair& p) { return &p.wheel.points; });
  out.attr("update")(columns_of(record::table_of("step", wear::wear_columns(), rows)));
  return out;
}

fatigue::FatigueProperties properties_of(double yield_shear, NumberList nodes, NumberList damage,
                                         const std::optional<std::string>& body) {
  return {.yield_shear = yield_shear,
          .damage = {.t_gamma = std::move(nodes), .damage = std::move(damage)},
          .body = body.value_or("")};
}

py::dict fatigue_of(const PythonResult& result, double yield_shear, NumberList nodes, NumberList damage,
                    bool stresses, const std::optional<std::string>& body) {
  const SceneResult& r = solved(result, "fatigue");
  fatigue::FatigueProperties properties =
      properties_of(yield_shear, std::move(nodes), std::move(damage), body);
  properties.stresses = stresses;
  const fatigue::Fatigue f = fatigue::fatigue_of(r, properties);
  return as_dict(record_of(f, r.problem.grid, properties));
}

py::dict fatigue_under(const NoResult& scene, double yield_shear, NumberList nodes, NumberList damage,
                       bool wear_is_negative, const py::object& folder,
                       const std::optional<std::string>& body) {
  fatigue::FatigueProperties properties =
      properties_of(yield_shear, std::move(nodes), std::move(damage), body);
  properties.damage.wear_is_negative = wear_is_negative;
  const fatigue::CollectiveFatigue found =
      stoppable([=, sweep = collective_of(scene, folder)](const std::atomic<bool>* stop) {
        return fatigue::fatigue_of(sweep, properties, stop);
      });
  return as_dict(record_of(found, properties));
}

} // namespace

void add_wear_functions(py::module_& module) {
  const wear::StudyOptions study;
  module.def(
      "wear", &wear_of, "result"_a, "law"_a = study.law, "hardness"_a = study.hardness,
      "speed"_a = study.speed, "map"_a = py::none(),
      "What a Result wears away: `rate` (depth per mm rolled, [ms][mx]), `depth` over `s` of the rail in a "
      "passage and over `wheel_s` of the wheel in a revolution (mm), `sliding_distance` (mm), "
      "`volume_per_distance` (mm3/mm); of a wheel on a rail also `wheel_depth_per_km`, `wheel_area_per_km`, "
      "`rail_depth_per_million_axles`, `rail_area_per_million_axles`, `rail_depth_per_mgt`, "
      "`rail_area_per_mgt` (mm, "
      "mm2), `axle_load` (t, of two such wheels) and `T_gamma` (N). `law`: energy (T-gamma) or archard, with "
      "`hardness` (MPa) and "
      "rolling `speed` (mm/s) and `map`: borders of sliding speed (mm/s), borders of pressure (MPa), and k "
      "as rows over pressure of columns over speed; None: the map of KTH Stockholm. Raises InputError for "
      "what does not roll steadily with friction.");
  module.def(
      "wear", &wear_under, "scene"_a, "depth"_a = study.depth, py::kw_only(), "model"_a = py::none(),
      "folder"_a = py::none(), "executor"_a = py::none(),
      "Lets both profiles of a scene wear under the load collective of its table [sweep] until the deepest "
      "place is `depth` (mm) deep, as `bem_contact wear` does. Arrays by step, the unworn state first: "
      "`revolutions`, `mileage` (km), `rail_depth`, `wheel_depth` (mm), `rail_area`, `wheel_area` (gone from "
      "the section, mm2), `smoothing` (mm) and `smoothed_off` (what that took of the deepest place, 1) of "
      "each "
      "step, and the profiles `rail`, `wheel` [step][point][y, z] (own frame, z down, mm). A rail of "
      "sections has instead of `rail` a list `sections`, one dict each: `at` (mm along the track), `body`, "
      "`depth` (mm), `area` (mm2) and `profile` [step][point][y, z]. "
      "More options, with the names and defaults of the command's: `law`, `hardness` (MPa), `speed` (mm/s), "
      "`body`: both, rail or wheel; `cap`, `smoothing` (mm), `passages`, `kept_turn` (rad). "
      "Nothing is kept on disk: a study that is to go on after it was stopped belongs to the "
      "command. Raises InputError where influence functions would have to be computed anew. `executor`: any "
      "of concurrent.futures, or with its methods, shares the cases of each step in chunks that start cold: "
      "the wear is the same within the certificate, and does not depend on how many share it.");
  const fatigue::FatigueProperties steel;
  module.def("fatigue", &fatigue_of, "result"_a, "yield_shear"_a = steel.yield_shear,
             "nodes"_a = steel.damage.t_gamma, "damage"_a = steel.damage.damage,
             "stresses"_a = steel.stresses, "body"_a = py::none(),
             "Rolling contact fatigue of a Result: `FI` of each element ([ms][mx]), `patches` with shakedown "
             "point, FI_surf, T_gamma (N) and damage of a passage, and the largest `von_mises` and `tresca` "
             "stress below the surface (MPa) with x, s and depth (mm). `yield_shear`: k, MPa. `body`: an "
             "influence file with stresses, or a body file (by mesh_body and fem_influence): stresses and "
             "shakedown limit below the surface are then those in that rail or wheel.");
  module.def("fatigue", &fatigue_under, "scene"_a, "yield_shear"_a = steel.yield_shear,
             "nodes"_a = steel.damage.t_gamma, "damage"_a = steel.damage.damage,
             "wear_is_negative"_a = steel.damage.wear_is_negative, "folder"_a = py::none(),
             "body"_a = py::none(),
             "The same of each case of a scene's table [sweep], as `bem_contact fatigue` has it: `cases`, "
             "`beyond_surface_limit` (patches), `beyond_limit_below` (others), `damage` (of one passage, "
             "mean over the collective), and `patches`, one dict for each patch of each case.");
}

} // namespace bem_contact
