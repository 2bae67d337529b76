#include "bem_contact/sequence/pair_numbers.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/halfspace/combine.hpp"
#include "bem_contact/halfspace/flat_strip.hpp"
#include "bem_contact/halfspace/resample.hpp"
#include "bem_contact/halfspace/tangent_plane.hpp"
#include "bem_contact/influence/influence_file.hpp"
#include "bem_contact/influence/requirements.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace bem_contact {

namespace {

std::shared_ptr<const InfluenceFunction> read_side(const SceneFile& scene, const SceneFile::Side& side) {
  if (side.influence.empty())
    return nullptr;
  auto function =
      std::make_shared<const InfluenceFunction>(read_influence_file(scene.folder / side.influence));
  require_material(*function, side.material);
  return function;
}

std::pair<double, double> strip_of(const InfluenceFunction& f) {
  const double half = 0.5 * f.station_width;
  return {f.stations.front().s - half, f.stations.back().s + half};
}

/// Rows of equal width on the rail are a hair shorter or longer on the wheel: allow 1 % of a row.
bool inside(const std::shared_ptr<const InfluenceFunction>& f, double s, double ds) {
  if (!f)
    return true;
  const auto [from, to] = strip_of(*f);
  return s - 0.49 * ds >= from && s + 0.49 * ds <= to;
}

InfluenceNumbers expand_side(const InfluenceFunction& function, const SceneFile::Side& side,
                             const PreparedContact& contact, const std::vector<double>& row_s) {
  const ContactGrid& grid = contact.problem.grid;
  const bool plane_strain = contact.plane_strain;
  ExpandOptions options;
  options.dx = plane_strain ? 0.0 : grid.dx;
  options.offsets = plane_strain ? 1 : grid.mx + 2;
  options.structural = side.structural;
  options.contact_radius = function.invariance == Invariance::revolution ? contact.contact_radius : 0.0;
  return halfspace::resample(function, options, row_s, grid.ds);
}

/// A patch is given without profiles: what can be compared is how far the normal turns along the strip.
/// Throws InputError where the file's surface turns otherwise than the rows do, by more than `tolerance`.
void require_turn(const InfluenceFunction& f, const PreparedContact& contact,
                  const std::vector<double>& row_s, double tolerance) {
  const auto delta_at = [&](double s) {
    const double index = (s - f.stations.front().s) / f.station_width;
    const auto last = static_cast<double>(f.stations.size() - 1);
    return f.stations[static_cast<std::size_t>(std::lround(std::clamp(index, 0.0, last)))].delta;
  };
  const std::vector<ContactRow>& rows = contact.problem.rows;
  const std::size_t middle = rows.size() / 2;
  const double station =
      std::abs(f.stations.back().delta - f.stations.front().delta) / static_cast<double>(f.stations.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double file_turn = delta_at(row_s[i]) - delta_at(row_s[middle]);
    const double row_turn = rows[i].delta - rows[middle].delta;
    if (std::abs(file_turn - row_turn) > tolerance + station)
      throw InputError(
          fmt::format("The influence functions of '{}' do not fit the patch", f.body),
          fmt::format("from the middle to row {} their surface turns by {:.3f} rad and the patch by "
                      "{:.3f} rad",
                      i, file_turn, row_turn),
          "Correct [strip] (radius, inclination, rail_s0, wheel_s0) or give the bodies' own files.");
  }
}

/// The same numbers with the rows in the opposite order.
InfluenceNumbers reversed(const InfluenceNumbers& numbers) {
  InfluenceNumbers out = numbers;
  const int last = numbers.rows - 1;
  for (int m = 0; m < numbers.offsets; ++m)
    for (const auto& [row_i, row_j] : numbers.stored_rows())
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          out.at(m, row_i, i, row_j, j) = numbers.at(m, last - row_i, i, last - row_j, j);
  return out;
}

} // namespace

PairFiles read_pair_files(const SceneFile& scene) {
  PairFiles files{read_side(scene, scene.rail), read_side(scene, scene.wheel)};
  if (files.complete())
    require_order(*files.rail, *files.wheel);
  return files;
}

