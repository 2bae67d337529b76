#include "bem_contact/base/error.hpp"
#include "bem_contact/fatigue/fatigue_of_result.hpp"
#include "bem_contact/python/functions.hpp"
#include "bem_contact/python/result_object.hpp"
#include "bem_contact/python/values.hpp"
#include "bem_contact/wear/wear_of_result.hpp"

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
      "What a Result wears away: `rate` (depth per mm rolled, [ms][mx]), `depth` over `s` of the rail in "
      "a passage and over `wheel_s` of the wheel in a revolution (mm), `sliding_distance` (mm), "
      "`volume_per_distance` (mm^3/mm). `law`: energy (T-gamma) or archard, with `hardness` (MPa) and "
      "rolling `speed` (mm/s) and `map`: borders of sliding speed (mm/s), borders of pressure (MPa), and k "
      "as "
      "rows over pressure of columns over speed; None: the map of KTH Stockholm. Raises InputError for what "
      "does not roll steadily with friction.");
  const fatigue::DamageFunction defaults;
  module.def("fatigue", &fatigue_of, "result"_a, "yield_shear"_a = 300.0, "poisson"_a = 0.28,
             "nodes"_a = defaults.t_gamma, "damage"_a = defaults.damage, "stresses"_a = true,
             "Rolling contact fatigue of a Result: `FI` of each element ([ms][mx]), `patches` with shakedown "
             "point, FI_surf, T_gamma (N) and damage of a passage, and the largest `von_mises` and `tresca` "
             "stress below the surface (MPa) with x, s and depth (mm). `yield_shear`: k, MPa.");
}

} // namespace bem_contact
