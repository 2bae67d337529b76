#include "fem_influence/harmonic/station_functionals.hpp"

#include "bem_contact/base/error.hpp"
#include "fem_influence/shared/settings.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace bem_contact::fem {

namespace {

/// Arc lengths on the profile of an edge's ends a and b.
struct EdgeRange {
  double a = 0, b = 0;
  double low() const { return std::min(a, b); }
  double high() const { return std::max(a, b); }
};

EdgeRange range_of(const EdgeView& edge, const ProfileCurve& curve) {
  const CurvePoint middle = curve.nearest(0.5 * (edge.a + edge.b));
  EdgeRange range{curve.nearest(edge.a).s, curve.nearest(edge.b).s};
  // On a closed profile the ends of the first or last edge may be found at the other end of the curve.
  const double closed = curve.s_end() - curve.s_begin();
  for (double* s : {&range.a, &range.b})
    if (std::abs(*s - middle.s) > 0.5 * closed)
      *s += *s < middle.s ? closed : -closed;
  return range;
}

/// Adds what one edge of station J contributes to its three columns.
void add_edge(ColumnSums& columns, std::size_t J, const EdgeView& edge, const EdgeRange& range,
              const ProfileCurve& curve) {
  const double length = std::abs(range.b - range.a);
  const std::size_t n = edge.nodes.size();
  for (std::size_t q = 0; q < edge.t.size(); ++q) {
    const double s = std::clamp(range.a + edge.t[q] * (range.b - range.a), curve.s_begin(), curve.s_end());
    const double delta = curve.at(s).delta;
    const Point2 e_s = tangent_of(delta), e_n = normal_of(delta);
    for (std::size_t a = 0; a < n; ++a) {
      const double f = edge.weight[q] * length * edge.value[q * n + a];
      if (std::abs(edge.value[q * n + a]) < settings::vanishing_shape)
        continue;
      const int row = 3 * edge.nodes[a];
      columns.add(3 * J + component_x, row, f);
      columns.add(3 * J + component_s, row + 1, f * e_s.y);
      columns.add(3 * J + component_s, row + 2, f * e_s.z);
      columns.add(3 * J + component_n, row + 1, f * e_n.y);
      columns.add(3 * J + component_n, row + 2, f * e_n.z);
    }
  }
}

void require_covered(std::span<const double> covered, std::span<const Station> stations, double width) {
  for (std::size_t J = 0; J < stations.size(); ++J)
    if (std::abs(covered[J] - width) > 2 * settings::edge_beyond_station * width)
      throw InputError("The mesh does not match the strip",
                       "station " + std::to_string(J) + " at s = " + std::to_string(stations[J].s) +
                           " mm is covered by " + std::to_string(covered[J]) + " mm of edges instead of " +
                           std::to_string(width),
                       "Mesh the body file that is used here.");
}

} // namespace

SparseColumns station_functionals(const Section& section, const ProfileCurve& curve,
                                  const BodyFile::Strip& strip, std::span<const Station> stations) {
  const double width = strip.station_width;
  ColumnSums columns(3 * stations.size());
  std::vector<double> covered(stations.size(), 0.0);
  section.for_each_contact_edge([&](const EdgeView& edge) {
    const EdgeRange range = range_of(edge, curve);
    const double first = (range.low() - strip.from) / width, last = (range.high() - strip.from) / width;
    const double station = std::floor(0.5 * (first + last));
    if (station < 0 || station >= static_cast<double>(stations.size()))
      return; // the group may reach beyond the strip
    if (first < station - settings::edge_beyond_station || last > station + 1 + settings::edge_beyond_station)
      throw InputError("The mesh does not match the strip",
                       "an edge of the group 'contact' at s = " + std::to_string(range.low()) + " .. " +
                           std::to_string(range.high()) + " mm crosses the border of a station",
                       "Mesh the body file that is used here.");
    const auto J = static_cast<std::size_t>(station);
    covered[J] += std::abs(range.b - range.a);
    add_edge(columns, J, edge, range, curve);
  });
  require_covered(covered, stations, width);
  return columns.sparse();
}

} // namespace bem_contact::fem
