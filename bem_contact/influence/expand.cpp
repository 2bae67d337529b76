#include "bem_contact/influence/expand.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/influence/expand_kernel.hpp"
#include "bem_contact/influence/expand_table.hpp"
#include "bem_contact/influence/requirements.hpp"
#include "bem_contact/influence/settings.hpp"

#include <cmath>
#include <string>

namespace bem_contact {
namespace {

StationRange checked_range(const InfluenceFunction& f, const ExpandOptions& o) {
  const auto total = static_cast<int>(f.station_count());
  const int count = o.stations < 0 ? total - o.first_station : o.stations;
  if (o.first_station < 0 || count < 1 || o.first_station > total - count)
    throw InputError("stations were asked for that the influence functions of '" + f.body + "' do not have",
                     std::to_string(count) + " from number " + std::to_string(o.first_station) + " on, of " +
                         std::to_string(total),
                     "Ask for stations on the strip.");
  return {o.first_station, count};
}

Scaling checked_scaling(const InfluenceFunction& f, const ExpandOptions& o) {
  if (!(std::isfinite(o.dx) && o.dx >= 0) || o.offsets < 1)
    throw InputError("influence numbers cannot be expanded",
                     "dx = " + std::to_string(o.dx) + " mm, " + std::to_string(o.offsets) + " offsets",
                     "Give dx >= 0 and at least one offset.");
  if (!(std::isfinite(o.contact_radius) && o.contact_radius >= 0))
    throw InputError("influence numbers cannot be expanded",
                     "contact radius " + std::to_string(o.contact_radius) + " mm", "Give a radius above 0.");
  Scaling scaling{o.dx, 1};
  if (f.invariance == Invariance::revolution && o.contact_radius > 0) {
    scaling.load = o.contact_radius / f.reference_radius;
    scaling.dx = o.dx / scaling.load;
  }
  if (f.is_table())
    return scaling;
  if (o.dx == 0) {
    if (o.offsets != 1)
      throw InputError("plane strain has no offsets along x", std::to_string(o.offsets) + " were asked for",
                       "Ask for one offset, or give dx.");
    return scaling;
  }
  const double largest = f.wavenumber.back();
  if (f.wavenumber_count() < 3 || largest * scaling.dx / 2 < least_half_element_phase * (1 - phase_slack))
    throw InputError("the influence functions of '" + f.body +
                         "' are too coarse along x for dx = " + std::to_string(o.dx) + " mm",
                     largest > 0 ? "they serve dx >= " + std::to_string(shortest_dx(f) * scaling.load) + " mm"
                                 : "they hold plane strain only",
                     "Use longer elements, or compute them with a smaller harmonic.shortest_dx.");
  if (o.offsets * scaling.dx > f.half_period)
    throw InputError("the patch is longer than the half period of the influence functions of '" + f.body +
                         "'",
                     std::to_string(o.offsets) + " elements of " + std::to_string(o.dx) +
                         " mm, half period " + std::to_string(f.half_period) + " mm",
                     "Use a shorter patch, or compute them with a larger harmonic.half_period.");
  return scaling;
}

} // namespace

InfluenceNumbers expand(const InfluenceFunction& f, const ExpandOptions& o, const ChangeLines& change) {
  const StationRange range = checked_range(f, o);
  const Scaling scaling = checked_scaling(f, o);
  if (!f.is_table())
    return expand_kernel(f, o, range, scaling, change);
  InfluenceNumbers numbers = expand_table(f, o, range, scaling);
  NumberLines lines(numbers.rows, numbers.offsets);
  for (int row = 0; change && row < numbers.rows; ++row) {
    lines.begin(row);
    lines.read_from(numbers);
    change(lines);
    lines.write_to(numbers);
  }
  return numbers;
}

} // namespace bem_contact
