#include "bem_contact/sequence/solution/free_rolling.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/stopwatch.hpp"
#include "bem_contact/sequence/models.hpp"
#include "bem_contact/sequence/result_warnings.hpp"

namespace bem_contact {

namespace {

bool has_free_rolling(const ContactCase& asked) {
  const SceneFile::Motion& motion = asked.scene.motion;
  return asked.setup.wheel_rail() && asked.setup.motion.tangential && motion.kind == MotionKind::steady &&
         (motion.free_rolling || motion.from_free_rolling);
}

/// Of a solution without longitudinal force.
FreeRolling free_rolling_of(const SceneResult& solved) {
  const SceneMotion& motion = solved.motion;
  return {{motion.xi, solved.result.totals.creepage_x.error},
          motion.rolling.radius_at(motion.xi),
          motion.contact_radius,
          motion.rolling.radius};
}

/// The same with the creepage counted as that of `result` is: placed bodies may have another rolling radius.
FreeRolling counted_as(const SceneResult& result, FreeRolling free) {
  free.xi.value = result.motion.rolling.xi_at(free.rolling_radius);
  free.zero_radius = result.motion.rolling.radius;
  return free;
}

/// The case with load.force_x = 0. Nothing where it is not found.
std::optional<FreeRolling> find_free_rolling(ContactCase asked, const SceneFile::Grid& grid,
                                             SolveResources resources, SceneResult* solution = nullptr) {
  asked.setup.motion.force_x = 0;
  resources.early_end = nullptr;
  resources.derivatives = false;
  asked.scene.stresses.depths.clear();
  SceneResult solved = solve_case(asked, grid, resources);
  if (!solved.result.certified() || solved.result.patches.empty())
    return std::nullopt;
  const FreeRolling out = free_rolling_of(solved);
  if (solution)
    *solution = std::move(solved);
  return out;
}

SceneResult solve_from_free_rolling(const ContactCase& asked, const SceneFile::Grid& grid,
                                    SolveResources resources) {
  ContactCase counted = asked;
  counted.setup.motion.creepage.xi = 0;
  SceneResult free;
  const Stopwatch finding;
  const std::optional<FreeRolling> found = find_free_rolling(counted, grid, resources, &free);
  const double seconds = finding.seconds();
  if (!found)
    throw ConvergenceError(
        "The creepage of free rolling was not found",
        "no certified solution without longitudinal force came out",
        "Count the creepage from motion.rolling_radius (motion.from_free_rolling = false).");
  counted = beyond_free_rolling(std::move(counted), *found, asked.setup.motion.creepage.xi);
  counted.scene.solver.model = free.choice.model;
  const std::optional<FormerSolution> start =
      former_of(free.choice.model, free.problem, free.result, *asked.estimate);
  resources.start = start ? &*start : resources.start;
  SceneResult out = solve_case(counted, grid, resources);
  take_choice(free.choice, out);
  out.motion.free_rolling = counted_as(out, *found);
  out.seconds.free_rolling = seconds;
  return out;
}

} // namespace

ContactCase beyond_free_rolling(ContactCase asked, const FreeRolling& free, double creepage) {
  Creepage& motion = asked.setup.motion.creepage;
  motion.xi = 0;
  if (!asked.scene.motion.pitch_rate) // that of free.xi, wherever the bodies are placed
    asked.scene.motion.rolling_radius = motion.rolling_radius = free.zero_radius;
  motion.slip_x = (free.xi + creepage) * free.contact_radius / motion.rolling_radius;
  asked.setup.motion.force_x.reset();
  return asked;
}

SceneResult solve_with_free_rolling(const ContactCase& asked, const SceneFile::Grid& grid,
                                    const SolveResources& resources) {
  if (!has_free_rolling(asked))
    return solve_case(asked, grid, resources);
  if (asked.scene.motion.from_free_rolling)
    return solve_from_free_rolling(asked, grid, resources);
  SolveResources tools = resources;
  tools.free_rolling = true;
  SceneResult out = solve_case(asked, grid, tools);
  if (out.motion.free_rolling || is_closed_form(out.choice.model) || !out.result.certified() ||
      out.result.patches.empty())
    return out;
  if (resources.early_end && resources.early_end->ends(out.problem, out.result)) // on smaller elements then
    return out;
  if (asked.setup.motion.force_x == 0.0) {
    out.motion.free_rolling = free_rolling_of(out);
    return out;
  }
  const Stopwatch finding;
  ContactCase free = asked;
  free.scene.solver.model = out.choice.model;
  if (!asked.scene.motion.pitch_rate) // a wheel that hardly turns has no spin, and near free rolling it has
    free.setup.motion.creepage.xi = 0;
  const std::optional<FormerSolution> start =
      former_of(out.choice.model, out.problem, out.result, *asked.estimate);
  WorkBudget work = resources.work.another(); // it must not end the case that is asked for
  try {
    if (const auto found = find_free_rolling(free, grid, resources.with(work, start ? &*start : nullptr)))
      out.motion.free_rolling = counted_as(out, *found);
  } catch (const ConvergenceError&) { // free rolling is not what was asked for
  }
  out.seconds.free_rolling += finding.seconds();
  return out;
}

} // namespace bem_contact
