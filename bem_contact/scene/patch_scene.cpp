#include "bem_contact/scene/patch_scene.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/geometry/rigid_slip.hpp"
#include "bem_contact/geometry/undeformed_distance.hpp"
#include "bem_contact/scene/csv_table.hpp"
#include "bem_contact/scene/motion.hpp"
#include "bem_contact/sequence/potential_contact.hpp"

#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace bem_contact {

namespace {

/// Columns ix, is, then `names`: every element exactly once. Returns one field for each name.
std::vector<std::vector<double>> read_fields(const std::filesystem::path& file, const ContactGrid& grid,
                                             const std::vector<std::string>& names) {
  std::vector<std::string> columns{"ix", "is"};
  columns.insert(columns.end(), names.begin(), names.end());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::vector<double>> fields(names.size(), std::vector<double>(grid.size(), nan));
  for (const std::vector<double>& row : read_csv(file, columns)) {
    const bool whole = row[0] == std::floor(row[0]) && row[1] == std::floor(row[1]);
    const bool inside = row[0] >= 0 && row[0] < grid.mx && row[1] >= 0 && row[1] < grid.ms;
    const std::size_t at = whole && inside ? static_cast<std::size_t>(row[1] * grid.mx + row[0]) : 0;
    if (!whole || !inside || !std::isnan(fields[0][at]))
      throw InputError(
          fmt::format("The table '{}' does not fit the grid", file.string()),
          fmt::format("element ({}, {}) is {}", row[0], row[1],
                      whole && inside ? "given twice" : "not one of it"),
          fmt::format("Give each of ix = 0 .. {}, is = 0 .. {} once.", grid.mx - 1, grid.ms - 1));
    for (std::size_t k = 0; k < names.size(); ++k)
      fields[k][at] = row[2 + k];
  }
  for (int i = 0; i < grid.size(); ++i)
    if (std::isnan(fields[0][i]))
      throw InputError(
          fmt::format("The table '{}' does not fit the grid", file.string()),
          fmt::format("element ({}, {}) is missing", i % grid.mx, i / grid.mx),
          fmt::format("Give each of ix = 0 .. {}, is = 0 .. {} once.", grid.mx - 1, grid.ms - 1));
  return fields;
}

/// Rows from their inclinations: the profile is the polyline through their middles (s = 0 at the origin).
void set_inclined_rows(ContactProblem& problem, const std::filesystem::path& file) {
  const ContactGrid& grid = problem.grid;
  std::vector<double> delta(grid.ms, std::numeric_limits<double>::quiet_NaN());
  for (const std::vector<double>& row : read_csv(file, {"is", "delta"})) {
    if (row[0] != std::floor(row[0]) || row[0] < 0 || row[0] >= grid.ms)
      throw InputError(fmt::format("The table '{}' does not fit the grid", file.string()),
                       fmt::format("row {} is not one of it", row[0]),
                       fmt::format("Give each of is = 0 .. {} once.", grid.ms - 1));
    delta[static_cast<std::size_t>(row[0])] = row[1];
  }
  for (int i = 0; i < grid.ms; ++i)
    if (std::isnan(delta[i]))
      throw InputError(fmt::format("The table '{}' does not fit the grid", file.string()),
                       fmt::format("row {} is missing", i),
                       fmt::format("Give each of is = 0 .. {} once.", grid.ms - 1));
  Point2 p{0, 0};
  for (int i = 0; i < grid.ms; ++i) {
    if (i > 0)
      p = p + grid.ds * tangent_of(0.5 * (delta[i - 1] + delta[i]));
    problem.rows[i].position = p;
    problem.rows[i].delta = delta[i];
  }
  const Point2 middle = 0.5 * (problem.rows[(grid.ms - 1) / 2].position + problem.rows[grid.ms / 2].position);
  for (ContactRow& row : problem.rows)
    row.position = row.position - middle;
}

} // namespace

double circular_gap(double radius, double upper, double s) {
  const double delta = s / radius;
  const Point2 p{radius * std::sin(delta), radius * (1 - std::cos(delta))};
  const Point2 d = p - Point2{0, -upper};
  const double across = dot(d, normal_of(delta));
  const double square = across * across - dot(d, d) + upper * upper;
  if (square < 0 || (across > 0) != (upper > 0))
    return excluded_gap;
  // Of the two intersections the one on the side of the point of first contact; written without cancellation.
  return (dot(d, d) - upper * upper) / (across + std::copysign(std::sqrt(square), upper));
}

