#pragma once

#include "bem_contact/contact/solve.hpp"
#include "bem_contact/halfspace/flat_strip.hpp"

#include <cmath>
#include <numbers>
#include <vector>

/// Contact problems of the tests, on half-space numbers.
namespace bem_contact::scenes {

inline const Material steel{82000.0, 0.28};
inline const SolverOptions without_estimate{.estimate_discretisation = false};

/// Two half-spaces on each other. Turned by pi about x, rows reversed with it, the upper body's numbers
/// change sign where exactly one of the components is normal.
inline InfluenceNumbers pair(InfluenceNumbers lower, const InfluenceNumbers& upper) {
  for (int m = 0; m < lower.offsets; ++m)
    for (const auto& [row_i, row_j] : lower.stored_rows())
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          lower.at(m, row_i, i, row_j, j) +=
              ((i == component_n) == (j == component_n) ? 1 : -1) * upper.at(m, row_i, i, row_j, j);
  return lower;
}

inline InfluenceNumbers pair(const Material& lower, const Material& upper, const ContactGrid& grid) {
  return pair(halfspace::influence_numbers(lower, grid.dx, grid.ds, grid.mx + 2, grid.ms),
              halfspace::influence_numbers(upper, grid.dx, grid.ds, grid.mx + 2, grid.ms));
}

/// Flat rows, grid centred at the origin, gap a x^2 + b s^2, frictionless.
inline ContactProblem flat(const Material& lower, const Material& upper, int mx, int ms, double dx, double ds,
                           double a, double b) {
  ContactProblem problem;
  problem.grid = {mx, ms, dx, ds, -0.5 * (mx - 1) * dx};
  for (int is = 0; is < ms; ++is) {
    const double s = (is - 0.5 * (ms - 1)) * ds;
    problem.rows.push_back({s, {s, 0}, 0});
    for (int ix = 0; ix < mx; ++ix) {
      const double x = problem.grid.x(ix);
      problem.gap.push_back(a * x * x + b * s * s);
    }
  }
  problem.numbers = pair(lower, upper, problem.grid);
  problem.tangential = false;
  return problem;
}

/// Rigid slip of a plane: w_x = xi - phi s, w_s = eta + phi x.
inline void set_creepage(ContactProblem& problem, double friction, double xi, double eta, double phi) {
  problem.tangential = true;
  problem.friction = friction;
  problem.slip_x.clear();
  problem.slip_s.clear();
  for (const ContactRow& row : problem.rows)
    for (int ix = 0; ix < problem.grid.mx; ++ix) {
      problem.slip_x.push_back(xi - phi * row.s);
      problem.slip_s.push_back(eta + phi * problem.grid.x(ix));
    }
}

/// Rows on an arc: delta = s / radius about the middle; numbers and gap stay those of the flat strip.
inline void bend(ContactProblem& problem, double radius) {
  for (ContactRow& row : problem.rows) {
    row.delta = row.s / radius;
    row.position = {radius * std::sin(row.delta), radius * (1 - std::cos(row.delta))};
  }
}

/// Artificial coupling: every number rotated between the frames of its two rows, u_i = R(d_I)' A R(d_J),
/// the half-space's field taken to be the same in track axes. Stays symmetric and positive definite.
inline void rotate_numbers(ContactProblem& problem) {
  const InfluenceNumbers flat = problem.numbers;
  InfluenceNumbers& a = problem.numbers = with_every_pair_of_rows(flat);
  const auto rotation = [&problem](int row) {
    const double c = std::cos(problem.rows[row].delta), s = std::sin(problem.rows[row].delta);
    return std::array<std::array<double, 3>, 3>{{{1, 0, 0}, {0, c, -s}, {0, s, c}}}; // local to track
  };
  for (int m = 0; m < a.offsets; ++m)
    for (int row_i = 0; row_i < a.rows; ++row_i)
      for (int row_j = 0; row_j < a.rows; ++row_j) {
        const auto ri = rotation(row_i), rj = rotation(row_j);
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j) {
            double sum = 0;
            for (int k = 0; k < 3; ++k)
              for (int l = 0; l < 3; ++l)
                sum += ri[k][i] * flat.at(m, row_i, k, row_j, l) * rj[l][j];
            a.at(m, row_i, i, row_j, j) = sum;
          }
      }
}

} // namespace bem_contact::scenes
