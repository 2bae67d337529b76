#include "bem_contact/sequence/potential_contact.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace bem_contact {

namespace {

using Slice = RailSlice;

/// The nearest slice of the rows asked for, where the estimate has the contact on others: it may lie far from
/// there along x as well.
const Slice* nearest_if_elsewhere(const ContactEstimate& estimate, const std::vector<PotentialArea>& areas,
                                  const SceneFile::Grid& grid) {
  if (std::ranges::any_of(areas, [&](const PotentialArea& area) {
        return area.s_from <= grid.s_to && grid.s_from <= area.s_to;
      }))
    return nullptr;
  const Slice* nearest = nullptr;
  for (const Slice& slice : estimate.slices)
    if (grid.s_from <= slice.s && slice.s <= grid.s_to && (!nearest || slice.gap < nearest->gap))
      nearest = &slice;
  return nearest;
}

} // namespace

GridPlan plan_grid(const ContactEstimate& estimate, const SceneFile::Grid& grid, double origin) {
  GridPlan plan{origin, 0, grid.ms, grid.mx, grid.dx, grid.ds};
  const std::vector<PotentialArea> areas = potential_areas(estimate);
  double from = 0, to = 0, x_from = 0, x_to = 0;
  if (!areas.empty()) {
    from = areas.front().s_from;
    to = areas.back().s_to;
    x_from = std::ranges::min(areas, {}, &PotentialArea::x_from).x_from;
    x_to = std::ranges::max(areas, {}, &PotentialArea::x_to).x_to;
  } else if (!estimate.slices.empty()) {
    const Slice& nearest = *std::ranges::min_element(estimate.slices, {}, &Slice::gap);
    from = to = nearest.s, x_from = x_to = nearest.x;
  }
  if (grid.s_from != 0 || grid.s_to != 0) {
    from = grid.s_from + 0.5 * grid.ds, to = grid.s_to - 0.5 * grid.ds;
    if (const Slice* nearest = nearest_if_elsewhere(estimate, areas, grid)) {
      const double shift = nearest->x - 0.5 * (x_from + x_to);
      x_from += shift, x_to += shift;
    }
  }

  constexpr double most = 4096; // of the scene file
  const double columns = (x_to - x_from) / grid.dx + 6, rows = (to - from) / grid.ds + 5;
  if ((plan.columns == 0 && columns > most) || (plan.rows == 0 && rows > most))
    throw InputError("The elements are too small for this contact",
                     fmt::format("it would need about {:.3g} columns and {:.3g} rows, {:g} are allowed",
                                 columns, rows, most),
                     "Give larger elements (grid.dx, grid.ds), or fewer rows (grid.s_from, grid.s_to).");
  const auto row_of = [&](double s) { return static_cast<int>(std::lround((s - origin) / grid.ds)); };
  if (plan.rows == 0) {
    plan.first = row_of(from) - (grid.s_from == grid.s_to ? 2 : 0);
    plan.rows = std::max(row_of(to) + (grid.s_from == grid.s_to ? 2 : 0) - plan.first + 1, 3);
  } else {
    plan.first = row_of(0.5 * (from + to)) - plan.rows / 2;
  }
  if (plan.columns == 0)
    plan.columns = 2 * (static_cast<int>(std::ceil(0.5 * (x_to - x_from) / grid.dx)) + 2);
  plan.x_centre = grid.dx * std::round(0.5 * (x_from + x_to) / grid.dx);
  return plan;
}

void cover(GridPlan& plan, const PotentialArea& area) {
  const auto row_of = [&](double s) { return static_cast<int>(std::lround((s - plan.origin) / plan.ds)); };
  const int first = std::min(plan.first, row_of(area.s_from) - 2);
  const int last = std::max(plan.first + plan.rows - 1, row_of(area.s_to) + 2);
  plan.first = first;
  plan.rows = last - first + 1;
  const double reach = std::max(area.x_to - plan.x_centre, plan.x_centre - area.x_from);
  const int columns = 2 * (static_cast<int>(std::ceil(reach / plan.dx)) + 2);
  plan.columns += std::max(0, 2 * ((columns - plan.columns + 1) / 2));
}

} // namespace bem_contact
