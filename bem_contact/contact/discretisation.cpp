#include "bem_contact/contact/discretisation.hpp"

#include "bem_contact/contact/normal.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace bem_contact::contact {
namespace {

/// Normal numbers of elements joined in twos along x (factor_x = 2) and s (factor_s = 2): the mean over the
/// joined target elements of the sum over the joined loaded ones.
InfluenceNumbers coarsen(const InfluenceNumbers& fine, int factor_x, int factor_s, int mx, int ms) {
  InfluenceNumbers coarse;
  coarse.offsets = mx;
  coarse.rows = ms;
  coarse.dx = factor_x * fine.dx;
  coarse.ds = factor_s * fine.ds;
  coarse.values.assign(static_cast<std::size_t>(mx) * 9 * ms * ms, 0.0);
  const double weight = 1.0 / (factor_x * factor_s);
  for (int m = 0; m < mx; ++m)
    for (int row_i = 0; row_i < ms; ++row_i)
      for (int row_j = 0; row_j < ms; ++row_j) {
        double sum = 0;
        for (int a = 0; a < factor_x; ++a)
          for (int b = 0; b < factor_x; ++b)
            for (int c = 0; c < factor_s; ++c)
              for (int d = 0; d < factor_s; ++d)
                sum += fine.at(std::abs(factor_x * m + a - b), factor_s * row_i + c, component_n,
                               factor_s * row_j + d, component_n);
        coarse.at(m, row_i, component_n, row_j, component_n) = weight * sum;
      }
  return coarse;
}

struct Weight {
  int index;
  double value;
};

/// Weights of the fine elements that give the value at the centre of coarse element k: cubic interpolation,
/// linear at the ends of the grid.
std::vector<Weight> centre_weights(int factor, int k, int fine_count) {
  if (factor == 1)
    return {{k, 1.0}};
  if (k == 0 || 2 * k + 2 >= fine_count)
    return {{2 * k, 0.5}, {2 * k + 1, 0.5}};
  return {{2 * k - 1, -0.0625}, {2 * k, 0.5625}, {2 * k + 1, 0.5625}, {2 * k + 2, -0.0625}};
}

} // namespace

double estimate_discretisation(const ContactProblem& problem, const ContactResult& result,
                               std::span<const double> from_shear, const SolverOptions& options) {
  const ContactGrid& grid = problem.grid;
  const int factor_x = grid.mx > 1 ? 2 : 1, factor_s = grid.ms > 1 ? 2 : 1;
  if (factor_x * factor_s == 1)
    return -1;
  double fine_force = 0;
  for (int i = 0; i < grid.size(); ++i) {
    const bool dropped =
        i % grid.mx >= grid.mx / factor_x * factor_x || i / grid.mx >= grid.ms / factor_s * factor_s;
    if (dropped && result.pn[i] > 0)
      return -1;
    fine_force += result.pn[i] * std::cos(problem.rows[i / grid.mx].delta) * problem.element_area();
  }
  if (!(fine_force > 0))
    return -1;

  const ContactGrid coarse{grid.mx / factor_x, grid.ms / factor_s, factor_x * grid.dx, factor_s * grid.ds,
                           grid.x0 + 0.5 * (factor_x - 1) * grid.dx};
  std::vector<ContactRow> rows(coarse.ms);
  for (int is = 0; is < coarse.ms; ++is)
    for (int c = 0; c < factor_s; ++c)
      rows[is].delta += problem.rows[factor_s * is + c].delta / factor_s;
  Eigen::VectorXd gap(coarse.size());
  for (int is = 0; is < coarse.ms; ++is)
    for (int ix = 0; ix < coarse.mx; ++ix) {
      double sum = 0;
      for (const Weight& row : centre_weights(factor_s, is, grid.ms))
        for (const Weight& column : centre_weights(factor_x, ix, grid.mx)) {
          const int i = row.index * grid.mx + column.index;
          sum += row.value * column.value * (problem.gap[i] + from_shear[i]);
        }
      gap[is * coarse.mx + ix] = sum;
    }
  const InfluenceNumbers numbers = coarsen(problem.numbers, factor_x, factor_s, coarse.mx, coarse.ms);
  const NormalSystem system(coarse, numbers, rows, factor_x * factor_s * problem.element_area());
  NormalState state;
  solve_normal(system, gap, {LoadKind::approach, result.approach, 0}, options, state);
  if (!state.converged)
    return -1;
  return std::abs(system.cosine.dot(state.p) * system.element_area - fine_force) / fine_force;
}

} // namespace bem_contact::contact
