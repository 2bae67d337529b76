#include "fem_influence/shared/strip.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace bem_contact::fem {

namespace {

constexpr double tolerance = 1e-4; // of a station's width: edges must end where stations do

/// Collects entries of a few columns and adds up repeated rows.
class Columns {
public:
  explicit Columns(std::size_t count) : entries_(count) {}
  void add(std::size_t column, int row, double value) {
    if (value != 0)
      entries_[column][row] += value;
  }
  SparseColumns finish() const {
    SparseColumns out;
    for (const auto& column : entries_) {
      for (const auto& [row, value] : column) {
        out.row.push_back(row);
        out.value.push_back(value);
      }
      out.column_begin.push_back(out.row.size());
    }
    return out;
  }

private:
  std::vector<std::map<int, double>> entries_;
};

std::string range(double from, double to) {
  return std::to_string(from) + " .. " + std::to_string(to) + " mm";
}

} // namespace

std::vector<Station> make_stations(const BodyFile::Strip& strip, const ProfileCurve& curve) {
  const double length = strip.to - strip.from;
  const double count = length / strip.station_width;
  if (!(length > 0) || !(strip.station_width > 0) || std::abs(count - std::round(count)) > 1e-6 * count)
    throw InputError("The strip " + range(strip.from, strip.to) + " is not a whole number of stations",
                     "station_width is " + std::to_string(strip.station_width) + " mm",
                     "change strip.from, strip.to or strip.station_width");
  if (strip.from < curve.s_begin() - 1e-9 || strip.to > curve.s_end() + 1e-9)
    throw InputError(
        "The strip " + range(strip.from, strip.to) + " leaves the profile '" + curve.name() + "'",
        "its arc length runs over " + range(curve.s_begin(), curve.s_end()), "change strip.from or strip.to");
  std::vector<Station> stations;
  for (int i = 0; i < static_cast<int>(std::lround(count)); ++i) {
    const CurvePoint point = curve.at(strip.from + (i + 0.5) * strip.station_width);
    stations.push_back({point.s, point.position, point.delta});
  }
  return stations;
}

SparseColumns station_functionals(const Section& section, const ProfileCurve& curve,
                                  const BodyFile::Strip& strip, std::span<const Station> stations) {
  const double width = strip.station_width;
  Columns columns(3 * stations.size());
  std::vector<double> covered(stations.size(), 0.0);
  section.for_each_contact_edge([&](const EdgeView& edge) {
    const Point2 middle = 0.5 * (edge.a + edge.b);
    const CurvePoint on_curve = curve.nearest(middle);
    double s_a = curve.nearest(edge.a).s, s_b = curve.nearest(edge.b).s;
    // On a closed profile the ends of the first or last edge may be found at the other end of the curve.
    const double closed = curve.s_end() - curve.s_begin();
    for (double* s : {&s_a, &s_b})
      if (std::abs(*s - on_curve.s) > 0.5 * closed)
        *s += *s < on_curve.s ? closed : -closed;
    const double first = (std::min(s_a, s_b) - strip.from) / width,
                 last = (std::max(s_a, s_b) - strip.from) / width;
    const double station = std::floor(0.5 * (first + last));
    if (station < 0 || station >= static_cast<double>(stations.size()))
      return; // the group may reach beyond the strip
    if (first < station - tolerance || last > station + 1 + tolerance)
      throw InputError("The mesh does not match the strip",
                       "an edge of the group 'contact' at s = " +
                           range(std::min(s_a, s_b), std::max(s_a, s_b)) + " crosses the border of a station",
                       "mesh the body file that is used here");
    const auto J = static_cast<std::size_t>(station);
    const double length = std::abs(s_b - s_a);
    covered[J] += length;
    const std::size_t n = edge.nodes.size();
    for (std::size_t q = 0; q < edge.t.size(); ++q) {
      const double s = std::clamp(s_a + edge.t[q] * (s_b - s_a), curve.s_begin(), curve.s_end());
      const double delta = curve.at(s).delta;
      const Point2 e_s = tangent_of(delta), e_n = normal_of(delta);
      for (std::size_t a = 0; a < n; ++a) {
        const double f = edge.weight[q] * length * edge.value[q * n + a];
        // Shapes of nodes off the edge vanish on it up to round-off.
        if (std::abs(edge.value[q * n + a]) < 1e-12)
          continue;
        const int row = 3 * edge.nodes[a];
        columns.add(3 * J + component_x, row, f);
        columns.add(3 * J + component_s, row + 1, f * e_s.y);
        columns.add(3 * J + component_s, row + 2, f * e_s.z);
        columns.add(3 * J + component_n, row + 1, f * e_n.y);
        columns.add(3 * J + component_n, row + 2, f * e_n.z);
      }
    }
  });
  for (std::size_t J = 0; J < stations.size(); ++J)
    if (std::abs(covered[J] - width) > 2 * tolerance * width)
      throw InputError("The mesh does not match the strip",
                       "station " + std::to_string(J) + " at s = " + std::to_string(stations[J].s) +
                           " mm is covered by " + std::to_string(covered[J]) + " mm of edges instead of " +
                           std::to_string(width),
                       "mesh the body file that is used here");
  return columns.finish();
}

