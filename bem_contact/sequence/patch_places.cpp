#include "bem_contact/sequence/patch_places.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bem_contact {

namespace {

/// A place between the points of an array: the one before, the one after, and how far it is to the latter.
struct Between {
  std::size_t below = 0, above = 0;
  double share = 0;

  Between(double index, std::size_t size)
      : below(static_cast<std::size_t>(std::clamp(index, 0.0, static_cast<double>(size) - 1))),
        above(std::min(below + 1, size - 1)), share(index - static_cast<double>(below)) {}

  template <class Of> double of(const Of& value) const {
    return (1 - share) * value(below) + share * value(above);
  }
  /// The difference to the neighbour on the other side where there is one, over the number of steps.
  template <class Of> double slope(const Of& value, std::size_t size) const {
    const std::size_t from = above > below || below == 0 ? below : below - 1;
    const std::size_t to = std::min(from + 1, size - 1);
    return to > from ? value(to) - value(from) : PatchPlace::none;
  }
};

double mean_of_known(double a, double b) {
  return std::isnan(a) ? b : std::isnan(b) ? a : 0.5 * (a + b);
}

/// The rigid slip of a body that moves is linear in x and turns at the same rate both ways; of a table the
/// rotation is half of its curl.
void add_creepages(const ContactProblem& problem, const ContactResult& result, const PatchSummary& patch,
                   PatchPlace& place) {
  const ContactGrid& grid = problem.grid;
  if (!problem.tangential || problem.slip_x.empty())
    return;
  const auto columns = static_cast<std::size_t>(grid.mx), rows = static_cast<std::size_t>(grid.ms);
  const Between column(std::clamp((patch.x - grid.x0) / grid.dx, 0.0, double(grid.mx - 1)), columns);
  const Between row(row_index(problem, patch.s), rows);
  const auto on_row = [&](const std::vector<double>& field, std::size_t is) {
    return column.of([&](std::size_t ix) { return field[is * columns + ix]; });
  };
  const auto slip_x = [&](std::size_t is) { return on_row(problem.slip_x, is); };
  const auto slip_s = [&](std::size_t is) { return on_row(problem.slip_s, is); };
  place.xi = row.of(slip_x) + result.totals.creepage_x;
  place.eta = row.of(slip_s) + result.totals.creepage_s * std::cos(patch.delta - problem.reference_delta);
  const double along_x = row.of([&](std::size_t is) {
    return column.slope([&](std::size_t ix) { return problem.slip_s[is * columns + ix]; }, columns);
  });
  place.phi = mean_of_known(along_x / grid.dx, -row.slope(slip_x, rows) / grid.ds);
}

void add_position(const WheelRailGeometry& placed, const ContactOnGrid& contact, const PatchSummary& patch,
                  PatchPlace& place) {
  const Between row(row_index(contact.problem, patch.s), contact.problem.rows.size());
  const auto station = [&](const std::vector<double>& s, const TabulatedProfile& profile) {
    return std::clamp(row.of([&](std::size_t is) { return s[is]; }), profile.s_begin(), profile.s_end());
  };
  const WheelOnRail& pair = placed.pair;
  const Point2 rail = pair.rail.at(station(contact.rail_s, pair.rail)).position;
  const CurvePoint wheel = pair.wheel.at(station(contact.wheel_s, pair.wheel));
  place.rail_y = rail.y;
  place.rail_z = rail.z;
  place.wheel_s = wheel.s;
  place.wheel_y = wheel.position.y;
  place.wheel_z = wheel.position.z;
  place.wheel_delta = wheel.delta - std::numbers::pi; // a wheel's profile is walked the other way
  if (pair.sections && pair.sections->bodies() > 1)
    place.body = 1 + pair.sections->body_of({station(contact.rail_s, pair.rail), {}, 0});
}

} // namespace

std::vector<PatchPlace> patch_places(const ContactSetup& setup, const ContactOnGrid& contact,
                                     const ContactResult& result) {
  std::vector<PatchPlace> places;
  for (const PatchSummary& patch : result.patches) {
    PatchPlace& place = places.emplace_back();
    add_creepages(contact.problem, result, patch, place);
    if (setup.wheel_rail())
      add_position(*setup.wheel_rail(), contact, patch, place);
  }
  return places;
}

} // namespace bem_contact
