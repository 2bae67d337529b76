#include "bem_contact/base/error.hpp"
#include "bem_contact/python/functions.hpp"
#include "bem_contact/python/record_object.hpp"
#include "bem_contact/python/result_object.hpp"
#include "bem_contact/uses/shakedown/shakedown_of_result.hpp"

#include <optional>
#include <pybind11/stl.h>

namespace bem_contact {

namespace {

namespace py = pybind11;
using namespace py::literals;

py::dict shakedown_of_result(const PythonResult& result, double yield_shear, double dang_van_a,
                             std::optional<double> alpha, bool in_plane) {
  if (!result.solved)
    throw InputError("shakedown needs a result that was solved here",
                     "one that was pickled holds only its properties", "Solve the scene again.");
  const shakedown::ShakedownProperties properties{
      yield_shear, in_plane ? shakedown::Residual::in_plane : shakedown::Residual::all, dang_van_a, alpha};
  return as_dict(record_of(shakedown::shakedown_of(*result.solved, properties), properties));
}

} // namespace

void add_shakedown(py::module_& module) {
  const shakedown::ShakedownProperties steel;
  module.def(
      "shakedown", &shakedown_of_result, "result"_a, "yield_shear"_a = steel.yield_shear,
      "dang_van_a"_a = steel.dang_van_a, "alpha"_a = py::none(), "in_plane"_a = false,
      "Whether the steel below each patch of a Result yields never, once or for ever while it passes again "
      "and again: "
      "`patches` with the load factors `first_yield`, `shakedown` (lower bound) and `shakedown_upper`, with "
      "`dang_van` and `crossland` (MPa), and where each is decided (s, depth; mm); `sections` by number of "
      "the patch, "
      "with maps [s][depth] of the same and of the residual stresses. `yield_shear`: k, MPa; `alpha`: "
      "Crossland's, by "
      "default that of a steel with this Dang Van's a; `in_plane`: without residual shear along the track.");
}

} // namespace bem_contact
