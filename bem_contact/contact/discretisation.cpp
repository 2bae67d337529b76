#include "bem_contact/contact/discretisation.hpp"

#include "bem_contact/contact/normal.hpp"

#include <algorithm>
#include <cmath>

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
  Eigen::VectorXd gap = Eigen::VectorXd::Zero(coarse.size());
  for (int is = 0; is < coarse.ms; ++is)
    for (int ix = 0; ix < coarse.mx; ++ix)
      for (int c = 0; c < factor_s; ++c)
        for (int a = 0; a < factor_x; ++a) {
          const int i = (factor_s * is + c) * grid.mx + factor_x * ix + a;
          gap[is * coarse.mx + ix] += (problem.gap[i] + from_shear[i]) / (factor_x * factor_s);
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
