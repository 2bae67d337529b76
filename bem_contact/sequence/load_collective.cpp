#include "bem_contact/sequence/load_collective.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/scene/derivative_inputs.hpp"
#include "bem_contact/scene/sweep_file.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "bem_contact/sequence/uncertified.hpp"

#include <fmt/format.h>

namespace bem_contact {

SceneResult solve_of_collective(Sequence& sequence, const SweepFile& sweep, std::size_t index,
                                const std::atomic<bool>* stop) {
  const SceneFile scene = sweep.scene(index);
  refuse_derivatives(scene, "a load collective");
  SceneResult result = sequence.solve(scene, stop);
  if (!certified(result))
    throw ConvergenceError(fmt::format("Case {} has no certified result", index),
                           fmt::format("{}{}{}", sweep.describe(index),
                                       sweep.describe(index).empty() ? "" : ": ", why_not_certified(result)),
                           "Correct it, or leave it out.");
  return result;
}

double place_of_case(const SweepFile& sweep, std::size_t index) {
  return sweep.scene(index).position.uneven.along;
}

} // namespace bem_contact
