#include "bem_contact/contact/check/direct_sums.hpp"

#include "bem_contact/base/parallel.hpp"
#include "bem_contact/base/simd.hpp"
#include "bem_contact/contact/grid/boxes.hpp"
#include "bem_contact/contact/operator/plane_operator.hpp"
#include "bem_contact/contact/operator/settings.hpp"
#include "bem_contact/contact/settings.hpp"
#include "bem_contact/contact/slip_step.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iterator>
#include <optional>

namespace bem_contact::contact {
namespace {

/// Direct sums confirm a transform at an element of each row in contact and at so many all over the grid, and
/// agree with it so closely (relative).
constexpr int confirmed_elsewhere = 30;
constexpr double agreement_of_sums = 1e-9;

/// An element with tractions.
struct LoadedElement {
  int column, row;
  std::array<double, 9> p; ///< MPa; all three of them three times, as influence numbers lie: [i][j]
};

/// In the order of memory: along rows, column after column.
std::vector<LoadedElement> loaded_elements(const ContactProblem& problem, const ComponentSpans& p) {
  const int mx = problem.grid.mx;
  std::vector<LoadedElement> out;
  for (int column = 0; column < mx; ++column)
    for (int row = 0; row < problem.grid.ms; ++row) {
      const int i = row * mx + column;
      const double x = p[0][i], s = p[1][i], n = p[2][i];
      if (x != 0 || s != 0 || n != 0)
        out.push_back({column, row, {x, s, n, x, s, n, x, s, n}});
    }
  return out;
}

/// Sums of number (i, j) times traction j, [i][j]. `at_zero`: the numbers of the element's row and row 0 at
/// offset 0; those of the next offset lie `to_next` farther.
BEM_CONTACT_WIDE void sum_terms(const LoadedElement* load, const LoadedElement* end, const double* at_zero,
                                std::ptrdiff_t to_next, int column, double* out) {
  double sums[9] = {};
  for (; load != end; ++load) {
    const double* number = at_zero + std::abs(column - load->column) * to_next - 9 * load->row;
    for (int e = 0; e < 9; ++e)
      sums[e] += number[e] * load->p[e];
  }
  std::copy_n(sums, 9, out);
}

/// A p at one element, for translational numbers.
std::array<double, 3> displacement_of(const InfluenceNumbers& a, std::span<const LoadedElement> loads,
                                      int row, int column) {
  const double* at_zero = &a.values[a.index(0, row, 0, 0, 0)];
  const std::ptrdiff_t to_next = 9 * (2 * static_cast<std::ptrdiff_t>(a.rows) - 1);
  const LoadedElement *const from = loads.data(), *const end = from + loads.size();
  const LoadedElement* const ahead =
      from + (std::ranges::upper_bound(loads, column, {}, &LoadedElement::column) - loads.begin());
  std::array<double, 9> behind_sums{}, ahead_sums{};
  sum_terms(from, ahead, at_zero, to_next, column, behind_sums.data());
  sum_terms(ahead, end, at_zero, to_next, column, ahead_sums.data());
  std::array<double, 3> u{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) // of a load ahead the offset is negative
      u[i] += behind_sums[3 * i + j] + parity(i, j) * ahead_sums[3 * i + j];
  return u;
}

/// Where direct sums confirm a transform: at a place of each row, each time in another part of what is wanted
/// there (or loaded, if everything is wanted), and at places all over the grid.
std::vector<int> confirmed_places(const ContactProblem& problem, std::span<const LoadedElement> loads,
                                  const WantedDisplacements& wanted, int columns) {
  constexpr double golden = 0.6180339887498949; // multiples of it fall evenly between 0 and 1
  std::vector<std::vector<int>> candidates(problem.grid.ms);
  const Places& named = wanted.tangential && wanted.tangential->empty() ? wanted.normal : wanted.tangential;
  if (named)
    for (const int place : *named)
      candidates[place / columns].push_back(place);
  else
    for (const LoadedElement& load : loads)
      candidates[load.row].push_back(load.row * columns + load.column);
  std::vector<int> out;
  for (std::size_t row = 0; row < candidates.size(); ++row)
    if (const std::size_t count = candidates[row].size(); count > 0)
      out.push_back(candidates[row][static_cast<std::size_t>(std::fmod(golden * row, 1.0) * count)]);
  for (int k = 0; k < confirmed_elsewhere; ++k)
    out.push_back(static_cast<int>(columns * problem.grid.ms * (k + 0.5) / confirmed_elsewhere));
  return out;
}

/// Boxes around what is loaded and where displacements are wanted.
Boxes boxes_for(const ContactProblem& problem, std::span<const LoadedElement> loads, const Places& wanted,
                int columns) {
  if (!wanted)
    return {{{0, 0, columns, problem.grid.ms}}};
  if (wanted->empty())
    return {};
  std::vector<int> places = *wanted;
  for (const LoadedElement& load : loads)
    places.push_back(load.row * columns + load.column);
  ContactGrid grid = problem.grid;
  grid.mx = columns;
  return boxes_around(places, grid, 0, false);
}

/// The least and the largest of translational numbers (i, j), [3 i + j], and 0.
struct Extremes {
  std::array<double, 9> least{}, largest{};

