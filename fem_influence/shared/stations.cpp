#include "fem_influence/shared/stations.hpp"

#include "bem_contact/base/error.hpp"
#include "fem_influence/shared/settings.hpp"

#include <cmath>
#include <string>

namespace bem_contact::fem {

std::vector<Station> make_stations(const BodyFile::Strip& strip, const ProfileCurve& curve) {
  const auto range = [](double from, double to) {
    return std::to_string(from) + " .. " + std::to_string(to) + " mm";
  };
  const double length = strip.to - strip.from;
  const double count = length / strip.station_width;
  if (!(length > 0) || !(strip.station_width > 0) ||
      std::abs(count - std::round(count)) > settings::whole_stations * count)
    throw InputError("The strip " + range(strip.from, strip.to) + " is not a whole number of stations",
                     "station_width is " + std::to_string(strip.station_width) + " mm",
                     "Change strip.from, strip.to or strip.station_width.");
  if (strip.from < curve.s_begin() - settings::strip_end || strip.to > curve.s_end() + settings::strip_end)
    throw InputError("The strip " + range(strip.from, strip.to) + " leaves the profile '" + curve.name() +
                         "'",
                     "its arc length runs over " + range(curve.s_begin(), curve.s_end()),
                     "Change strip.from or strip.to.");
  std::vector<Station> stations;
  for (int i = 0; i < static_cast<int>(std::lround(count)); ++i) {
    const CurvePoint point = curve.at(strip.from + (i + 0.5) * strip.station_width);
    stations.push_back({point.s, point.position, point.delta});
  }
  return stations;
}

} // namespace bem_contact::fem
