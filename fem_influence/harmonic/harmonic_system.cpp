#include "fem_influence/harmonic/harmonic_system.hpp"

#include "bem_contact/base/error.hpp"
#include "fem_influence/harmonic/remote_section.hpp"
#include "fem_influence/harmonic/station_functionals.hpp"
#include "fem_influence/shared/body_description.hpp"
#include "fem_influence/shared/stations.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact::fem {

namespace {

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
  append_rigid_motions(system, rigid_motions(section.node_positions(), reference_radius, 0), loads);
  return system;
}

HarmonicSystem assemble_system(const Section& section, const BodyFile& body, const ProfileCurve& curve) {
  HarmonicSystem system = lay_out_system(section, body, curve);
  fill(system.op, section, reference_radius_of(body));
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
