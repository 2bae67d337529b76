#include "bem_contact/halfspace/tangent_plane.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/halfspace/element_line.hpp"
#include "bem_contact/halfspace/plane_strain.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace bem_contact::halfspace {
namespace {

/// 1 (share of a row's width). Rows whose steps differ by less are equally far apart: rounding, as above.
constexpr double equal_step = 1e-9;
/// rad. A strip that turns by less altogether is flat.
constexpr double flat_turn = 1e-9;

/// Signed along s.
double chord(const ContactRow& from, const ContactRow& to) {
  const Point2 d = to.position - from.position;
  return std::copysign(norm(d), dot(d, tangent_of(0.5 * (from.delta + to.delta))));
}

/// Whether each row lies to the next as the first does to the second.
bool turns_evenly(std::span<const ContactRow> rows) {
  if (rows.size() < 3)
    return true;
  const double turn = rows[1].delta - rows[0].delta, step = chord(rows[0], rows[1]);
  for (std::size_t i = 0; i + 1 < rows.size(); ++i)
    if (std::abs(rows[i + 1].delta - rows[i].delta - turn) > equal_turn ||
        std::abs(chord(rows[i], rows[i + 1]) - step) > equal_step * std::abs(step))
      return false;
  // Equal steps and turns are a circle if the steps lie along the mean direction.
  const Point2 d = rows[1].position - rows[0].position;
  return std::abs(dot(d, normal_of(0.5 * (rows[0].delta + rows[1].delta)))) <= equal_step * std::abs(step);
}

/// (Q H + H Q) / 2, Q the turn of (s, n) by delta_I - delta_J.
Matrix3 turned(const Matrix3& h, double turn) {
  const double c = std::cos(turn), s = std::sin(turn);
  const Matrix3 q{{{1, 0, 0}, {0, c, s}, {0, -s, c}}};
  Matrix3 out{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        out[i][j] += 0.5 * (q[i][k] * h[k][j] + h[i][k] * q[k][j]);
  return out;
}

/// -u_n under a unit pressure from the uniform tension of Flamant's stress on a circle (tangent_plane.hpp).
double uniform_tension(const Material& material, const StripGrid& grid, std::span<const ContactRow> rows) {
  const double turn = rows.back().delta - rows.front().delta;
  if (!(std::abs(turn) > flat_turn))
    return 0;
  const bool convex = turn * chord(rows.front(), rows.back()) > 0;
  return (convex ? 1 - 2 * material.poisson : 1.0) * grid.ds /
         (4 * std::numbers::pi * material.shear_modulus);
}

} // namespace

InfluenceNumbers tangent_plane_numbers(const Material& material, const StripGrid& grid,
                                       std::span<const ContactRow> rows) {
  const int n = static_cast<int>(rows.size());
  if (n < 1 || grid.offsets < 1)
    throw InputError("An influence table without elements was asked for", std::to_string(n) + " rows",
                     "Ask for at least one row and one offset.");
  const bool plane_strain = grid.dx == 0;
  InfluenceNumbers out;
  out.offsets = plane_strain ? 1 : grid.offsets;
  out.rows = n;
  out.dx = grid.dx;
  out.ds = grid.ds;
  out.translational = turns_evenly(rows);
  out.values.resize(out.expected_values());

  const double tension = plane_strain ? uniform_tension(material, grid, rows) : 0.0;
  std::vector<Matrix3> line(out.offsets);
  for (const auto& [row_i, row_j] : out.stored_rows()) {
    if (row_i < row_j)
      continue;
    const double distance = chord(rows[row_j], rows[row_i]);
    if (plane_strain)
      line[0] = averaged_plane_strain(material, distance, grid.ds, grid.reference_distance);
    else
      averaged_line(material, distance, grid.dx, grid.ds, line);
    for (int m = 0; m < out.offsets; ++m) {
      const Matrix3 a = turned(line[m], rows[row_i].delta - rows[row_j].delta);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          const double value = a[i][j] - (i == component_n && j == component_n ? tension : 0.0);
          out.at(m, row_i, i, row_j, j) = value;
          out.at(m, row_j, j, row_i, i) = parity(i, j) * value; // Maxwell-Betti
        }
    }
  }
  return out;
}

} // namespace bem_contact::halfspace
