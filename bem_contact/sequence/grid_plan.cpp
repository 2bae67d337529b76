#include "bem_contact/sequence/potential_contact.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace bem_contact {

namespace {

using Slice = ContactEstimate::Slice;

/// The nearest slice of the rows asked for, where the estimate has the contact on others: it may lie far from
/// there along x as well.
const Slice* nearest_if_elsewhere(const ContactEstimate& estimate, const std::vector<PotentialArea>& areas,
                                  const SceneFile::RowRange& rows) {
  if (std::ranges::any_of(
          areas, [&](const PotentialArea& area) { return area.s_from <= rows.to && rows.from <= area.s_to; }))
    return nullptr;
  const Slice* nearest = nullptr;
  for (const Slice& slice : estimate.slices)
    if (rows.from <= slice.s && slice.s <= rows.to && (!nearest || slice.gap < nearest->gap))
      nearest = &slice;
  return nearest;
}

} // namespace

GridPlan plan_grid(const ContactEstimate& estimate, const SceneFile::Grid& grid, double origin) {
  GridPlan plan{origin, 0, grid.ms.value_or(0), grid.mx.value_or(0), grid.dx, grid.ds};
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
  if (grid.rows) {
    from = grid.rows->from + 0.5 * grid.ds, to = grid.rows->to - 0.5 * grid.ds;
    if (const Slice* nearest = nearest_if_elsewhere(estimate, areas, *grid.rows)) {
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
    plan.first = row_of(from) - (grid.rows ? 0 : 2);
    plan.rows = std::max(row_of(to) + (grid.rows ? 0 : 2) - plan.first + 1, 3);
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

std::vector<ContactRow> rail_rows(const WheelOnRail& pair, const GridPlan& plan) {
  if (plan.s_from() < pair.rail.s_begin() || plan.s_to() > pair.rail.s_end())
    throw InputError("The potential contact leaves the rail's profile",
                     fmt::format("rows need s = {:.7g} .. {:.7g} mm and '{}' spans {:.7g} .. {:.7g} mm",
                                 plan.s_from(), plan.s_to(), pair.rail.name(), pair.rail.s_begin(),
                                 pair.rail.s_end()),
                     "Change position.lateral, grid.s_from and grid.s_to, or give a longer profile.");
  std::vector<ContactRow> rows;
  for (int i = 0; i < plan.rows; ++i) {
    const CurvePoint p = pair.rail_at(plan.s(i));
    rows.push_back({p.s, p.position, p.delta});
  }
  return rows;
}

std::vector<ContactRow> planar_rows(const WheelOnRail& pair, const GridPlan& plan,
                                    const ReferencePoint& reference) {
  const Point2 tangent = tangent_of(reference.delta);
  std::vector<ContactRow> rows;
  for (int i = 0; i < plan.rows; ++i) {
    // Along the tangent the rail's points grow with s as long as it turns by less than a right angle.
    const double wanted = plan.s(i) - reference.s;
    const auto excess = [&](double s) {
      return dot(pair.rail_at(s).position - reference.position, tangent) - wanted;
    };
    double lo = reference.s, hi = reference.s;
    const double step = wanted < 0 ? -0.5 : 0.5;
    for (double& s = wanted < 0 ? lo : hi; excess(s) * step < 0; s += step)
      if (s + step < pair.rail.s_begin() || s + step > pair.rail.s_end() ||
          std::cos(pair.rail_at(s + step).delta - reference.delta) <= 0)
        throw InputError(
            "The potential contact does not fit on a plane",
            fmt::format("the rail turns away from the plane at s = {:.2f} mm before it gets {:.2f} mm "
                        "along it",
                        s, wanted),
            "Leave out grid.planar.");
    for (int n = 0; n < 60; ++n) {
      const double mid = 0.5 * (lo + hi);
      (excess(mid) < 0 ? lo : hi) = mid;
    }
    rows.push_back({plan.s(i), pair.rail_at(hi).position, reference.delta});
  }
  return rows;
}

} // namespace bem_contact
