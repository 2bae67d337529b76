#include "fem_influence/harmonic/harmonic_system.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/influence/influence_function.hpp"
#include "fem_influence/harmonic/remote_section.hpp"
#include "fem_influence/shared/body_description.hpp"
#include "fem_influence/shared/settings.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string>

namespace bem_contact::fem {

namespace {

/// 1, of a station's width. Edges must end where stations do: an edge that reaches farther into the next
/// station would shift the load by as much, which is a tenth of the error asked for by default.
constexpr double edge_beyond_station = 1e-4;

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
    if (std::abs(covered[J] - width) > 2 * edge_beyond_station * width)
      throw InputError("The mesh does not match the strip",
                       fmt::format("station {} at s = {:g} mm is covered by {:g} mm of edges instead of {:g}",
                                   J, stations[J].s, covered[J], width),
                       "Mesh the body file that is used here.");
}

/// The functionals f_Jj(v) = integral over station J of v . e_j(delta(s)) ds with the local frame
/// (e_x, e_s, e_n into the body) of the profile curve: column 3 J + j, rows 3 node + component.
/// It is the load vector of a unit traction and, over ds, the mean displacement: one array for both keeps
/// Maxwell-Betti exact. ds is arc length; on a wheel it carries no rho (unit load per reference area).
/// Throws InputError unless each station is covered by whole edges of the group `contact`.
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
    if (first < station - edge_beyond_station || last > station + 1 + edge_beyond_station)
      throw InputError(
          "The mesh does not match the strip",
          fmt::format("an edge of the group 'contact' at s = {:g} .. {:g} mm crosses the border of a station",
                      range.low(), range.high()),
          "Mesh the body file that is used here.");
    const auto J = static_cast<std::size_t>(station);
    covered[J] += std::abs(range.b - range.a);
    add_edge(columns, J, edge, range, curve);
  });
  require_covered(covered, stations, width);
  return columns.sparse();
}

/// Columns of the loads on these stations, three each.
std::vector<std::size_t> columns_of(std::span<const std::size_t> stations) {
  std::vector<std::size_t> columns;
  for (const std::size_t J : stations)
    for (std::size_t c = 3 * J; c < 3 * J + 3; ++c)
      columns.push_back(c);
  return columns;
}

/// Numbers the degrees of freedom of the nodes that are not held.
std::vector<int> number_unknowns(const Section& section) {
  std::vector<int> unknown(3 * section.node_count(), -1);
  int next = 0;
  for (std::size_t d = 0; d < unknown.size(); ++d)
    if (!section.held()[d / 3])
      unknown[d] = next++;
  if (next == 0)
    throw InputError("The mesh has nothing that can move", "all its nodes lie on the group 'held'",
                     "Hold a part of the body, or refine the mesh.");
  return unknown;
}

/// For each rigid motion, scaled to a largest displacement of 1: what it is on the held part, and the work of
/// each load on it. The two balance (WavenumberResult::reaction_error).
void append_rigid_motions(HarmonicSystem& system, std::vector<std::vector<double>> motions,
                          const SparseColumns& loads) {
  for (auto& motion : motions) {
    double largest = 0;
    for (const double u : motion)
      largest = std::max(largest, std::abs(u));
    for (std::size_t d = 0; d < motion.size(); ++d) {
      motion[d] /= largest;
      if (system.unknown[d] < 0)
        system.held_motion.add(static_cast<int>(d), motion[d]);
    }
    system.held_motion.end_column();
    for (std::size_t c = 0; c < loads.columns(); ++c) {
      double work = 0;
      loads.for_each_entry(c, [&](int row, double value) {
        if (const auto d = static_cast<std::size_t>(row); system.unknown[d] >= 0)
          work += motion[d] * value;
      });
      system.load_work.push_back(work);
    }
  }
}

} // namespace

std::size_t HarmonicSystem::unknowns() const {
  return static_cast<std::size_t>(
      std::count_if(unknown.begin(), unknown.end(), [](int u) { return u >= 0; }));
}

HarmonicSystem lay_out_system(const Section& section, const BodyFile& body, const ProfileCurve& curve,
                              std::span<const std::size_t> chosen) {
  HarmonicSystem system;
  const double reference_radius = reference_radius_of(body);
  const std::vector<Station> stations = make_stations(body.strip, curve);
  system.cells = section.cell_count();
  system.stations = chosen.empty() ? stations.size() : chosen.size();
  system.width = body.strip.station_width;
  const SparseColumns all_loads = station_functionals(section, curve, body.strip, stations);
  const SparseColumns loads = chosen.empty() ? all_loads : select_columns(all_loads, columns_of(chosen));
  const SparseColumns remote = remote_functionals(section, stations, body.harmonic.remote_distance);
  system.op = lay_out(section, body.material, reference_radius);
  system.unknown = number_unknowns(section);
  append_unknowns(system.functionals, loads, system.unknown);
  append_unknowns(system.functionals, remote, system.unknown);
  append_rigid_motions(system, rigid_motions(section.node_positions(), reference_radius), loads);
  return system;
}

std::vector<int> elimination_order(const HarmonicSystem& system) {
  Elements free;
  std::vector<int> nodes;
  for (std::size_t c = 0; c < system.op.cells.count(); ++c) {
    nodes.clear();
    for (const int node : system.op.cells[c])
      if (!system.held(node))
        nodes.push_back(node);
    free.add(nodes);
  }
  return nested_dissection(system.nodes(), free);
}

void renumber(HarmonicSystem& system, std::span<const int> place) {
  std::vector<int> moved(system.unknowns());
  for (std::size_t d = 0; d < system.unknown.size(); ++d)
    if (int& u = system.unknown[d]; u >= 0)
      u = moved[static_cast<std::size_t>(u)] = 3 * place[d / 3] + static_cast<int>(d % 3);
  for (int& row : system.functionals.row)
    row = moved[static_cast<std::size_t>(row)];
}

void append_reactions(HarmonicSystem& system) {
  const SparseColumns& held = system.held_motion;
  for (std::size_t c = 0; c < held.columns(); ++c) {
    std::vector<double> motion(system.unknown.size(), 0.0);
    held.for_each_entry(c, [&](int row, double value) { motion[static_cast<std::size_t>(row)] = value; });
    const std::vector<double> reaction = system.op.apply(0.0, motion);
    for (std::size_t d = 0; d < reaction.size(); ++d)
      if (system.unknown[d] >= 0 && reaction[d] != 0)
        system.functionals.add(system.unknown[d], reaction[d]);
    system.functionals.end_column();
  }
}

Elements unknowns_of_cells(const HarmonicSystem& system) {
  Elements elements;
  std::vector<int> members;
  for (std::size_t c = 0; c < system.op.cells.count(); ++c) {
    members.clear();
    for (const int node : system.op.cells[c])
      if (!system.held(node))
        for (std::size_t i = 0; i < 3; ++i)
          members.push_back(system.unknown[3 * static_cast<std::size_t>(node) + i]);
    if (!members.empty())
      elements.add(members);
  }
  return elements;
}

} // namespace bem_contact::fem