SparseColumns remote_functionals(const Section& section, std::span<const Station> stations, double distance) {
  const auto from_strip = [&](Point2 p) {
    double nearest = std::numeric_limits<double>::max(); // squared: asked for at every quadrature point
    for (const Station& station : stations)
      nearest = std::min(nearest, dot(p - station.position, p - station.position));
    return std::sqrt(nearest);
  };
  double largest = 0;
  for (const Point2 p : section.node_positions())
    largest = std::max(largest, from_strip(p));
  struct RemoteCell {
    std::vector<int> nodes;
    std::vector<Point2> position;
    std::vector<double> weight, distance, value; // weight: area, then that of the mean
  };
  std::vector<RemoteCell> cells;
  double area = 0, squares = 0;
  section.for_each_cell([&](const CellView& cell) {
    RemoteCell& remote = cells.emplace_back();
    remote.nodes.assign(cell.nodes.begin(), cell.nodes.end());
    remote.value.assign(cell.value.begin(), cell.value.end());
    for (const CellPoint& point : cell.points) {
      const double d = from_strip(point.position);
      area += point.weight;
      squares += point.weight * d * d;
      remote.position.push_back(point.position);
      remote.weight.push_back(point.weight);
      remote.distance.push_back(d);
    }
  });
  // A mean over the section, for the largest distance of a node is another one on each mesh.
  const double limit = distance > 0 ? distance : std::min(20.0, 0.8 * std::sqrt(squares / area));
  if (limit >= largest)
    throw InputError("No cell is farther than " + std::to_string(limit) + " mm from the strip",
                     "the largest distance is " + std::to_string(largest) + " mm",
                     "lower harmonic.remote_distance, or give 0 for the default");

  double yy = 0, zz = 0;
  Point2 centroid;
  area = 0;
  for (RemoteCell& cell : cells)
    for (std::size_t q = 0; q < cell.weight.size(); ++q) {
      // A smooth weight: a sharp border would pass between the quadrature points of any mesh in its own way.
      const double part = cell.distance[q] / limit - 1;
      const double root = part > 0 && part < 1 ? std::sin(std::numbers::pi * part) : 0;
      cell.weight[q] *= root * root;
      area += cell.weight[q];
      centroid = centroid + cell.weight[q] * cell.position[q];
    }
  std::erase_if(cells, [](const RemoteCell& cell) {
    return std::none_of(cell.weight.begin(), cell.weight.end(), [](double w) { return w > 0; });
  });
  if (!(area > 0))
    throw InputError("No cell lies between " + range(limit, 2 * limit) + " from the strip",
                     "the mesh is too coarse there, and the remote section would be empty",
                     "change harmonic.remote_distance, or give 0 for the default");
  centroid = (1 / area) * centroid;
  for (const RemoteCell& cell : cells)
    for (std::size_t q = 0; q < cell.weight.size(); ++q) {
      const Point2 p = cell.position[q] - centroid;
      yy += cell.weight[q] * p.y * p.y;
      zz += cell.weight[q] * p.z * p.z;
    }
  Columns columns(6);
  for (const RemoteCell& cell : cells) {
    const std::size_t n = cell.nodes.size();
    for (std::size_t q = 0; q < cell.weight.size(); ++q) {
      const Point2 p = cell.position[q] - centroid;
      for (std::size_t a = 0; a < n; ++a) {
        const double f = cell.weight[q] * cell.value[q * n + a];
        const int row = 3 * cell.nodes[a];
        for (std::size_t i = 0; i < 3; ++i)
          columns.add(i, row + static_cast<int>(i), f / area);
        columns.add(3, row + 1, -p.z * f / (yy + zz));
        columns.add(3, row + 2, p.y * f / (yy + zz));
        columns.add(4, row, p.z * f / zz);
        columns.add(5, row, -p.y * f / yy);
      }
    }
  }
  return columns.finish();
}

} // namespace bem_contact::fem
