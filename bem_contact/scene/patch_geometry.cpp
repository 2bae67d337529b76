#include "bem_contact/scene/patch_geometry.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/geometry/undeformed_distance.hpp"
#include "bem_contact/scene/csv_table.hpp"

#include <cmath>
#include <fmt/format.h>

namespace bem_contact {

namespace {

ContactGrid grid_of(const SceneFile::Grid& asked) {
  ContactGrid grid;
  grid.mx = asked.plane_strain ? 1 : asked.mx.value_or(0);
  grid.ms = asked.ms.value_or(0);
  grid.dx = asked.plane_strain ? 1.0 : asked.dx;
  grid.ds = asked.ds;
  if (grid.mx < 1 || grid.ms < 1)
    throw InputError("The patch has no grid",
                     fmt::format("grid.mx is {} and grid.ms is {}", grid.mx, grid.ms),
                     "Give both, at least 1.");
  grid.x0 = -0.5 * (grid.mx - 1) * grid.dx;
  return grid;
}

/// On a plane (radius 0) or on a circle.
std::vector<ContactRow> circular_rows(const ContactGrid& grid, double radius) {
  if (radius != 0 && 0.5 * grid.ms * grid.ds > std::abs(radius) * std::acos(0.0))
    throw InputError(
        "The strip is too long for its radius",
        fmt::format("{} rows of {} mm go beyond a quarter turn of radius {} mm", grid.ms, grid.ds, radius),
        "Give fewer rows or shorter ones.");
  std::vector<ContactRow> rows(grid.ms);
  for (int i = 0; i < grid.ms; ++i) {
    const double s = (i - 0.5 * (grid.ms - 1)) * grid.ds;
    rows[i] = {s, {s, 0}, 0};
    if (radius != 0)
      rows[i] = {s, {radius * std::sin(s / radius), radius * (1 - std::cos(s / radius))}, s / radius};
  }
  return rows;
}

/// The profile is the polyline through the middles of the rows; s = 0 is at the origin.
void incline(std::vector<ContactRow>& rows, const std::vector<double>& delta, double ds) {
  Point2 p{0, 0};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i > 0)
      p = p + ds * tangent_of(0.5 * (delta[i - 1] + delta[i]));
    rows[i].position = p;
    rows[i].delta = delta[i];
  }
  const Point2 middle = 0.5 * (rows[(rows.size() - 1) / 2].position + rows[rows.size() / 2].position);
  for (ContactRow& row : rows)
    row.position = row.position - middle;
}

/// On the upper circle the angle about its own centre; its arc length runs against the lower body's.
double along_upper(const ContactRow& row, double radius, double upper) {
  return radius != 0 && upper != 0
             ? upper * std::atan2(row.position.y / upper, (row.position.z + upper) / upper)
             : row.s;
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

std::vector<double> PatchGeometry::gap_at(double x_of_contact) const {
  std::vector<double> out;
  out.reserve(grid.size());
  for (const ContactRow& row : rows) {
    const double curved = radius != 0 && upper_radius != 0 ? circular_gap(radius, upper_radius, row.s) : 0.0;
    for (int ix = 0; ix < grid.mx; ++ix) {
      const double x = grid.x(ix) - x_of_contact, s = row.s;
      out.push_back(curved + quadratic.a * x * x + quadratic.b * s * s + quadratic.c * x * s);
    }
  }
  return out;
}

GridPlan PatchGeometry::plan() const {
  return {rows.front().s, 0, grid.ms, grid.mx, grid.dx, grid.ds, 0};
}

PatchGeometry read_patch(const SceneFile& scene) {
  PatchGeometry out;
  out.plane_strain = scene.grid.plane_strain;
  out.grid = grid_of(scene.grid);
  out.quadratic = scene.gap;
  out.radius = scene.strip.radius;
  out.upper_radius = scene.strip.upper_radius;
  out.rows = circular_rows(out.grid, out.radius);
  if (!scene.strip.inclination.empty())
    incline(out.rows, read_row_values(scene.folder / scene.strip.inclination, out.grid, "delta"),
            out.grid.ds);
  out.gap = scene.gap.table.empty() ? out.gap_at(0)
                                    : read_fields(scene.folder / scene.gap.table, out.grid, {"h"})[0];
  const bool friction = !scene.motion.frictionless && scene.motion.friction > 0;
  if (friction && !scene.motion.start_table.empty()) {
    const std::filesystem::path file = scene.folder / scene.motion.start_table;
    std::vector<std::string> names{"px", "ps", "pn"};
    if (const std::vector<std::string> given = csv_columns(file);
        !given.empty() && given.back() == "plastic_slip")
      names.push_back("plastic_slip");
    auto fields = read_fields(file, out.grid, names);
    fields.resize(4); // no plastic slip: empty
    out.start = {{std::move(fields[0]), std::move(fields[1]), std::move(fields[2]), std::move(fields[3])}};
  }
  if (friction && !scene.motion.slip_table.empty()) {
    auto fields = read_fields(scene.folder / scene.motion.slip_table, out.grid, {"wx", "ws"});
    out.slip = RigidSlip{std::move(fields[0]), std::move(fields[1])};
  }
  for (const ContactRow& row : out.rows) {
    out.rail_s.push_back(scene.strip.rail_s0 + row.s);
    out.wheel_s.push_back(scene.strip.wheel_s0 - along_upper(row, out.radius, out.upper_radius));
  }
  return out;
}

} // namespace bem_contact