InfluenceNumbers halfspace_pair(const SceneFile& scene, const PreparedContact& contact) {
  const ContactGrid& grid = contact.problem.grid;
  const auto one = [&](const Material& material) {
    // The approach of plane strain is relative to a point this far away. On a curved strip forces depend on
    // it, since the approach turns with the normal; its radius is what the disc in a hole has (Michell).
    const double reference_distance = scene.strip.radius != 0 ? std::abs(scene.strip.radius) : 100.0;
    return contact.plane_strain
               ? halfspace::plane_strain_numbers(material, grid.ds, grid.ms, reference_distance)
               : halfspace::numbers(material, grid.dx, grid.ds, grid.mx + 2, grid.ms);
  };
  // The wheel's own s runs against the rail's: with rows in the contact's order the couplings of equal bodies
  // cancel.
  const InfluenceNumbers rail = one(scene.rail.material);
  return halfspace::combine(
      rail, reversed(scene.wheel.material == scene.rail.material ? rail : one(scene.wheel.material)));
}

InfluenceNumbers tangent_plane_pair(const SceneFile& scene, const PreparedContact& contact) {
  const ContactGrid& grid = contact.problem.grid;
  std::vector<halfspace::StripRow> rail, wheel; // the wheel's own frame is turned by pi about x
  for (const ContactRow& row : contact.problem.rows) {
    rail.push_back({row.position, row.delta});
    wheel.push_back({-1.0 * row.position, row.delta});
  }
  const halfspace::StripGrid strip{contact.plane_strain ? 0.0 : grid.dx, grid.ds,
                                   contact.plane_strain ? 1 : grid.mx + 2,
                                   scene.strip.radius != 0 ? std::abs(scene.strip.radius) : 100.0};
  return halfspace::combine(halfspace::tangent_plane_numbers(scene.rail.material, strip, rail),
                            halfspace::tangent_plane_numbers(scene.wheel.material, strip, wheel));
}

InfluenceNumbers fem_pair(const SceneFile& scene, const PairFiles& files, const PreparedContact& contact) {
  if (!files.complete())
    throw InputError("The finite-element model needs influence functions of both bodies",
                     !files.rail && !files.wheel ? "the scene names none"
                     : files.rail                ? "the scene names none for the wheel"
                                                 : "the scene names none for the rail",
                     "Give rail.influence and wheel.influence, or ask for the half-space model.");
  require_strips(files, contact);
  if (scene.kind == SceneKind::patch) {
    require_turn(*files.rail, contact, contact.rail_s, 0.02);
    require_turn(*files.wheel, contact, contact.wheel_s, 0.2); // its surface need not follow the rail's
  }
  return halfspace::combine(expand_side(*files.rail, scene.rail, contact, contact.rail_s),
                            expand_side(*files.wheel, scene.wheel, contact, contact.wheel_s));
}

void require_strips(const PairFiles& files, const PreparedContact& contact) {
  const double half = 0.49 * contact.problem.grid.ds;
  const auto side = [&](const std::shared_ptr<const InfluenceFunction>& f, const std::vector<double>& s) {
    if (!f || s.empty())
      return;
    const auto [lo, hi] = std::ranges::minmax(s);
    require_strip(*f, lo - half, hi + half);
  };
  side(files.rail, contact.rail_s);
  side(files.wheel, contact.wheel_s);
}

std::pair<int, int> covered_rows(const PairFiles& files, const PreparedContact& contact) {
  const double ds = contact.problem.grid.ds;
  int first = 0, last = static_cast<int>(contact.rail_s.size()) - 1;
  const auto good = [&](int i) {
    return inside(files.rail, contact.rail_s[i], ds) && inside(files.wheel, contact.wheel_s[i], ds);
  };
  while (first <= last && !good(first))
    ++first;
  while (last >= first && !good(last))
    --last;
  return {first, last};
}

} // namespace bem_contact
