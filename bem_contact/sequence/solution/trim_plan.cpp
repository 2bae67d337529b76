#include "bem_contact/sequence/solution/trim_plan.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/contact/solve.hpp"
#include "bem_contact/sequence/models.hpp"
#include "bem_contact/sequence/plan/plan_grid.hpp"
#include "bem_contact/sequence/plan/settings.hpp"
#include "bem_contact/sequence/solution/settings.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace bem_contact {

namespace {

/// Where a solution by the same model of the same potential contact, on the same elements, ended within the
/// plan.
std::optional<GridPlan> plan_of_former(const ContactCase& asked, const GridPlan& plan, Model model,
                                       const FormerSolution* former) {
  if (!former || former->model != model || former->grid.dx != plan.dx || former->grid.ds != plan.ds ||
      former->areas != potential_areas(*asked.estimate))
    return std::nullopt;
  GridPlan out = plan;
  out.first = static_cast<int>(std::lround((former->first_s - plan.origin) / plan.ds));
  out.rows = former->grid.ms;
  out.columns = former->grid.mx;
  out.cropped = true;
  const bool within = out.first >= plan.first && out.first + out.rows <= plan.first + plan.rows &&
                      out.columns <= plan.columns;
  return within ? std::optional(out) : std::nullopt;
}

/// Without the outer rows that leave the strips of the influence files.
GridPlan within_strips(const ContactCase& asked, GridPlan plan) {
  const auto [first, last] = rows_on_strips(asked, plan);
  plan.first += first;
  plan.rows = last - first + 1;
  return plan;
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
      approach = std::max(approach, patch.overlap.value);
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
  // One joined element more on each side, for what the rough solution is off by: one and a half from the
  // middle of the last that touches.
  const int beyond = 3 * trim_factor / 2;
  const int end = plan.first + plan.rows;
  if (first > 0)
    plan.first = std::clamp((rough.first + first) * trim_factor - beyond, plan.first, end);
  if (last < grid.ms - 1)
    plan.rows = std::clamp((rough.first + last) * trim_factor + beyond + 1, plan.first, end) - plan.first;
  else
    plan.rows = end - plan.first;
  const double columns = 2 * std::ceil(reach / plan.dx + beyond);
  plan.columns = std::min(plan.columns, static_cast<int>(columns));
  return plan;
}

/// Elements that a plan needs beside the contact of a former solution, for what may have changed since.
int margin_beside(const FormerSolution& former, const std::vector<PotentialArea>& areas,
                  const GridPlan& plan) {
  const auto near = [&](const PotentialArea& a, const PotentialArea& b) {
    return std::max(std::abs(a.s_from - b.s_from), std::abs(a.s_to - b.s_to)) < plan.ds &&
           std::max(std::abs(a.x_from - b.x_from), std::abs(a.x_to - b.x_to)) < plan.dx;
  };
  const bool a_step =
      former.grid.dx == plan.dx && former.grid.ds == plan.ds && std::ranges::equal(former.areas, areas, near);
  return a_step ? cropped_margin_of_steps : cropped_margin;
}

/// Whether the scene leaves it open which rows and columns are solved.
bool is_open(const ContactCase& asked) {
  const SceneFile::Grid& grid = asked.scene.grid;
  return asked.estimate && !grid.rows && !grid.ms && !grid.mx;
}

/// Whether influence numbers with the layer depend on both rows.
bool depends_on_both_rows(const ContactCase& asked, Model model) {
  return depends_on_both_rows(model) || asked.setup.layer.by_row();
}

/// Larger where a contact is expected beyond the plan; as far as the strips reach. `former`: the elements by
/// whose middles it is expected.
GridPlan widened(const ContactCase& asked, GridPlan plan, Model model, const PotentialArea& expected,
                 const ContactGrid& former) {
  const int rows = plan.rows;
  const double half_x = 0.5 * former.dx, half_s = 0.5 * former.ds;
  cover(plan,
        {expected.s_from - half_s, expected.s_to + half_s, expected.x_from - half_x, expected.x_to + half_x});
  return has_files(model) && plan.rows > rows ? within_strips(asked, plan) : plan;
}

} // namespace

