#include "bem_contact/base/error.hpp"
#include "bem_contact/python/functions.hpp"
#include "bem_contact/python/record_object.hpp"
#include "bem_contact/python/result_object.hpp"
#include "bem_contact/uses/shakedown/shakedown_in_body.hpp"

#include <optional>
#include <pybind11/stl.h>

namespace bem_contact {

namespace {

namespace py = pybind11;
using namespace py::literals;

py::dict shakedown_of_result(const PythonResult& result, std::optional<double> yield_shear,
                             std::optional<double> dang_van_a, std::optional<double> alpha, bool in_plane,
                             const std::string& steel, const std::optional<std::string>& initial_stress,
                             const std::optional<std::string>& body) {
  if (!result.solved)
    throw InputError("shakedown needs a result that was solved here",
                     "one that was pickled holds only its properties", "Solve the scene again.");
  shakedown::ShakedownProperties properties =
      steel.empty() ? shakedown::ShakedownProperties{} : shakedown::properties_of(steel);
  properties.yield_shear = yield_shear.value_or(properties.yield_shear);
  properties.dang_van_a = dang_van_a.value_or(properties.dang_van_a);
  properties.alpha = alpha;
  properties.residual = in_plane ? shakedown::Residual::in_plane : shakedown::Residual::all;
  if (initial_stress)
    properties.initial = shakedown::read_initial_stress(*initial_stress);
  const auto found = [&] {
    return body ? shakedown::shakedown_in_body({&*result.solved, 1}, *body, properties).front()
                : shakedown::shakedown_of(*result.solved, properties);
  };
  return as_dict(record_of(found(), properties));
}

} // namespace

void add_shakedown(py::module_& module) {
  module.def(
      "shakedown", &shakedown_of_result, "result"_a, "yield_shear"_a = py::none(),
      "dang_van_a"_a = py::none(), "alpha"_a = py::none(), "in_plane"_a = false, "steel"_a = "",
      "initial_stress"_a = py::none(), "body"_a = py::none(),
      "Whether the steel below each patch of a Result yields never, once or for ever while it passes again "
      "and again: "
      "`patches` with the load factors `first_yield`, `shakedown` (lower bound) and `shakedown_upper`, with "
      "`dang_van` and `crossland` (MPa), and where each is decided (s, depth; mm); `sections` by number of "
      "the patch, "
      "with maps [s][depth] of the same and of the residual stresses. `yield_shear`: k, MPa, by default 300; "
      "`steel`: such as R260 or ER7, "
      "whose fatigue limit, a and k are then taken; `alpha`: "
      "Crossland's, by "
      "default that of a steel with this Dang Van's a; `in_plane`: without residual shear along the track; "
      "`initial_stress`: a CSV file with residual and thermal stress of the body (depth, perhaps s, mm; any "
      "of "
      "xx, ss, nn, xs, xn, sn, MPa), which first yield and fatigue feel; `body`: an influence file with "
      "stresses, or a body file (by mesh_body and fem_influence), to take the stresses inside that rail or "
      "wheel and not those of a half-space.");
}

} // namespace bem_contact
