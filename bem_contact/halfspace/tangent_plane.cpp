#include "bem_contact/halfspace/tangent_plane.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/halfspace/near_field.hpp"
#include "bem_contact/halfspace/plane_strain.hpp"

#include <cmath>
#include <numbers>
#include <optional>
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
class Turn {
public:
  explicit Turn(double turn) : q_{{{1, 0, 0}, {0, std::cos(turn), std::sin(turn)}, {0, 0, 0}}} {
    q_[2] = {0, -q_[1][2], q_[1][1]};
  }
  Matrix3 of(const Matrix3& h) const {
    Matrix3 out{};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        for (int k = 0; k < 3; ++k)
          out[i][j] += 0.5 * (q_[i][k] * h[k][j] + h[i][k] * q_[k][j]);
    return out;
  }

private:
  Matrix3 q_;
};

/// The half-space's numbers of pairs of rows at their chords. They depend on the chord's length alone, but
/// for the sign of what is odd along s; so the rows of both bodies, and those of other cases, share lines.
class ChordLines {
public:
  /// `rows`, and what `known` refers to, outlive this.
  ChordLines(const Material& material, const StripGrid& grid, std::span<const ContactRow> rows,
             LineStore& known)
      : offsets_(static_cast<std::size_t>(grid.offsets)),
        near_(
            material, {.dx = grid.dx, .offsets = grid.offsets}, rows.size(),
            [rows](std::size_t apart, std::size_t row_j) {
              return std::abs(chord(rows[row_j], rows[row_j + apart]));
            },
            grid.ds, known),
        values_(9 * offsets_) {}

  /// The numbers of row_j <= row_i at every offset.
  void fill(int row_i, int row_j, bool forwards, std::span<Matrix3> line) {
    LineMix mix;
    near_.add_to(mix, row_i, row_j, 1);
    for (std::size_t e = 0; e < 9; ++e) {
      const int i = static_cast<int>(e) / 3, j = static_cast<int>(e) % 3;
      double* const values = values_.data() + e * offsets_;
      add_mix(mix, e * offsets_, 0, values, offsets_);
      const double sign = forwards || (i == component_s) == (j == component_s) ? 1 : -1;
      for (std::size_t m = 0; m < offsets_; ++m)
        line[m][i][j] = sign * values[m];
    }
  }

private:
  std::size_t offsets_;
  NearField near_;
  std::vector<double> values_; ///< [i][j][offset]
};

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
                                       std::span<const ContactRow> rows, LineStore* known) {
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
  LineStore only_now;
  std::optional<ChordLines> lines;
  if (!plane_strain)
    lines.emplace(material, grid, rows, known ? *known : only_now);
  for (const auto& [row_i, row_j] : out.stored_rows()) {
    if (row_i < row_j)
      continue;
    const double distance = chord(rows[row_j], rows[row_i]);
    if (plane_strain)
      line[0] = averaged_plane_strain(material, distance, grid.ds, grid.reference_distance);
    else
      lines->fill(row_i, row_j, distance >= 0, line);
    const Turn turn(rows[row_i].delta - rows[row_j].delta);
    for (int m = 0; m < out.offsets; ++m) {
      const Matrix3 a = turn.of(line[m]);
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
