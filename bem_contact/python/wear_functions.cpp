#include "bem_contact/base/error.hpp"
#include "bem_contact/base/temporary_folder.hpp"
#include "bem_contact/python/functions.hpp"
#include "bem_contact/python/result_object.hpp"
#include "bem_contact/python/stoppable.hpp"
#include "bem_contact/python/values.hpp"
#include "bem_contact/uses/fatigue/fatigue_of_result.hpp"
#include "bem_contact/uses/wear/evolution.hpp"
#include "bem_contact/uses/wear/wear_of_result.hpp"

#include <fmt/format.h>
#include <optional>
#include <pybind11/stl.h>
#include <tuple>
#include <vector>

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
  return py::dict("rate"_a = field(r, w.rate), "s"_a = array_of(w.rail.s), "wheel_s"_a = array_of(w.wheel.s),
                  "depth"_a = array_of(w.rail.depth), "sliding_distance"_a = array_of(w.sliding_over_s),
                  "volume_per_distance"_a = w.volume_per_distance);
}

using States = std::vector<wear::WornPair>; ///< by step, the unworn one first

States worn_by(const std::vector<wear::CollectiveCase>& cases, const wear::EvolutionOptions& options,
               double depth) {
  const TemporaryFolder folder; // of the profiles of the present step
  States states{wear::unworn(cases.front().scene)};
  wear::KeptPair influence;
  if (wear::needs_influence(cases.front().scene))
    influence = wear::unworn_influence(cases.front().scene, states.front());
  while (states.back().largest() < depth * (1 - 1e-9))
    states.push_back(wear::wear_step(states.back(), cases, options, depth, folder.path(), influence));
  return states;
}

py::array_t<double> points_of(const States& states, wear::WornBody wear::WornPair::*body) {
  py::array_t<double> out({states.size(), (states.front().*body).points.size(), std::size_t(2)});
  double* at = out.mutable_data();
  for (const wear::WornPair& state : states)
    for (const Point2& p : (state.*body).points)
      *at++ = p.y, *at++ = p.z;
  return out;
}

py::dict wear_under(const py::object& scene, double depth, const std::string& law, double hardness,
                    double speed, const std::string& body, double cap, double smoothing, double passages,
                    double kept_turn, const py::object& model, const py::object& folder) {
  const std::vector<wear::CollectiveCase> cases =
      wear::collective_of(parse_sweep_file(scene_of(scene, folder)), model_of(model));
  if (body != "both" && body != "rail" && body != "wheel")
    throw InputError(fmt::format("There is no body '{}'", body), "there are rail and wheel",
                     "Give both, rail or wheel.");
  const wear::EvolutionOptions options{
      .law = wear::law_named(law, hardness, speed, wear::wear_map_of(cases.front().scene)),
      .rail = body != "wheel",
      .wheel = body != "rail",
      .cap = cap,
      .smoothing = smoothing,
      .passages = passages,
      .kept_turn = kept_turn};
  wear::validate(cases, options, depth);
  const States states = stoppable([=](const std::atomic<bool>* stop) {
    wear::EvolutionOptions until_stopped = options;
    until_stopped.stop = stop;
    return worn_by(cases, until_stopped, depth);
  });
  py::dict out("rail"_a = points_of(states, &wear::WornPair::rail),
               "wheel"_a = points_of(states, &wear::WornPair::wheel));
  for (const wear::WearColumn& column : wear::wear_columns) {
    std::vector<double> values;
    for (std::size_t k = 0; k < states.size(); ++k)
      values.push_back(wear::history_row(int(k), states[k], cases.front().scene.position.wheel_radius).*
                       column.member);
    out[column.name] = array_of(values);
  }
  return out;
}

py::dict peak(const fatigue::StressPeak& p) {
  return py::dict("stress"_a = p.stress, "x"_a = p.x, "s"_a = p.s, "depth"_a = p.depth);
}

py::dict fatigue_of(const PythonResult& result, double yield_shear, double poisson, std::vector<double> nodes,
                    std::vector<double> damage, bool stresses) {
  const SceneResult& r = solved(result, "fatigue");
  const fatigue::Fatigue f =
      fatigue::fatigue_of(r, {.yield_shear = yield_shear,
                              .poisson = poisson,
                              .damage = {.t_gamma = std::move(nodes), .damage = std::move(damage)},
                              .stresses = stresses});
  py::list patches;
  for (const fatigue::PatchFatigue& p : f.patches) {
    py::dict patch;
    for (const fatigue::PatchColumn& column : fatigue::patch_columns())
      patch[column.name] = column.value(p);
    patches.append(patch);
  }
  py::dict out("FI"_a = field(r, f.element_index), "patches"_a = patches);
  if (f.peaks) {
    out["von_mises"] = peak(f.peaks->von_mises);
    out["tresca"] = peak(f.peaks->tresca);
  }
  return out;
}

} // namespace

void add_wear_functions(py::module_& module) {
  module.def(
      "wear", &wear_of, "result"_a, "law"_a = "energy", "hardness"_a = 3000.0, "speed"_a = 3e4,
      "map"_a = py::none(),
      "What a Result wears away: `rate` (depth per mm rolled, [ms][mx]), `depth` over `s` of the rail in a "
      "passage and over `wheel_s` of the wheel in a revolution (mm), `sliding_distance` (mm), "
      "`volume_per_distance` (mm^3/mm). `law`: energy (T-gamma) or archard, with `hardness` (MPa) and "
      "rolling `speed` (mm/s) and `map`: borders of sliding speed (mm/s), borders of pressure (MPa), and k "
      "as rows over pressure of columns over speed; None: the map of KTH Stockholm. Raises InputError for "
      "what does not roll steadily with friction.");
  const wear::EvolutionOptions usual;
  module.def(
      "wear", &wear_under, "scene"_a, "depth"_a = 0.1, py::kw_only(), "law"_a = "energy",
      "hardness"_a = 3000.0, "speed"_a = 3e4, "body"_a = "both", "cap"_a = usual.cap,
      "smoothing"_a = usual.smoothing, "passages"_a = usual.passages, "kept_turn"_a = usual.kept_turn,
      "model"_a = py::none(), "folder"_a = py::none(),
      "Lets both profiles of a scene wear under the load collective of its table [sweep] until the deepest "
      "place is `depth` (mm) deep, as `bem_contact wear` does. Arrays by step, the unworn state first: "
      "`revolutions`, `mileage` (km), `rail_depth`, `wheel_depth` (mm), `rail_area`, `wheel_area` (gone from "
      "the section, mm^2), and the profiles `rail`, `wheel` [step][point][y, z] (own frame, z down, mm). "
      "`body`: both, rail or wheel; `cap`, `smoothing` (mm), `passages`, `kept_turn` (rad): as the options "
      "of the command. Nothing is kept on disk: a study that is to go on after it was stopped belongs to the "
      "command. Raises InputError where influence functions would have to be computed anew.");
  const fatigue::DamageFunction defaults;
  module.def("fatigue", &fatigue_of, "result"_a, "yield_shear"_a = 300.0, "poisson"_a = 0.28,
             "nodes"_a = defaults.t_gamma, "damage"_a = defaults.damage, "stresses"_a = true,
             "Rolling contact fatigue of a Result: `FI` of each element ([ms][mx]), `patches` with shakedown "
             "point, FI_surf, T_gamma (N) and damage of a passage, and the largest `von_mises` and `tresca` "
             "stress below the surface (MPa) with x, s and depth (mm). `yield_shear`: k, MPa.");
}

} // namespace bem_contact
