#include "bem_contact/sequence/plan/plan_grid.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/sequence/plan/settings.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace bem_contact {

namespace {

/// 1. Most rows or columns of a grid, as grid.mx and grid.ms have it.
constexpr int most_rows = 4096;

/// The nearest slice of the rows asked for, where the estimate has the contact on others: it may lie far from
/// there along x as well.
const RailSlice* nearest_if_elsewhere(const ContactEstimate& estimate,
                                      const std::vector<PotentialArea>& areas,
                                      const SceneFile::RowRange& rows) {
  if (std::ranges::any_of(
          areas, [&](const PotentialArea& area) { return area.s_from <= rows.to && rows.from <= area.s_to; }))
    return nullptr;
  const RailSlice* nearest = nullptr;
  for (const RailSlice& slice : estimate.slices)
    if (rows.from <= slice.s && slice.s <= rows.to && (!nearest || slice.gap < nearest->gap))
      nearest = &slice;
  return nearest;
}

/// What a plan has to cover: the middles of its first and last row, and x.
PotentialArea wanted(const ContactEstimate& estimate, const SceneFile::Grid& asked) {
  const std::vector<PotentialArea> areas = potential_areas(estimate);
  PotentialArea all;
  if (!areas.empty()) {
    all = {areas.front().s_from, areas.back().s_to,
           std::ranges::min(areas, {}, &PotentialArea::x_from).x_from,
           std::ranges::max(areas, {}, &PotentialArea::x_to).x_to};
  } else if (!estimate.slices.empty()) {
    const RailSlice& nearest = *std::ranges::min_element(estimate.slices, {}, &RailSlice::gap);
    all = {nearest.s, nearest.s, nearest.x, nearest.x};
  }
  if (asked.rows) {
    all.s_from = asked.rows->from + 0.5 * asked.ds, all.s_to = asked.rows->to - 0.5 * asked.ds;
    if (const RailSlice* nearest = nearest_if_elsewhere(estimate, areas, *asked.rows)) {
      const double shift = nearest->x - 0.5 * (all.x_from + all.x_to);
      all.x_from += shift, all.x_to += shift;
    }
  }
  return all;
}

void require_not_too_many(const GridPlan& plan, const PotentialArea& all) {
  const double spare = 2 * (spare_elements + 1); // on both sides, with what rounding adds
  const double columns = (all.x_to - all.x_from) / plan.dx + spare,
               rows = (all.s_to - all.s_from) / plan.ds + spare;
  if ((plan.columns == 0 && columns > most_rows) || (plan.rows == 0 && rows > most_rows))
    throw InputError("The elements are too small for this contact",
                     fmt::format("it would need about {:.3g} columns and {:.3g} rows, {} are allowed",
                                 columns, rows, most_rows),
                     "Give larger elements (grid.dx, grid.ds), or fewer rows (grid.s_from, grid.s_to).");
}

/// x of the deepest point among the rows that are covered. Columns are centred there, so that tractions do
/// not jump as a yawing wheel carries its contact along x by parts of an element.
double deepest_x(const ContactEstimate& estimate, const PotentialArea& all) {
  const RailSlice* deepest = nullptr;
  for (const RailSlice& slice : estimate.slices)
    if (all.s_from <= slice.s && slice.s <= all.s_to && (!deepest || slice.gap < deepest->gap))
      deepest = &slice;
  return deepest ? deepest->x : 0.0;
}

int row_of(const GridPlan& plan, double s) {
  return static_cast<int>(std::lround((s - plan.origin) / plan.ds));
}

/// An even number of columns that reach so far on either side.
int columns_for(const GridPlan& plan, double reach) {
  return 2 * (static_cast<int>(std::ceil(reach / plan.dx)) + spare_elements);
}

} // namespace

GridPlan plan_grid(const ContactEstimate& estimate, const SceneFile::Grid& asked, double origin) {
  GridPlan plan{origin, 0, asked.ms.value_or(0), asked.mx.value_or(0), asked.dx, asked.ds};
  const PotentialArea all = wanted(estimate, asked);
  require_not_too_many(plan, all);
  if (plan.rows == 0) {
    const int spare = asked.rows ? 0 : spare_elements;
    plan.first = row_of(plan, all.s_from) - spare;
    plan.rows = std::max(row_of(plan, all.s_to) + spare - plan.first + 1, int(fewest_rows));
  } else {
    plan.first = row_of(plan, 0.5 * (all.s_from + all.s_to)) - plan.rows / 2;
  }
  if (plan.columns == 0)
    plan.columns = columns_for(plan, 0.5 * (all.x_to - all.x_from));
  const double deepest = deepest_x(estimate, all), middle = 0.5 * (all.x_from + all.x_to);
  plan.x_centre = deepest + plan.dx * std::round((middle - deepest) / plan.dx);
  return plan;
}

void cover(GridPlan& plan, const PotentialArea& area) {
  const int first = std::min(plan.first, row_of(plan, area.s_from) - spare_elements);
  const int last = std::max(plan.first + plan.rows - 1, row_of(plan, area.s_to) + spare_elements);
  plan.first = first;
  plan.rows = last - first + 1;
  const int columns = columns_for(plan, std::max(area.x_to - plan.x_centre, plan.x_centre - area.x_from));
  plan.columns += std::max(0, 2 * ((columns - plan.columns + 1) / 2));
}

} // namespace bem_contact
