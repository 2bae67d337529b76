#include "fem_influence/harmonic/remote_section.hpp"

#include "bem_contact/base/error.hpp"
#include "fem_influence/shared/settings.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace bem_contact::fem {

namespace {

/// 1, of the root of the section's mean square distance from the strip. Upper limit of that default in small
/// bodies. An area mean is the same on every mesh; the farthest node is not, and moved far numbers of a disc.
constexpr double remote_part_of_small_body = 0.8;

/// A cell's shapes and quadrature points.
struct RemoteCell {
  std::vector<int> nodes;
  std::vector<Point2> position;
  std::vector<double> area, distance; // [point], mm^2, mm from the strip
  std::vector<double> weight;         // [point]: area times that of the mean, mm^2
  std::vector<double> value;          // [point][local node]
};

double distance_from_strip(Point2 p, std::span<const Station> stations) {
  double nearest = std::numeric_limits<double>::max(); // squared: asked for at every quadrature point
  for (const Station& station : stations)
    nearest = std::min(nearest, dot(p - station.position, p - station.position));
  return std::sqrt(nearest);
}

std::vector<RemoteCell> all_cells(const Section& section, std::span<const Station> stations) {
  std::vector<RemoteCell> cells;
  section.for_each_cell([&](const CellView& cell) {
    RemoteCell& remote = cells.emplace_back();
    remote.nodes.assign(cell.nodes.begin(), cell.nodes.end());
    remote.value.assign(cell.value.begin(), cell.value.end());
    for (const CellPoint& point : cell.points) {
      remote.position.push_back(point.position);
      remote.area.push_back(point.weight);
      remote.distance.push_back(distance_from_strip(point.position, stations));
    }
  });
  return cells;
}

/// A mean over the section, for the largest distance of a node is another one on each mesh.
double default_distance(std::span<const RemoteCell> cells) {
  double area = 0, squares = 0;
  for (const RemoteCell& cell : cells)
    for (std::size_t q = 0; q < cell.area.size(); ++q) {
      area += cell.area[q];
      squares += cell.area[q] * cell.distance[q] * cell.distance[q];
    }
  return std::min(settings::remote_distance, remote_part_of_small_body * std::sqrt(squares / area));
}

void require_cells_beyond(double limit, const Section& section, std::span<const Station> stations) {
  double largest = 0;
  for (const Point2 p : section.node_positions())
    largest = std::max(largest, distance_from_strip(p, stations));
  if (limit >= largest)
    throw InputError(fmt::format("No cell is farther than {:g} mm from the strip", limit),
                     fmt::format("the largest distance is {:g} mm", largest),
                     "Lower harmonic.remote_distance, or give 0 for the default.");
}

/// Sets the weights and drops the cells that have none. The weight is smooth: a sharp border would pass
/// between the quadrature points of any mesh in its own way.
void weigh(std::vector<RemoteCell>& cells, double limit) {
  for (RemoteCell& cell : cells)
    for (std::size_t q = 0; q < cell.area.size(); ++q) {
      const double part = cell.distance[q] / limit - 1;
      const double root = part > 0 && part < 1 ? std::sin(std::numbers::pi * part) : 0;
      cell.weight.push_back(cell.area[q] * (root * root));
    }
  std::erase_if(cells, [](const RemoteCell& cell) {
    return std::none_of(cell.weight.begin(), cell.weight.end(), [](double w) { return w > 0; });
  });
  if (cells.empty())
    throw InputError(fmt::format("No cell lies between {:g} .. {:g} mm from the strip", limit, 2 * limit),
                     "the mesh is too coarse there, and the remote section would be empty",
                     "Change harmonic.remote_distance, or give 0 for the default.");
}

/// Weighted area, mm^2, centroid, and second moments about it, mm^4.
struct Moments {
  double area = 0, yy = 0, zz = 0;
  Point2 centroid;
};

Moments moments_of(std::span<const RemoteCell> cells) {
  Moments m;
  for (const RemoteCell& cell : cells)
    for (std::size_t q = 0; q < cell.weight.size(); ++q) {
      m.area += cell.weight[q];
      m.centroid = m.centroid + cell.weight[q] * cell.position[q];
    }
  m.centroid = (1 / m.area) * m.centroid;
  for (const RemoteCell& cell : cells)
    for (std::size_t q = 0; q < cell.weight.size(); ++q) {
      const Point2 p = cell.position[q] - m.centroid;
      m.yy += cell.weight[q] * p.y * p.y;
      m.zz += cell.weight[q] * p.z * p.z;
    }
  return m;
}

void add_cell(ColumnSums& columns, const RemoteCell& cell, const Moments& m) {
  const std::size_t n = cell.nodes.size();
  for (std::size_t q = 0; q < cell.weight.size(); ++q) {
    const Point2 p = cell.position[q] - m.centroid;
    for (std::size_t a = 0; a < n; ++a) {
      const double f = cell.weight[q] * cell.value[q * n + a];
      const int row = 3 * cell.nodes[a];
      for (std::size_t i = 0; i < 3; ++i)
        columns.add(i, row + static_cast<int>(i), f / m.area);
      columns.add(3, row + 1, -p.z * f / (m.yy + m.zz));
      columns.add(3, row + 2, p.y * f / (m.yy + m.zz));
      columns.add(4, row, p.z * f / m.zz);
      columns.add(5, row, -p.y * f / m.yy);
    }
  }
}

} // namespace

SparseColumns remote_functionals(const Section& section, std::span<const Station> stations, double distance) {
  std::vector<RemoteCell> cells = all_cells(section, stations);
  const double limit = distance > 0 ? distance : default_distance(cells);
  require_cells_beyond(limit, section, stations);
  weigh(cells, limit);
  const Moments moments = moments_of(cells);
  ColumnSums columns(6);
  for (const RemoteCell& cell : cells)
    add_cell(columns, cell, moments);
  return columns.sparse();
}

} // namespace bem_contact::fem