GridPlan rough_plan(const ContactCase& asked, const GridPlan& plan, int factor, bool on_strips) {
  GridPlan rough = plan;
  rough.dx *= factor;
  rough.ds *= factor;
  const auto row = [factor](double fine) { return static_cast<int>(std::lround(fine / factor)); };
  rough.first = row(plan.first);
  rough.rows = row(plan.first + plan.rows - 1) - rough.first + 1;
  rough.columns = 2 * ((plan.columns + 2 * factor - 1) / (2 * factor));
  return on_strips ? within_strips(asked, rough) : rough;
}

bool has_large_numbers(const ContactCase& asked, const GridPlan& plan, Model model) {
  const double megabytes = 9e-6 * sizeof(double) * plan.rows * plan.rows * (plan.columns + 2.0);
  return is_open(asked) && depends_on_both_rows(asked, model) && megabytes >= large_numbers;
}

GridPlan fitted(const ContactCase& asked, GridPlan plan, Model model, const FormerSolution* former) {
  if (!former || !is_open(asked))
    return plan;
  const std::vector<PotentialArea> areas = potential_areas(*asked.estimate);
  const PotentialArea expected = expected_contact(*former, areas);
  plan = widened(asked, plan, model, expected, former->grid);
  if (!depends_on_both_rows(asked, model))
    return plan;
  if (const auto known = plan_of_former(asked, plan, model, former))
    return *known;
  const int margin = margin_beside(*former, areas, plan);
  const auto row = [&](double s) { return (s - plan.s(0)) / plan.ds; };
  const int rows = plan.rows;
  const int lowest = std::clamp(static_cast<int>(std::floor(row(expected.s_from))), 0, rows - 1),
            highest = std::clamp(static_cast<int>(std::ceil(row(expected.s_to))), lowest, rows - 1);
  // The estimate joins pairs of rows and of columns. They stay the same pairs, so that errors that it states
  // do not depend on what is left out.
  const int first_pair = first_joined_row(rows, lowest, highest);
  const auto whole_pairs = [&](int more) { return std::max(more - first_pair, 0) / 2 * 2; };
  const int first = first_pair + whole_pairs(lowest - margin),
            end = std::min(first_pair + whole_pairs(highest + margin + 2), rows);
  plan.first += first;
  plan.rows = end - first;
  const double reach = std::max(expected.x_to - plan.x_centre, plan.x_centre - expected.x_from);
  const int needed = static_cast<int>(std::ceil(reach / plan.dx)) + margin,
            spare = std::max(plan.columns / 2 - needed, 0) / 2 * 2; // on each side
  plan.columns -= 2 * spare;
  plan.cropped = true;
  return plan;
}

TrimmedPlan trimmed(const ContactCase& asked, const GridPlan& plan, const SolveTask& task,
                    const SolveResources& resources, bool on_strips) {
  if (const auto known = plan_of_former(asked, plan, task.model, resources.start))
    return {*known, {}};
  const GridPlan rough = rough_plan(asked, plan, trim_factor, on_strips);
  if (rough.rows < fewest_rows)
    return {plan, {}};
  WorkBudget work = resources.work.another();
  SolveResources tools = resources.with(work, resources.start);
  tools.totals_only = true;
  try {
    const GridSolution solved = solve_on_grid(asked, asked.setup.on(rough), task, tools);
    const bool serves = solved.result.certified() && !solved.result.patches.empty();
    return {serves ? without_far_elements(plan, solved) : plan, solved.seconds};
  } catch (const Error&) { // the plan itself says what is wrong
    return {plan, {}};
  }
}

} // namespace bem_contact
