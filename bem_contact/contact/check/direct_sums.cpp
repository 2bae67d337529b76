#include "bem_contact/contact/check/direct_sums.hpp"

#include "bem_contact/base/simd.hpp"
#include "bem_contact/contact/operator/strip_operator.hpp"
#include "bem_contact/contact/settings.hpp"
#include "bem_contact/contact/slip_step.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace bem_contact::contact {
namespace {

double number(const InfluenceNumbers& a, int m, int row_i, int i, int row_j, int j) {
  return (m < 0 ? parity(i, j) : 1) * a.at(std::abs(m), row_i, i, row_j, j);
}

/// (A p)_i of one element; the column may lie ahead of the grid.
double displacement_of(const ContactProblem& problem, const ComponentSpans& p, int row_i, int column, int i) {
  const int mx = problem.grid.mx;
  double sum = 0;
  for (int j = 0; j < 3; ++j)
    for (int load = 0; load < problem.grid.size(); ++load)
      if (p[j][load] != 0)
        sum += number(problem.numbers, column - load % mx, row_i, i, load / mx, j) * p[j][load];
  return sum;
}

/// By FFT, columns 0 .. mx + 1; nothing where direct sums disagree.
std::optional<ComponentFields> transformed_displacements(const ContactProblem& problem, bool shear, const ComponentSpans& p) {
  const auto& [mx, ms, dx, ds, x0] = problem.grid;
  std::vector<int> loaded;
  std::vector<double> tractions;
  for (int j = 0; j < 3; ++j)
    if (std::any_of(p[j].begin(), p[j].end(), [](double v) { return v != 0; })) {
      loaded.push_back(j);
      tractions.insert(tractions.end(), p[j].begin(), p[j].end());
    }
  const std::vector<int> wanted =
      shear ? std::vector<int>{component_x, component_s, component_n} : std::vector<int>{component_n};
  const std::size_t n = problem.grid.size(), columns = mx + rolling_columns;
  const StripOperator numbers(problem.numbers, mx, wanted, loaded);
  ComponentFields u;
  u.fill(std::vector<double>(columns * ms, 0.0));
  std::vector<double> out(wanted.size() * n);
  for (int ahead = 0; ahead <= (shear ? rolling_columns : 0); ++ahead) {
    numbers.apply(tractions, out, ahead);
    for (std::size_t c = 0; c < wanted.size(); ++c)
      for (int is = 0; is < ms; ++is)
        std::copy_n(&out[c * n + static_cast<std::size_t>(is) * mx], mx, &u[wanted[c]][is * columns + ahead]);
  }
  for (const int i : wanted) {
    double largest = 0;
    for (const double v : u[i])
      largest = std::max(largest, std::abs(v));
    for (int k = 0; k < checked_elements; ++k) {
      const int element = static_cast<int>(n * (k + 0.5) / checked_elements);
      const double sum = displacement_of(problem, p, element / mx, element % mx, i);
      if (!(std::abs(sum - u[i][element / mx * columns + element % mx]) <= agreement_of_sums * largest))
        return std::nullopt;
    }
  }
  return u;
}

/// u[c] += sum_k load[k] line[c - k]
BEM_CONTACT_WIDE void add_convolved(const double* load, int count, const double* line, int columns,
                                    double* u) {
  int k = 0;
  for (; k + 4 <= count; k += 4, line -= 4) {
    const double l0 = load[k], l1 = load[k + 1], l2 = load[k + 2], l3 = load[k + 3];
    for (int c = 0; c < columns; ++c)
      u[c] += l0 * line[c] + l1 * line[c - 1] + l2 * line[c - 2] + l3 * line[c - 3];
  }
  for (; k < count; ++k, --line)
    for (int c = 0; c < columns; ++c)
      u[c] += load[k] * line[c];
}

/// A row's tractions, without the zeros at its ends.
struct LoadedRow {
  int first = 0, count = 0;
  const double* values = nullptr;
};
LoadedRow loaded_row(const double* row, int mx) {
  int from = 0, to = mx;
  while (from < to && row[from] == 0)
    ++from;
  while (to > from && row[to - 1] == 0)
    --to;
  return {from, to - from, row + from};
}

using LoadedRows = std::array<std::vector<LoadedRow>, 3>;

/// Adds to u_i = (A p)_i, [ms][columns], on the rows `wanted`, where numbers depend on the distance of rows:
/// each line of them serves all pairs equally far apart.
void add_translational(const InfluenceNumbers& a, int mx, const LoadedRows& loads, int i,
                       const std::vector<char>& wanted, int columns, double* u) {
  std::vector<double> line(mx + columns); // of x_I - x_J = 1 - mx .. columns - 1
  for (int j = 0; j < 3; ++j)
    for (const auto& [row_i, row_j] : a.stored_rows()) {
      bool known = false, zero = true;
      for (int k = 0; k < a.rows - std::max(row_i, row_j); ++k) {
        const LoadedRow& load = loads[j][row_j + k];
        if (load.count == 0 || !wanted[row_i + k])
          continue;
        if (!known)
          for (int m = 1 - mx; m < columns; ++m) {
            line[m + mx - 1] = number(a, m, row_i, i, row_j, j);
            zero = zero && line[m + mx - 1] == 0;
          }
        known = true;
        if (!zero)
          add_convolved(load.values, load.count, &line[mx - 1 - load.first], columns,
                        u + static_cast<std::size_t>(row_i + k) * columns);
      }
    }
}

/// The same for any numbers; read as they lie, all of a row and component at once.
void add_full(const InfluenceNumbers& a, int mx, const LoadedRows& loads, int i,
              const std::vector<char>& wanted, int columns, double* u) {
  const int offsets = std::max(mx, columns);
  std::vector<double> lines(static_cast<std::size_t>(3) * a.rows * (mx + columns)); // [J][j][..]
  for (int row_i = 0; row_i < a.rows; ++row_i) {
    if (!wanted[row_i])
      continue;
    for (int m = 0; m < offsets; ++m) {
      double* at = &lines[mx - 1];
      for (int row_j = 0; row_j < a.rows; ++row_j)
        for (int j = 0; j < 3; ++j, at += mx + columns) {
          const double number = a.at(m, row_i, i, row_j, j);
          if (m > 0 && m < mx)
            at[-m] = parity(i, j) * number;
          if (m < columns)
            at[m] = number;
        }
    }
    for (int row_j = 0; row_j < a.rows; ++row_j)
      for (int j = 0; j < 3; ++j)
        if (const LoadedRow& load = loads[j][row_j]; load.count > 0)
          add_convolved(
              load.values, load.count,
              &lines[static_cast<std::size_t>(3 * row_j + j) * (mx + columns) + mx - 1 - load.first], columns,
              u + static_cast<std::size_t>(row_i) * columns);
  }
}

} // namespace

