#include "bem_contact/sequence/trim_plan.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/sequence/settings.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace bem_contact {

namespace {

bool is_large(const ContactCase& asked, const GridPlan& plan, Model model) {
  const SceneFile::Grid& grid = asked.scene.grid;
  const bool free_extent = asked.setup.wheel_rail() && !grid.rows && !grid.ms && !grid.mx;
  const bool by_both_rows = model == Model::fem || model == Model::tangent_plane;
  const double megabytes = 9 * sizeof(double) * 1e-6 * plan.rows * plan.rows * (plan.columns + 2.0);
  return free_extent && by_both_rows && megabytes >= large_numbers;
}

/// A solution of the same potential contact on the same elements has shown already what it needs.
std::optional<GridPlan> plan_of_former(const ContactCase& asked, GridPlan plan, const FormerSolution* start) {
  if (!start || start->grid.dx != plan.dx || start->grid.ds != plan.ds || !asked.estimate ||
      start->areas != potential_areas(*asked.estimate))
    return std::nullopt;
  plan.first = static_cast<int>(std::lround((start->first_s - plan.origin) / plan.ds));
  plan.rows = start->grid.ms;
  plan.columns = start->grid.mx;
  return plan;
}

/// The elements of a plan that are joined trim_factor by trim_factor; as far as the strips reach.
GridPlan rough_plan(const ContactCase& asked, const GridPlan& plan, bool on_strips) {
  GridPlan rough = plan;
  rough.dx *= trim_factor;
  rough.ds *= trim_factor;
  const auto row = [](double fine) { return static_cast<int>(std::lround(fine / trim_factor)); };
  rough.first = row(plan.first);
  rough.rows = row(plan.first + plan.rows - 1) - rough.first + 1;
  rough.columns = 2 * ((plan.columns + 2 * trim_factor - 1) / (2 * trim_factor));
  if (on_strips) {
    const auto [first, last] = rows_on_strips(asked, rough);
    rough.first += first;
    rough.rows = last - first + 1;
  }
  return rough;
}

/// Without the outer rows and columns of `solved`, joined elements of the plan, where the bodies do not come
/// near to touching. Sides on which they do stay as they are.
GridPlan without_far_elements(GridPlan plan, const GridSolution& solved) {
  const GridPlan& rough = solved.contact.plan;
  const ContactGrid grid = rough.grid();
  int first = grid.ms, last = -1;
  double reach = 0;
  const auto look = [&](const ContactResult& result) {
    double approach = 0;
    for (const PatchSummary& patch : result.patches)
      approach = std::max(approach, patch.approach);
    for (int i = 0; i < grid.size(); ++i)
      if (result.state[i] != ElementState::exterior ||
          result.deformed_distance[i] < near_distance * approach) {
        first = std::min(first, i / grid.mx);
        last = std::max(last, i / grid.mx);
        reach = std::max(reach, std::abs(grid.x(i % grid.mx) - rough.x_centre));
      }
  };
  look(solved.result);
  std::ranges::for_each(solved.history, look);
  // One joined element more: the half of one that touches, and half of one for what it is off by.
  const int end = plan.first + plan.rows;
  const int from = (rough.first + first - 1) * trim_factor, to = (rough.first + last + 1) * trim_factor + 1;
  if (first > 0)
    plan.first = std::clamp(from, plan.first, end);
  plan.rows = (last < grid.ms - 1 ? std::clamp(to, plan.first, end) : end) - plan.first;
  plan.columns = std::min(plan.columns, 2 * static_cast<int>(std::ceil((reach + rough.dx) / plan.dx)));
  return plan;
}

} // namespace

TrimmedPlan trimmed(const ContactCase& asked, const GridPlan& plan, const SolveTask& task,
                    const SolveResources& resources, bool on_strips) {
  if (!is_large(asked, plan, task.model))
    return {plan, {}};
  if (const auto known = plan_of_former(asked, plan, resources.start))
    return {*known, {}};
  const GridPlan rough = rough_plan(asked, plan, on_strips);
  WorkBudget work = resources.work.another();
  try {
    const GridSolution solved = solve_on_grid(asked, asked.setup.on(rough), task,
                                              {.work = work,
                                               .numbers = resources.numbers,
                                               .operators = resources.operators,
                                               .start = resources.start,
                                               .coarse_start = resources.coarse_start,
                                               .totals_only = true,
                                               .threads = resources.threads});
    const bool serves = solved.result.converged && !solved.result.patches.empty();
    return {serves ? without_far_elements(plan, solved) : plan, solved.seconds};
  } catch (const Error&) { // the plan itself says what is wrong
    return {plan, {}};
  }
}

} // namespace bem_contact
