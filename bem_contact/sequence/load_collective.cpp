#include "bem_contact/sequence/load_collective.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/scene/sweep_file.hpp"
#include "bem_contact/sequence/sequence.hpp"

#include <fmt/format.h>

namespace bem_contact {

SceneResult solve_of_collective(Sequence& sequence, const SweepFile& sweep, std::size_t index,
                                const std::atomic<bool>* stop) {
  SceneResult result = sequence.solve(sweep.scene(index), stop);
  if (!certified(result))
    throw ConvergenceError(fmt::format("Case {} has no certified result", index), sweep.describe(index),
                           "Solve it alone to see why.");
  return result;
}

} // namespace bem_contact
