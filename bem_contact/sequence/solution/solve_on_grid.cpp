#include "bem_contact/sequence/solution/solve_on_grid.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/progress.hpp"
#include "bem_contact/base/stopwatch.hpp"
#include "bem_contact/contact/solve.hpp"
#include "bem_contact/sequence/models.hpp"
#include "bem_contact/sequence/solution/layer_slope.hpp"
#include "bem_contact/sequence/solution/numbers_of_grid.hpp"
#include "bem_contact/sequence/solution/second_solution.hpp"
#include "bem_contact/sequence/solution/structural_motion.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace bem_contact {

namespace {

/// GB. Largest influence numbers, and largest history, that are kept in memory.
constexpr double largest_memory = 8.0;
/// 1. Memory of a whole solution over that of its table of influence numbers, where they depend on both rows:
/// numbers of either body, of the pair, and spectra. 2.3 was measured of influence files.
constexpr double memory_by_rows = 4.0;
/// 1. The same of half-spaces, whose table is small: 144 bytes an element. 1.2 to 2 kB an element were
/// measured in all, the most of unlike materials.
constexpr double memory_by_distance = 16.0;
/// 1. From so many steps of a history on, progress is reported.
constexpr int many_steps = 1000;

/// What a solution takes beside its table of influence numbers is in proportion to it: numbers of each body,
/// spectra, fields.
void require_memory(Model model, const ContactOnGrid& contact) {
  const ContactProblem& problem = contact.problem;
  const ContactGrid& grid = problem.grid;
  const bool by_distance = !depends_on_both_rows(model) && !contact.layer.by_row();
  InfluenceNumbers table;
  table.offsets = problem.plane_strain() ? 1 : grid.mx + 2;
  table.rows = grid.ms;
  table.translational = by_distance;
  const double gigabytes = 1e-9 * sizeof(double) * double(table.expected_values()) *
                           (by_distance ? memory_by_distance : memory_by_rows);
  if (gigabytes > largest_memory)
    throw InputError(
        fmt::format("A grid of {} x {} elements is too large", grid.mx, grid.ms),
        fmt::format("its influence numbers and what is made of them need about {:.0f} GB, {:g} "
                    "GB are allowed",
                    gigabytes, largest_memory),
        fmt::format("Use larger elements or fewer of them{}.", by_distance ? "" : ", above all along s"));
}

/// The fields of every step are kept: tractions, slip, distance, states.
void require_memory(const ContactGrid& grid, std::size_t steps) {
  const double gigabytes = 1e-9 * (6 * sizeof(double) + 1) * double(grid.size()) * double(steps);
  if (gigabytes > largest_memory)
    throw InputError(
        fmt::format("A history of {} steps on {} x {} elements is too large", steps, grid.mx, grid.ms),
        fmt::format("the fields of all steps need about {:.0f} GB, {:g} GB are allowed", gigabytes,
                    largest_memory),
        "Take fewer steps (rolling is steady after about two lengths of contact), or elements.");
}

bool gives_way(const ContactSetup& setup) {
  return setup.rail.structural == StructuralCompliance::included ||
         setup.wheel.structural == StructuralCompliance::included;
}

SolverOptions options_of(const ContactCase& asked, const SolveTask& task, const SolveResources& resources) {
  return {.tolerance = asked.scene.solver.tolerance,
          .max_outer = asked.scene.solver.max_outer,
          .estimate_discretisation = !task.normal_only && !resources.totals_only,
          // A warning looks at how far surfaces slide where the bodies' structures give way.
          .displacements = !task.normal_only &&
                           (is_placed_by_contact(asked.scene) ||
                            ((resources.displacements || gives_way(asked.setup)) && !resources.totals_only)),
          .coarse_start = resources.coarse_start,
          .early_end = resources.early_end,
          .workspace = resources.operators};
}

/// Every step of a transient or of shifts; each has a work budget of its own. `problem` has its influence
/// numbers; it leaves with what the last step prescribes.
void solve_steps(const ContactSetup& setup, const SolverOptions& options, ContactProblem& problem,
                 GridSolution& out) {
  const std::vector<MotionStep>& steps = setup.motion.steps;
  require_memory(problem.grid, steps.size());
  std::optional<Progress> progress;
  if (steps.size() >= static_cast<std::size_t>(many_steps))
    progress.emplace("steps", steps.size());
  const auto prescribe = [&](int k, ContactProblem& p) {
    if (progress && k > 0)
      progress->step();
    setup.prescribe(steps[k], p);
  };
  const int last = static_cast<int>(steps.size()) - 1;
  out.history = solve_history(problem, last + 1, prescribe, options);
  if (progress) {
    progress->step();
    progress->finish();
  }
  out.result = out.history.back();
  setup.prescribe(steps[last], problem);
  for (int k = 0; k < last; ++k)
    if (!out.history[k].certified())
      out.warnings.add(WarningKind::uncertified_step,
                       fmt::format("step {} of {} is not a solution ({})", k + 1, last + 1,
                                   out.history[k].trust.solver_note));
}

void solve_by_numbers(const ContactCase& asked, const SolveTask& task, const SolveResources& resources,
                      GridSolution& out) {
  ContactProblem problem = out.contact.problem;
  require_memory(task.model, out.contact);
  const Stopwatch numbers;
  NumbersOfGrid pair(asked, task.model, out.contact, resources);
  problem.numbers = pair.take(out.numbers);
  out.seconds.numbers = numbers.seconds();
  const Stopwatch solving;
  SolverOptions options = options_of(asked, task, resources);
  if (asked.setup.layer.slope && !task.normal_only)
    out.contact.layer.shear = {
        compliance_of_slope(problem, *asked.setup.layer.slope, options, resources.work)};
  std::optional<LayerInNumbers> layer(std::in_place, out.contact.layer, problem.numbers);
  std::optional<StartingPoint> start;
  if (resources.start && asked.estimate) {
    start = start_from(*resources.start, problem, potential_areas(*asked.estimate), problem.force);
    options.start = &*start;
  }
  if (task.normal_only) {
    problem.tangential = false;
    out.result = solve(problem, options, resources.work);
  } else if (!problem.tangential || problem.motion == MotionKind::steady) {
    out.result = solve(problem, options, resources.work);
    if (const std::string other =
            resources.totals_only ? "" : second_solution(problem, out.result, options, resources.work);
        !other.empty())
      out.warnings.add(WarningKind::second_solution, other);
  } else {
    solve_steps(asked.setup, options, problem, out);
    asked.setup.prescribe(asked.setup.motion.steps.back(), out.contact.problem);
  }
  const auto add = [&](const ContactResult& result) {
    out.seconds.check += result.effort.check_seconds;
    out.seconds.estimate += result.effort.estimate_seconds;
  };
  if (out.history.empty())
    add(out.result);
  std::ranges::for_each(out.history, add);
  out.seconds.solve = solving.seconds() - out.seconds.check - out.seconds.estimate;
  layer.reset();
  pair.keep(std::move(problem.numbers), out.numbers);
}

} // namespace

