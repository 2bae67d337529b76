#include "bem_contact/contact/coupled/solve_coupled.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact::contact {
namespace {

/// Fewer elements are as quickly solved from anywhere.
constexpr int few = 800;
constexpr int few_across = 16;
/// What coarse elements leave is larger.
constexpr double coarse_tolerance = 1e-3;

/// Numbers of elements twice as large, from those of the rows about `middle`; offsets that are not known
/// repeat the last. Only the normal components unless `all`.
InfluenceNumbers coarse_numbers(const InfluenceNumbers& fine, int offsets, int rows, int middle, bool all) {
  InfluenceNumbers coarse{offsets, rows, 2 * fine.dx, 2 * fine.ds, {}, true};
  coarse.values.assign(coarse.expected_values(), 0.0);
  const int from = all ? component_x : component_n;
  for (int i = from; i < 3; ++i)
    for (int j = from; j < 3; ++j) {
      const auto number = [&](int m, int d) {
        int row_i = std::max(d, 0);
        if (!fine.translational)
          row_i = std::clamp(middle + d / 2, row_i, fine.rows - 1 + std::min(d, 0));
        return (m < 0 ? parity(i, j) : 1) *
               fine.at(std::min(std::abs(m), fine.offsets - 1), row_i, i, row_i - d, j);
      };
      for (int m = 0; m < offsets; ++m)
        for (int d = 1 - rows; d < rows; ++d) {
          double sum = 0;
          for (const int p : {-1, 0, 1})
            for (const int q : {-1, 0, 1})
              sum += (p == 0 ? 2 : 1) * (q == 0 ? 2 : 1) * number(2 * m + p, 2 * d + q);
          coarse.at(m, std::max(d, 0), i, std::max(-d, 0), j) = 0.25 * sum;
        }
    }
  return coarse;
}

std::vector<double> coarse_field(const std::vector<double>& fine, int fine_mx, const ContactGrid& grid) {
  std::vector<double> coarse;
  coarse.reserve(grid.size());
  for (int is = 0; is < grid.ms; ++is)
    for (int ix = 0; ix < grid.mx; ++ix) {
      const double* f = &fine[static_cast<std::size_t>(2 * is) * fine_mx + 2 * ix];
      coarse.push_back(0.25 * (f[0] + f[1] + f[fine_mx] + f[fine_mx + 1]));
    }
  return coarse;
}

ContactProblem coarse_problem(const ContactProblem& problem, Prepared& kept) {
  ContactProblem coarse;
  const ContactGrid& fine = problem.grid;
  coarse.grid = {fine.mx / 2, fine.ms / 2, 2 * fine.dx, 2 * fine.ds, fine.x0 + 0.5 * fine.dx};
  const int middle =
      problem.numbers.translational
          ? 0
          : static_cast<int>(std::ranges::min_element(problem.gap) - problem.gap.begin()) / fine.mx;
  coarse.load = problem.load;
  coarse.approach = problem.approach;
  coarse.force = problem.force;
  coarse.tangential =
      problem.tangential && problem.motion == MotionKind::steady && !problem.force_x && !problem.force_s;
  coarse.friction = problem.friction;
  coarse.kinetic = problem.kinetic;
  const bool all = coarse.tangential && problem.has_friction();
  if (!kept.nested || kept.nested->middle != middle || kept.nested->all != all) {
    kept.nested = std::make_unique<Prepared::Nested>(kept.pool);
    kept.nested->middle = middle;
    kept.nested->all = all;
    kept.nested->numbers = coarse_numbers(problem.numbers, coarse.grid.mx + 2, coarse.grid.ms, middle, all);
  }
  coarse.numbers = kept.nested->numbers;
  for (int is = 0; is < coarse.grid.ms; ++is) {
    const ContactRow &a = problem.rows[2 * is], &b = problem.rows[2 * is + 1];
    coarse.rows.push_back({0.5 * (a.s + b.s), 0.5 * (a.position + b.position), 0.5 * (a.delta + b.delta)});
    if (!problem.friction_rows.empty())
      coarse.friction_rows.push_back(0.5 *
                                     (problem.friction_rows[2 * is] + problem.friction_rows[2 * is + 1]));
  }
  coarse.gap = coarse_field(problem.gap, fine.mx, coarse.grid);
  if (coarse.tangential) {
    coarse.slip_x = coarse_field(problem.slip_x, fine.mx, coarse.grid);
    coarse.slip_s = coarse_field(problem.slip_s, fine.mx, coarse.grid);
  }
  return coarse;
}

/// Bilinear between the centres of the coarse elements.
void prolong(const ContactGrid& from, const double* coarse, const ContactGrid& to, double* fine) {
  struct Place {
    int low, high;
    double share; ///< of high
  };
  const auto place = [](int k, int count) {
    const double at = std::clamp(0.5 * k - 0.25, 0.0, count - 1.0);
    const int low = std::min(static_cast<int>(at), count - 2);
    return Place{low, low + 1, at - low};
  };
  for (int is = 0; is < to.ms; ++is) {
    const Place s = place(is, from.ms);
    for (int ix = 0; ix < to.mx; ++ix) {
      const Place x = place(ix, from.mx);
      const auto line = [&](int row) {
        const double* c = coarse + static_cast<std::ptrdiff_t>(row) * from.mx;
        return (1 - x.share) * c[x.low] + x.share * c[x.high];
      };
      fine[static_cast<std::ptrdiff_t>(is) * to.mx + ix] =
          (1 - s.share) * line(s.low) + s.share * line(s.high);
    }
  }
}

} // namespace

void start_from_coarse(const ContactProblem& problem, const SolverOptions& options, Prepared& kept,
                       Solution& start) {
  const ContactGrid& grid = problem.grid;
  if (problem.plane_strain() || grid.size() < few || std::min(grid.mx, grid.ms) < few_across)
    return;
  const ContactProblem coarse = coarse_problem(problem, kept);
  SolverOptions loose = options;
  loose.tolerance = std::max(options.tolerance, coarse_tolerance);
  loose.max_outer = 1; // a start need not know how shear acts on the pressure
  loose.max_tangential = std::min(options.max_tangential, 30);
  loose.only_newton = true;
  kept.nested->prepared.work = kept.work;
  const Solution known = solve_coupled(coarse, loose, kept.nested->prepared);
  if (!known.normal.converged)
    return;
  const int n = grid.size(), n_coarse = coarse.grid.size();
  start.normal.p.resize(n);
  prolong(coarse.grid, known.normal.p.data(), grid, start.normal.p.data());
  start.normal.active.resize(n);
  for (int i = 0; i < n; ++i)
    start.normal.active[i] = start.normal.p[i] > 0;
  start.normal.approach = known.normal.approach;
  if (known.shear.p.allFinite())
    for (const int c : {0, 1})
      prolong(coarse.grid, known.shear.p.data() + c * n_coarse, grid, start.shear.p.data() + c * n);
}

} // namespace bem_contact::contact
