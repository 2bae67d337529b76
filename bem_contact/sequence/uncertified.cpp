#include "bem_contact/sequence/uncertified.hpp"

#include "bem_contact/contact/settings.hpp"

#include <cmath>
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

std::string why_not_convergent(const ContactResult& result) {
  const double pmax = result.totals.pmax, coarse = result.trust.discretisation->coarse.pmax;
  if (result.trust.discretisation->rough)
    return "the distance of the surfaces is rough from one element to the next";
  if (std::abs(pmax - coarse) > contact::largest_pmax_change * pmax)
    return fmt::format("pmax {:.5g} MPa, {:.5g} MPa on elements twice as large", pmax, coarse);
  return fmt::format("its peak, {:.5g} MPa, is narrower than three elements", pmax);
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
