#include "bem_contact/geometry/rail_rows.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/geometry/settings.hpp"

#include <boost/math/tools/roots.hpp>
#include <fmt/format.h>

namespace bem_contact {

std::vector<ContactRow> rail_rows(const WheelOnRail& pair, std::span<const double> s, double half_width) {
  const double from = s.front() - half_width, to = s.back() + half_width;
  if (from < pair.rail.s_begin() || to > pair.rail.s_end())
    throw InputError("The potential contact leaves the rail's profile",
                     fmt::format("rows need s = {:.7g} .. {:.7g} mm and '{}' spans {:.7g} .. {:.7g} mm", from,
                                 to, pair.rail.name(), pair.rail.s_begin(), pair.rail.s_end()),
                     "Change position.lateral, grid.s_from and grid.s_to, or give a longer profile.");
  std::vector<ContactRow> rows;
  for (const double at : s) {
    const CurvePoint p = pair.rail_at(at);
    rows.push_back({p.s, p.position, p.delta});
  }
  return rows;
}

namespace {

/// The point of the rail at `row` in the plane that touches it at `reference`.
ContactRow planar_row(const WheelOnRail& pair, double row, const ReferencePoint& reference) {
  const Point2 tangent = tangent_of(reference.delta);
  // Along the tangent the rail's points grow with s as long as it turns by less than a right angle.
  const double wanted = row - reference.s;
  const auto excess = [&](double at) {
    return dot(pair.rail_at(at).position - reference.position, tangent) - wanted;
  };
  double lo = reference.s, hi = reference.s;
  const double step = wanted < 0 ? -planar_step : planar_step;
  for (double& at = wanted < 0 ? lo : hi; excess(at) * step < 0; at += step)
    if (at + step < pair.rail.s_begin() || at + step > pair.rail.s_end() ||
        std::cos(pair.rail_at(at + step).delta - reference.delta) <= 0)
      throw InputError(
          "The potential contact does not fit on a plane",
          fmt::format("the rail turns away from the plane at s = {:.2f} mm before it gets {:.2f} mm "
                      "along it",
                      at, wanted),
          "Leave out grid.planar.");
  const auto close = boost::math::tools::eps_tolerance<double>();
  const double found = lo < hi ? boost::math::tools::bisect(excess, lo, hi, close).second : lo;
  return {row, pair.rail_at(found).position, reference.delta};
}

} // namespace

std::vector<ContactRow> planar_rows(const WheelOnRail& pair, std::span<const double> s,
                                    std::span<const TangentPlane> planes) {
  std::vector<ContactRow> rows;
  auto plane = planes.begin();
  for (const double row : s) {
    while (row > plane->s_to && plane + 1 != planes.end())
      ++plane;
    rows.push_back(planar_row(pair, row, plane->at));
  }
  return rows;
}

} // namespace bem_contact
