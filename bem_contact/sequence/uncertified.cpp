#include "bem_contact/sequence/uncertified.hpp"

#include <fmt/format.h>

namespace bem_contact {

std::string why_not_certified(const SceneResult& result) {
  if (certified(result))
    return "";
  const std::vector<ContactResult>& steps = result.history;
  const auto failed = std::ranges::find(steps, false, &ContactResult::certified);
  const bool of_history = failed != steps.end();
  const ContactResult& first = of_history ? *failed : result.result;
  std::string out =
      of_history ? fmt::format("step {} of {} is not a solution: ", failed - steps.begin() + 1, steps.size())
                 : "";
  out += fmt::format("its worst violation is {:.1e}, {:.0e} is allowed", first.trust.certificate.worst(),
                     first.trust.certificate.tolerance);
  return first.trust.solver_note.empty() ? out : out + "; " + first.trust.solver_note;
}

ConvergenceError uncertified_error(const SceneResult& result) {
  return {fmt::format("The {} result is not a solution", name_of(result.choice.model)),
          why_not_certified(result),
          result.problem.kinetic < 1
              ? "Friction that drops at once lets forces jump: give motion.falling_friction in place of "
                "motion.kinetic_friction (rolling), or other elements."
              : "Coarsen the grid, lower solver.tolerance, or raise solver.max_outer."};
}

void require_certified(const SceneResult& result) {
  if (!certified(result))
    throw uncertified_error(result);
}

} // namespace bem_contact
