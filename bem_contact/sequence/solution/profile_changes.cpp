#include "bem_contact/sequence/solution/profile_changes.hpp"

#include <algorithm>
#include <utility>

namespace bem_contact {

namespace {

/// mm. As other lengths of derivative_inputs.cpp.
constexpr double point_step = 1e-5;
/// Points on both sides of an element. A spline forgets a point by a factor of 3.7 from each to the next one,
/// so that farther ones change it by less than 1e-7 of their own motion.
constexpr std::size_t spline_reach = 12;

/// Whether each point is near enough to rows in contact, which have these stations on the profile.
std::vector<char> near_contact(const std::vector<CurvePoint>& points, const std::vector<double>& stations,
                               const std::vector<char>& touches) {
  std::vector<char> out(points.size(), 0);
  for (std::size_t row = 0; row < stations.size(); ++row) {
    if (!touches[row])
      continue;
    const auto after =
        std::size_t(std::ranges::upper_bound(points, stations[row], {}, &CurvePoint::s) - points.begin());
    const std::size_t from = after > spline_reach ? after - spline_reach : 0,
                      to = std::min(after + spline_reach, points.size());
    std::fill(out.begin() + std::ptrdiff_t(from), out.begin() + std::ptrdiff_t(to), 1);
  }
  return out;
}

std::vector<char> rows_that_touch(const GridSolution& solved) {
  const ContactGrid& grid = solved.contact.problem.grid;
  std::vector<char> out(std::size_t(grid.ms), 0);
  for (int i = 0; i < grid.size(); ++i)
    if (solved.result.pn[std::size_t(i)] > 0)
      out[std::size_t(i / grid.mx)] = 1;
  return out;
}

} // namespace

ProfileChanges::ProfileChanges(const ContactCase& asked, const GridSolution& solved)
    : asked_(asked), contact_(solved.contact) {
  const WheelRailGeometry* placed = asked.setup.wheel_rail();
  const std::vector<char> touches = rows_that_touch(solved);
  for (const std::string& name : profile_inputs(asked.scene)) {
    const bool rail = name == rail_profile_input;
    const std::vector<ContactRow>& rows = contact_.problem.rows;
    Body& body = bodies_.emplace_back(
        Body{name, rail, MovablePoints((rail ? placed->pair.rail : placed->pair.wheel).curve())});
    const std::vector<char> near = near_contact(
        body.points.points(), rail ? placed->rail_stations(rows) : placed->wheel_stations(rows), touches);
    for (std::size_t point = 0; point < near.size(); ++point)
      if (near[point])
        moves_.push_back({bodies_.size() - 1, point});
  }
}

ChangedContact ProfileChanges::changed(std::size_t which) const {
  const Move& move = moves_[which];
  const Body& body = bodies_[move.body];
  const WheelRailGeometry& placed = *asked_.setup.wheel_rail();
  const auto set_up = [&](double distance) {
    const TabulatedProfile profile = body.points.moved(move.point, distance);
    ContactCase out = asked_;
    out.setup =
        set_up_contact(asked_.scene, {body.rail ? profile : placed.pair.rail,
                                      body.rail ? placed.pair.wheel : profile, placed.rail_inclination});
    return out;
  };
  ChangedContact out{set_up(-point_step), set_up(point_step), {}, {}, point_step};
  out.lower = out.lower_case.setup.on(contact_.plan);
  out.upper = out.upper_case.setup.on(contact_.plan);
  return out;
}

std::vector<ProfileDerivatives> ProfileChanges::sorted(std::vector<InputDerivatives> found) const {
  std::vector<ProfileDerivatives> out;
  for (const Body& body : bodies_) {
    ProfileDerivatives& profile = out.emplace_back(ProfileDerivatives{body.name, body.points.points(), {}});
    InputDerivatives none;
    none.totals.assign(derived_totals().size(), 0.0);
    profile.by_point.assign(profile.points.size(), none);
  }
  for (std::size_t k = 0; k < found.size(); ++k)
    out[moves_[k].body].by_point[moves_[k].point] = std::move(found[k]);
  return out;
}

} // namespace bem_contact
