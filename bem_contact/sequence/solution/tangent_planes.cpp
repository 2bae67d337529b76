#include "bem_contact/sequence/solution/tangent_planes.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/stopwatch.hpp"
#include "bem_contact/sequence/models.hpp"
#include "bem_contact/sequence/solution/grow_grid.hpp"
#include "bem_contact/sequence/solution/settings.hpp"
#include "bem_contact/sequence/solution/trim_plan.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <optional>

namespace bem_contact {

namespace {

/// A patch on planes, and where its centre of pressure lies on the rail.
struct PatchOnPlanes {
  ReferencePoint centre;       ///< tangent to the rail
  double s_from = 0, s_to = 0; ///< middles of its first and last row, mm
  double turn = 0;             ///< of its rows from the rail's tangent there, at most, rad
  double share = 0;            ///< of the sum of normal forces of all patches
};

std::vector<PatchOnPlanes> patches_on_planes(const ContactCase& asked, const ContactProblem& problem,
                                             const ContactResult& result) {
  const WheelOnRail& pair = asked.setup.wheel_rail()->pair;
  const std::vector<std::vector<int>> elements = patch_elements(problem, result);
  double pressed = 0;
  for (const PatchSummary& patch : result.patches)
    pressed += patch.fn;
  std::vector<PatchOnPlanes> out;
  for (std::size_t k = 0; k < elements.size(); ++k) {
    const PatchSummary& patch = result.patches[k];
    const CurvePoint at = pair.rail_at(pair.rail.nearest(pair.rail_pose.to_section(patch.position)).s);
    const auto [first, last] = std::ranges::minmax_element(elements[k]);
    const ContactRow &from = problem.rows[*first / problem.grid.mx],
                     &to = problem.rows[*last / problem.grid.mx];
    out.push_back({{at.position, at.s, at.delta, patch.x},
                   from.s,
                   to.s,
                   std::max(std::abs(at.delta - from.delta), std::abs(at.delta - to.delta)),
                   patch.fn / pressed});
  }
  return out;
}

/// Whether this patch's plane serves.
bool is_tangent(const PatchOnPlanes& patch) {
  return patch.turn * patch.share <= plane_turn_of_force &&
         (patch.turn <= largest_plane_turn || patch.share <= negligible_patch);
}

/// A plane for each patch; and those former ones on which none lies: one may lie there again.
std::vector<TangentPlane> moved_planes(std::vector<PatchOnPlanes> patches,
                                       const std::vector<TangentPlane>& former) {
  double from = -std::numeric_limits<double>::infinity();
  std::vector<PatchOnPlanes> unused;
  for (const TangentPlane& plane : former) {
    const auto touches = [&](const PatchOnPlanes& patch) {
      const bool rows = patch.s_from <= plane.s_to && patch.s_to > from;
      return rows || (patch.s_from <= plane.at.s && plane.at.s <= patch.s_to);
    };
    if (std::ranges::none_of(patches, touches))
      unused.push_back({plane.at, plane.at.s, plane.at.s});
    from = plane.s_to;
  }
  patches.insert(patches.end(), unused.begin(), unused.end());
  std::ranges::sort(patches, {}, &PatchOnPlanes::s_from);
  std::vector<TangentPlane> out;
  for (std::size_t k = 0; k < patches.size(); ++k) {
    out.push_back({patches[k].centre});
    if (k + 1 < patches.size())
      out.back().s_to = 0.5 * (patches[k].s_to + patches[k + 1].s_from);
  }
  return out;
}

/// Throws InputError for a step whose patches lie on planes of another inclination.
void require_tangent(const ContactCase& asked, const ContactProblem& problem, const ContactResult& result) {
  for (const PatchOnPlanes& patch : patches_on_planes(asked, problem, result))
    if (patch.turn > largest_plane_turn && patch.share > negligible_patch)
      throw InputError(
          "No plane touches the rail where it bears the wheel",
          fmt::format("the plane of the patch at s = {:.2f} mm is inclined by {:.3f} rad against the "
                      "rail, at most {:g} are taken",
                      patch.centre.s, patch.turn, double(largest_plane_turn)),
          "Leave out grid.planar.");
}

bool is_solution(const ContactResult& result) {
  return result.certified() && !result.patches.empty();
}

/// Where planes come to rest by the pressure alone.
struct RestingPlanes {
  std::vector<TangentPlane> planes;
  bool moved = false;                  ///< from where the plan has them: else they serve
  std::optional<FormerSolution> start; ///< the pressure, if it was solved on the plan's own elements
  PhaseSeconds seconds;
};

/// A solution costs many times as much as its pressure, which alone says where planes lie. `plan` may have
/// many elements: as few as serve are joined. Where a pressure is not found, the planes are those before it.
RestingPlanes planes_by_pressure(const ContactCase& asked, const GridPlan& plan, Model model,
                                 const SolveResources& resources, bool on_strips) {
  int factor = trim_factor;
  while (factor > 1 && plan.rows * plan.columns < fewest_for_planes * factor * factor)
    factor /= 2;
  GridPlan rough = factor > 1 ? rough_plan(asked, plan, factor, on_strips) : plan;
  RestingPlanes out{plan.planes, false, {}, {}};
  for (int round = 0; round < most_plane_moves; ++round) {
    WorkBudget work = resources.work.another();
    SolveResources tools = resources.with(work, out.start ? &*out.start : resources.start);
    tools.totals_only = true;
    GridSolution solved;
    try {
      solved = solve_on_growing_grid(asked, asked.setup.on(rough), {model, true}, tools, on_strips);
    } catch (const Error&) { // the solution itself says what is wrong
      return out;
    }
    out.seconds += solved.seconds;
    if (!is_solution(solved.result))
      return out;
    if (factor == 1)
      out.start = former_of(model, solved.contact.problem, solved.result, *asked.estimate);
    std::vector<PatchOnPlanes> patches = patches_on_planes(asked, solved.contact.problem, solved.result);
    if (std::ranges::all_of(patches, is_tangent))
      return out;
    rough = std::move(solved.contact.plan);
    out.planes = rough.planes = moved_planes(std::move(patches), rough.planes);
    out.moved = true;
  }
  return out;
}

} // namespace

GridSolution solve_on_tangent_planes(const ContactCase& asked, ContactOnGrid first, const SolveTask& task,
                                     const SolveResources& resources, bool on_strips) {
  if (first.plan.planes.empty())
    return solve_on_growing_grid(asked, std::move(first), task, resources, on_strips);
  RestingPlanes found;
  if (!task.normal_only && !is_closed_form(task.model))
    found = planes_by_pressure(asked, first.plan, task.model, resources, on_strips);
  if (found.moved) {
    first.plan.planes = found.planes;
    first = asked.setup.on(first.plan);
  }
  SolveResources tools = resources;
  if (found.start)
    tools.start = &*found.start;
  GridSolution out = solve_on_growing_grid(asked, std::move(first), task, tools, on_strips);
  out.seconds += found.seconds;
  for (int round = 0; round < most_plane_moves && is_solution(out.result); ++round) {
    std::vector<PatchOnPlanes> patches = patches_on_planes(asked, out.contact.problem, out.result);
    if (std::ranges::all_of(patches, is_tangent))
      break;
    const Stopwatch geometry;
    GridPlan plan = out.contact.plan;
    plan.planes = moved_planes(std::move(patches), plan.planes);
    ContactOnGrid contact = asked.setup.on(plan);
    PhaseSeconds spent = out.seconds;
    spent.geometry += geometry.seconds();
    const auto former = former_of(out.model, out.contact.problem, out.result, *asked.estimate);
    WorkBudget work = resources.work.another();
    out = solve_on_growing_grid(asked, std::move(contact), task,
                                resources.with(work, former ? &*former : nullptr), on_strips);
    out.seconds += spent;
  }
  for (const ContactResult& step : out.history)
    if (is_solution(step))
      require_tangent(asked, out.contact.problem, step);
  if (is_solution(out.result))
    require_tangent(asked, out.contact.problem, out.result);
  return out;
}

} // namespace bem_contact