ComponentFields direct_displacements(const ContactProblem& problem, const std::vector<char>& slips, const ComponentSpans& p) {
  const auto& [mx, ms, dx, ds, x0] = problem.grid;
  const InfluenceNumbers& a = problem.numbers;
  const int columns = std::min(mx + rolling_columns, a.offsets);
  double terms = 0;
  for (int j = 0; j < 3; ++j)
    terms += (slips.empty() ? 1.0 : 3.0) * problem.grid.size() *
             std::count_if(p[j].begin(), p[j].end(), [](double v) { return v != 0; });
  if (terms > many_terms && columns == mx + rolling_columns)
    if (auto u = transformed_displacements(problem, !slips.empty(), p))
      return std::move(*u);
  ComponentFields u;
  u.fill(std::vector<double>(static_cast<std::size_t>(columns) * ms, 0.0));
  LoadedRows loads;
  for (int j = 0; j < 3; ++j)
    for (int row = 0; row < ms; ++row)
      loads[j].push_back(loaded_row(p[j].data() + static_cast<std::size_t>(row) * mx, mx));
  const std::vector<char> all(ms, 1);
  for (int i = slips.empty() ? component_n : component_x; i < 3; ++i)
    (a.translational ? add_translational : add_full)(a, mx, loads, i, i == component_n ? all : slips, columns,
                                                     u[i].data());
  return u;
}

} // namespace bem_contact::contact
