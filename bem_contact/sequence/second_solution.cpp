#include "bem_contact/sequence/second_solution.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/sequence/settings.hpp"

#include <cmath>
#include <fmt/format.h>

namespace bem_contact {

namespace {

/// Where all slides in one direction the force is mu(w) N. If that falls below the force found, it equals it
/// at one slip velocity.
std::string larger_creepage(const ContactProblem& problem, const ContactResult& result) {
  if (problem.falling.size() != 1 || problem.friction_falls_with_heat())
    return "";
  const FallingFriction& law = problem.falling.front();
  const double used =
      std::hypot(problem.force_x.value_or(0), problem.force_s.value_or(0)) / friction_bound(problem, result);
  if (used <= law.ratio)
    return "";
  const double velocity = -law.scale * std::log((used - law.ratio) / (1 - law.ratio));
  return fmt::format("friction falls with the slip velocity, and two creepages give the shear force: the "
                     "smaller one was taken "
                     "({:.3g} along x, {:.3g} along s); sliding as a whole at some {:.3g} (slip velocity "
                     "{:.3g} mm/s) carries it "
                     "too. Give a creepage (motion.xi, eta) to choose.",
                     result.creepage_x, result.creepage_s, velocity / problem.speed, velocity);
}

std::string forces_text(const ContactResult& result) {
  const ElementCounts count = count_elements(result);
  return fmt::format("Fx {:.1f} N, Fs {:.1f} N, {} of {} elements in adhesion", result.Fx, result.Fs,
                     count.adhesion, count.contact);
}

} // namespace

std::string second_solution(const ContactProblem& problem, const ContactResult& result, SolverOptions options,
                            WorkBudget& work) {
  if (!problem.has_friction() || !problem.friction_varies() || problem.motion != MotionKind::steady ||
      !result.converged)
    return "";
  if (problem.force_x || problem.force_s)
    return larger_creepage(problem, result);
  options.from_sliding = true;
  options.estimate_discretisation = options.displacements = false;
  try {
    const ContactResult other = solve(problem, options, work);
    const double change = std::hypot(other.Fx - result.Fx, other.Fs - result.Fs);
    if (!other.converged || change <= least_branch_difference * friction_bound(problem, result))
      return "";
    return fmt::format(
        "friction falls so steeply that this contact has two solutions: taken is the one that comes "
        "from adhesion ({}); from sliding comes {}. Which one occurs depends on what was before.",
        forces_text(result), forces_text(other));
  } catch (const Error&) { // no such solution, or no work left to look for it
    return "";
  }
}

} // namespace bem_contact