void set_gap(ContactProblem& problem, const SceneFile& scene, double x_of_contact) {
  const double radius = scene.strip.radius, upper = scene.strip.upper_radius;
  problem.gap.clear();
  for (const ContactRow& row : problem.rows) {
    const double curved = radius != 0 && upper != 0 ? circular_gap(radius, upper, row.s) : 0.0;
    for (int ix = 0; ix < problem.grid.mx; ++ix) {
      const double x = problem.grid.x(ix) - x_of_contact, s = row.s;
      problem.gap.push_back(curved + scene.gap.a * x * x + scene.gap.b * s * s + scene.gap.c * x * s);
    }
  }
}

PreparedContact prepare_patch(const SceneFile& scene) {
  PreparedContact out;
  out.plane_strain = scene.grid.plane_strain;
  ContactProblem& problem = out.problem;
  ContactGrid& grid = problem.grid;
  grid.mx = scene.grid.plane_strain ? 1 : scene.grid.mx;
  grid.ms = scene.grid.ms;
  grid.dx = scene.grid.plane_strain ? 1.0 : scene.grid.dx;
  grid.ds = scene.grid.ds;
  if (grid.mx < 1 || grid.ms < 1)
    throw InputError("The patch has no grid",
                     fmt::format("grid.mx is {} and grid.ms is {}", grid.mx, grid.ms),
                     "Give both, at least 1.");
  grid.x0 = -0.5 * (grid.mx - 1) * grid.dx;

  const double radius = scene.strip.radius, upper = scene.strip.upper_radius;
  if (radius != 0 && 0.5 * grid.ms * grid.ds > std::abs(radius) * std::acos(0.0))
    throw InputError(
        "The strip is too long for its radius",
        fmt::format("{} rows of {} mm go beyond a quarter turn of radius {} mm", grid.ms, grid.ds, radius),
        "Give fewer rows or shorter ones.");
  problem.rows.resize(grid.ms);
  for (int i = 0; i < grid.ms; ++i) {
    const double s = (i - 0.5 * (grid.ms - 1)) * grid.ds;
    problem.rows[i] = {s, {s, 0}, 0};
    if (radius != 0)
      problem.rows[i] = {s, {radius * std::sin(s / radius), radius * (1 - std::cos(s / radius))}, s / radius};
  }
  if (!scene.strip.inclination.empty())
    set_inclined_rows(problem, scene.folder / scene.strip.inclination);

  if (!scene.gap.table.empty()) {
    problem.gap = read_fields(scene.folder / scene.gap.table, grid, {"h"})[0];
  } else {
    set_gap(problem, scene, 0);
  }

  set_motion(problem, scene, 0);
  if (problem.tangential && !scene.motion.start_table.empty()) {
    auto fields = read_fields(scene.folder / scene.motion.start_table, grid, {"px", "ps", "pn"});
    problem.previous = {{std::move(fields[0]), std::move(fields[1]), std::move(fields[2])}};
  }
  if (problem.tangential && !scene.motion.slip_table.empty()) {
    auto fields = read_fields(scene.folder / scene.motion.slip_table, grid, {"wx", "ws"});
    problem.slip_x = std::move(fields[0]);
    problem.slip_s = std::move(fields[1]);
  } else if (problem.tangential) {
    RigidSlip slip = planar_slip({scene.motion.xi, scene.motion.eta, scene.motion.phi}, problem.rows,
                                 problem.grid.columns());
    problem.slip_x = std::move(slip.x);
    problem.slip_s = std::move(slip.s);
  }

  for (const ContactRow& row : problem.rows) {
    // On the upper circle the angle about its own centre; its arc length runs against the lower body's.
    const double along = radius != 0 && upper != 0
                             ? upper * std::atan2(row.position.y / upper, (row.position.z + upper) / upper)
                             : row.s;
    out.rail_s.push_back(scene.strip.rail_s0 + row.s);
    out.wheel_s.push_back(scene.strip.wheel_s0 - along);
  }
  return out;
}

} // namespace bem_contact
