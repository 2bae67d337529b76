#include "bem_contact/inside/on_stations.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <vector>

namespace bem_contact::inside {

namespace {

/// mm. A station's share of a row that is less is none.
constexpr double no_overlap = 1e-9;

} // namespace

SurfaceTractions on_stations(const SurfaceTractions& t, std::span<const Station> stations, double width) {
  SurfaceTractions out = t;
  out.ds = width;
  out.s.clear();
  for (const Station& station : stations)
    out.s.push_back(station.s);
  for (std::vector<double>* field : {&out.px, &out.ps, &out.pn})
    field->assign(stations.size() * static_cast<std::size_t>(t.columns), 0);
  for (int row = 0; row < t.rows(); ++row) {
    const auto from = static_cast<std::size_t>(row * t.columns);
    const auto loaded = [&](std::size_t c) { return t.at(from + c) != std::array<double, 3>{}; };
    bool any = false;
    for (std::size_t c = 0; c < static_cast<std::size_t>(t.columns); ++c)
      any = any || loaded(c);
    if (!any)
      continue;
    const double s = t.s[static_cast<std::size_t>(row)];
    double covered = 0;
    for (std::size_t J = 0; J < stations.size(); ++J) {
      const double overlap = std::min(s + t.ds / 2, stations[J].s + width / 2) -
                             std::max(s - t.ds / 2, stations[J].s - width / 2);
      if (overlap <= no_overlap)
        continue;
      covered += overlap;
      for (std::size_t c = 0; c < static_cast<std::size_t>(t.columns); ++c) {
        const std::size_t to = J * static_cast<std::size_t>(t.columns) + c;
        out.px[to] += overlap / width * t.px[from + c];
        out.ps[to] += overlap / width * t.ps[from + c];
        out.pn[to] += overlap / width * t.pn[from + c];
      }
    }
    if (covered < (1 - 1e-6) * t.ds)
      throw InputError("The load leaves the strip", "its rows need stations",
                       "Move it, or give the body a longer strip.");
  }
  return out;
}

} // namespace bem_contact::inside