GridSolution solve_on_grid(const ContactCase& asked, ContactOnGrid contact, const SolveTask& task,
                           const SolveResources& resources) {
  GridSolution out;
  out.model = task.model;
  out.contact = std::move(contact);
  if (const auto closed_form = elasticity_model(task.model).solve)
    out.result = closed_form(asked.setup, out.contact.problem);
  else
    solve_by_numbers(asked, task, resources, out);
  return out;
}

std::optional<Measured> free_creepage_of(const ContactCase& asked, GridSolution& solved,
                                         const SolveResources& resources) {
  const ContactResult& result = solved.result;
  ContactSetup setup = asked.setup;
  setup.motion.force_x = 0;
  if (!asked.scene.motion.pitch_rate) // a wheel that hardly turns has no spin, and near free rolling it has
    setup.motion.creepage.xi = 0;
  ContactProblem problem = solved.contact.problem;
  setup.prescribe({}, problem);
  double creepage = 0, elements = 0;
  for (int i = 0; i < problem.grid.size(); ++i)
    if (result.pn[i] > 0) {
      creepage += solved.contact.problem.slip_x[i] - problem.slip_x[i];
      ++elements;
    }
  creepage = creepage / elements + result.totals.creepage_x;
  NumbersOfGrid pair(asked, solved.model, solved.contact, resources);
  problem.numbers = pair.take(solved.numbers);
  std::optional<LayerInNumbers> layer(std::in_place, solved.contact.layer, problem.numbers);
  WorkBudget work = resources.work.another(); // it must not end the case that is asked for
  std::optional<Measured> found;
  try {
    found = free_creepage(problem, result, creepage,
                          {.tolerance = asked.scene.solver.tolerance,
                           .max_outer = asked.scene.solver.max_outer,
                           .estimate_discretisation = !resources.totals_only,
                           .workspace = resources.operators},
                          work);
  } catch (const Error&) { // free rolling is not what was asked for
  }
  layer.reset();
  pair.keep(std::move(problem.numbers), solved.numbers);
  const bool stated = result.trust.discretisation && result.trust.discretisation->converges;
  if (stated && found && !std::isfinite(found->error)) // a precise solution may have an error
    found.reset();
  return found;
}

} // namespace bem_contact