  explicit Extremes(const InfluenceNumbers& a) {
    for (std::size_t at = 0; at < a.values.size(); at += 9)
      for (std::size_t e = 0; e < 9; ++e) {
        least[e] = std::min(least[e], a.values[at + e]);
        largest[e] = std::max(largest[e], a.values[at + e]);
      }
  }
  /// Whether all are zero, as those of equal bodies that couple normal and tangential.
  bool vanish(int i, int j) const { return least[3 * i + j] == 0 && largest[3 * i + j] == 0; }
};

/// Whether no normal displacement is negative: pressure without tension on numbers that are none, and no
/// shear that moves the surface along its normal.
bool only_apart(const Extremes& numbers, const std::vector<LoadedElement>& loads,
                const std::vector<int>& loaded) {
  return numbers.least[3 * component_n + component_n] == 0 &&
         std::ranges::all_of(loads, [](const LoadedElement& load) { return load.p[component_n] >= 0; }) &&
         std::ranges::all_of(loaded,
                             [&](int j) { return j == component_n || numbers.vanish(component_n, j); });
}

/// u of one component on the boxes by FFT, from the components `loaded` of p; u is a field of `columns`. One
/// component after the other, so that the spectra of one take the memory of those before.
void transform_on(const Boxes& boxes, int component, const std::vector<int>& loaded, const Extremes& numbers,
                  const ContactProblem& problem, const ComponentSpans& p, ComponentFields& u) {
  std::vector<int> inputs;
  std::ranges::copy_if(loaded, std::back_inserter(inputs),
                       [&](int j) { return !numbers.vanish(component, j); });
  if (inputs.empty())
    return;
  const int mx = problem.grid.mx, columns = static_cast<int>(u[0].size()) / problem.grid.ms;
  const std::size_t n = boxes.size();
  std::vector<double> tractions(n * inputs.size()), out(n);
  const auto for_each_row = [&](auto&& visit) { // visit(place on the boxes, row, first column, columns)
    std::size_t place = 0;
    for (const Box& box : boxes.boxes)
      for (int row = box.first_s; row < box.first_s + box.ms; ++row, place += box.mx)
        visit(place, static_cast<std::size_t>(row), box.first_x, box.mx);
  };
  for (std::size_t j = 0; j < inputs.size(); ++j)
    for_each_row([&](std::size_t place, std::size_t row, int first, int count) {
      std::copy_n(&p[inputs[j]][row * mx + first], std::min(count, mx - first), &tractions[n * j + place]);
    });
  PlaneOperator(problem.numbers, boxes, {component}, inputs).apply(tractions, out, 0);
  for_each_row([&](std::size_t place, std::size_t row, int first, int count) {
    std::copy_n(&out[place], count, &u[component][row * columns + first]);
  });
}

/// By FFT, for translational numbers, columns 0 .. mx + 1; nothing where direct sums disagree. The operators
/// are made here, from the numbers: nothing of them is the solvers'.
std::optional<ComponentFields> transformed_displacements(const ContactProblem& problem,
                                                         const WantedDisplacements& wanted,
                                                         const ComponentSpans& p) {
  const std::vector<LoadedElement> loads = loaded_elements(problem, p);
  const int columns = summed_columns(problem);
  ComponentFields u;
  u.fill(std::vector<double>(static_cast<std::size_t>(columns) * problem.grid.ms, 0.0));
  std::vector<int> loaded;
  for (int j = 0; j < 3; ++j)
    if (std::ranges::any_of(loads, [j](const LoadedElement& load) { return load.p[j] != 0; }))
      loaded.push_back(j);
  if (loaded.empty())
    return u;
  const Extremes numbers(problem.numbers);
  const bool pulls = !wanted.normal || !only_apart(numbers, loads, loaded);
  const Boxes tangential = boxes_for(problem, loads, wanted.tangential, columns);
  const std::array<Boxes, 3> where{tangential, tangential,
                                   boxes_for(problem, loads, pulls ? std::nullopt : wanted.normal, columns)};
  std::array<double, 3> allowed{};
  for (const int i : {component_n, component_x, component_s}) {
    if (!where[i].boxes.empty())
      transform_on(where[i], i, loaded, numbers, problem, p, u);
    for (const double v : u[i])
      allowed[i] = std::max(allowed[i], agreement_of_sums * std::abs(v));
  }
  for (const int at : confirmed_places(problem, loads, wanted, columns)) {
    const std::array<double, 3> sum = displacement_of(problem.numbers, loads, at / columns, at % columns);
    for (int i = 0; i < 3; ++i)
      if (where[i].local(at, columns) >= 0 && !(std::abs(sum[i] - u[i][at]) <= allowed[i]))
        return std::nullopt;
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

/// What is summed: influence numbers, tractions of each component by rows, and the columns of the result.
struct Terms {
  const InfluenceNumbers& a;
  int mx, columns;
  std::array<std::vector<LoadedRow>, 3> loads;
};

/// Adds to u_i = (A p)_i, [ms][columns], on the rows `wanted`, for translational numbers: each line of them
/// serves all pairs of rows at the same distance.
void add_translational(const Terms& terms, int i, const std::vector<char>& wanted, double* u) {
  const auto& [a, mx, columns, loads] = terms;
  const auto stride = 9 * static_cast<std::size_t>(2 * a.rows - 1); // to the next offset
  std::vector<double> line(mx + columns);                           // of x_I - x_J = 1 - mx .. columns - 1
  double* const middle = &line[mx - 1];
  for (int j = 0; j < 3; ++j)
    for (const auto& [row_i, row_j] : a.stored_rows()) {
      bool known = false, zero = true;
      for (int k = 0; k < a.rows - std::max(row_i, row_j); ++k) {
        const LoadedRow& load = loads[j][row_j + k];
        if (load.count == 0 || !wanted[row_i + k])
          continue;
        if (!known) {
          const double* number = &a.values[a.index(0, row_i, i, row_j, j)];
          const double sign = parity(i, j);
          for (int m = 0; m < columns; ++m, number += stride) {
            middle[m] = *number;
            if (m > 0 && m < mx)
              middle[-m] = sign * *number;
            zero = zero && *number == 0;
          }
        }
        known = true;
        if (!zero)
          add_convolved(load.values, load.count, middle - load.first, columns,
                        u + static_cast<std::size_t>(row_i + k) * columns);
      }
    }
}

/// The same for any numbers, on the wanted ones of rows `first` to `end` - 1. They are read in the order of
/// memory, all of a row and component at once.
void add_full(const Terms& terms, int i, const std::vector<char>& wanted, int first, int end, double* u) {
  const auto& [a, mx, columns, loads] = terms;
  const int offsets = std::max(mx, columns);
  std::vector<double> lines(static_cast<std::size_t>(3) * a.rows * (mx + columns)); // [J][j][..]
  std::vector<int> loaded;
  for (int row = 0; row < a.rows; ++row)
    if (std::ranges::any_of(loads, [row](const auto& rows) { return rows[row].count > 0; }))
      loaded.push_back(row);
  for (int row_i = first; row_i < end; ++row_i) {
    if (!wanted[row_i])
      continue;
    for (int m = 0; m < offsets; ++m)
      for (const int row_j : loaded) {
        double* at = &lines[static_cast<std::size_t>(3 * row_j) * (mx + columns) + mx - 1];
        for (int j = 0; j < 3; ++j, at += mx + columns) {
          const double number = a.at(m, row_i, i, row_j, j);
          if (m > 0 && m < mx)
            at[-m] = parity(i, j) * number;
          if (m < columns)
            at[m] = number;
        }
      }
    for (const int row_j : loaded)
      for (int j = 0; j < 3; ++j)
        if (const LoadedRow& load = loads[j][row_j]; load.count > 0)
          add_convolved(
              load.values, load.count,
              &lines[static_cast<std::size_t>(3 * row_j + j) * (mx + columns) + mx - 1 - load.first], columns,
              u + static_cast<std::size_t>(row_i) * columns);
  }
}

/// By rows, which of them hold a wanted place.
std::vector<char> rows_of(const Places& wanted, int rows, int columns) {
  std::vector<char> out(rows, !wanted);
  if (wanted)
    for (const int place : *wanted)
      out[place / columns] = 1;
  return out;
}

} // namespace

int summed_columns(const ContactProblem& problem) {
  return std::min(problem.grid.mx + rolling_columns, problem.numbers.offsets);
}

ComponentFields direct_displacements(const ContactProblem& problem, const WantedDisplacements& wanted,
                                     const ComponentSpans& p, int threads) {
  const auto& [mx, ms, dx, ds, x0] = problem.grid;
  const InfluenceNumbers& a = problem.numbers;
  const int columns = summed_columns(problem);
  const bool shear = !wanted.tangential || !wanted.tangential->empty();
  double count = 0;
  for (int j = 0; j < 3; ++j)
    count += (shear ? 3.0 : 1.0) * problem.grid.size() *
             std::count_if(p[j].begin(), p[j].end(), [](double v) { return v != 0; });
  if (a.translational && count > many_plane_terms && columns == mx + rolling_columns)
    if (auto u = transformed_displacements(problem, wanted, p))
      return std::move(*u);
  ComponentFields u;
  u.fill(std::vector<double>(static_cast<std::size_t>(columns) * ms, 0.0));
  Terms terms{a, mx, columns, {}};
  for (int j = 0; j < 3; ++j)
    for (int row = 0; row < ms; ++row)
      terms.loads[j].push_back(loaded_row(p[j].data() + static_cast<std::size_t>(row) * mx, mx));
  const bool nowhere = wanted.normal && wanted.normal->empty();
  const std::vector<char> all(ms, 1), slips = rows_of(wanted.tangential, ms, columns);
  for (int i = shear ? component_x : component_n; i < (nowhere ? component_n : 3); ++i) {
    const std::vector<char>& rows = i == component_n ? all : slips;
    if (a.translational)
      add_translational(terms, i, rows, u[i].data());
    else
      in_parts(problem.grid.size() < least_threaded ? 1 : threads, a.rows,
               [&](int first, int end, int) { add_full(terms, i, rows, first, end, u[i].data()); });
  }
  return u;
}

} // namespace bem_contact::contact
