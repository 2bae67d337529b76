#include "bem_contact/contact/dissipation.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact::contact {
namespace {

/// 1. Larger influence of pressure on shear displacements that does not act back is no rounding.
constexpr double one_sided = 1e-7;

/// Maxwell's law: without it elements exchange power with what their numbers leave out. A wheel's radial
/// displacement is in its numbers as a part of the slip.
bool is_reciprocal(const ContactProblem& problem) {
  if (problem.numbers.values.empty() || problem.grid.mx < 2)
    return false;
  const int row = problem.grid.ms / 2;
  const double forth = problem.numbers.at(1, row, component_x, row, component_n),
               back = problem.numbers.at(1, row, component_n, row, component_x);
  return std::abs(forth + back) <= one_sided * problem.numbers.at(0, row, component_n, row, component_n);
}

/// How much the tractions change around each element of a patch, squared; what changes behind the contact and
/// ahead of it counts for its first and last elements. What adheres dissipates nothing, unless all of the
/// patch adheres: then slip is in a zone narrower than an element. Field.
std::vector<double> waves(const ContactProblem& problem, const ContactResult& result,
                          const std::vector<int>& elements) {
  const int mx = problem.grid.mx;
  std::vector<double> out(problem.grid.size(), 0.0);
  const auto squared = [&](int row, int ix) {
    const auto second = [&](const std::vector<double>& p) {
      const auto at = [&](int k) { return k >= 0 && k < mx ? p[std::size_t(row) * mx + k] : 0.0; };
      return at(ix - 1) - 2 * at(ix) + at(ix + 1);
    };
    return std::pow(second(result.px), 2) + std::pow(second(result.ps), 2);
  };
  const auto adheres = [&](int i) { return result.state[i] == ElementState::adhesion; };
  const bool all_adhere = std::ranges::all_of(elements, adheres);
  for (const int i : elements) {
    if (adheres(i) && !all_adhere)
      continue;
    const int row = i / mx, ix = i % mx;
    out[i] += squared(row, ix);
    for (const int beside : {ix - 1, ix + 1})
      if (beside < 0 || beside >= mx || !(result.pn[std::size_t(row) * mx + beside] > 0))
        out[i] += squared(row, beside);
  }
  return out;
}

/// Columns without contact on the side of the grid that has fewer of them.
int spare_columns(const ContactGrid& grid, const std::vector<ElementState>& state) {
  int spare = grid.mx;
  for (int i = 0; i < grid.size(); ++i)
    if (state[i] != ElementState::exterior)
      spare = std::min({spare, i % grid.mx, grid.mx - 1 - i % grid.mx});
  return spare;
}

} // namespace

double shear_drive(const ContactProblem& problem, const ContactResult& result, int i, double lateral_share) {
  const double along_x = problem.slip_x[i] + result.totals.creepage_x;
  const double along_s = problem.slip_s[i] + result.totals.creepage_s * lateral_share;
  return result.px[i] * along_x + result.ps[i] * along_s;
}

/// p_n d(h - e)/dx: where surfaces touch and beside them, h - e is the normal displacement. The difference
/// over two columns is the part of rolling_step in which no wave loses energy. All elements have the same
/// one: what pressures do on each other cancels only then, and it is large beside the sum.
double pressure_drive(const ContactProblem& problem, const ContactResult& result,
                      std::span<const int> elements) {
  const int spare = spare_columns(problem.grid, result.state);
  if (spare < 1)
    return 0;
  double sum = 0;
  for (const int i : elements) {
    const auto across = [&](int k) {
      return (problem.gap[i + k] - result.deformed_distance[i + k]) -
             (problem.gap[i - k] - result.deformed_distance[i - k]);
    };
    sum += result.pn[i] * (spare > 1 ? across(1) - 0.25 * across(2) : 0.5 * across(1));
  }
  return sum / problem.grid.dx;
}

std::vector<double> dissipated_in_slip(const ContactResult& result) {
  std::vector<double> power(result.px.size());
  for (std::size_t i = 0; i < result.slip_x.size(); ++i)
    power[i] = result.px[i] * result.slip_x[i] + result.ps[i] * result.slip_s[i];
  return power;
}

std::vector<double> dissipated(const ContactProblem& problem, const ContactResult& result) {
  std::vector<double> power = dissipated_in_slip(result);
  if (problem.motion != MotionKind::steady || !problem.has_friction() || !is_reciprocal(problem))
    return power;
  for (const std::vector<int>& elements : patch_elements(problem, result)) {
    double missing = pressure_drive(problem, result, elements), changes = 0;
    const std::vector<double> wave = waves(problem, result, elements);
    for (const int i : elements) {
      missing += shear_drive(problem, result, i, problem.lateral_share(i / problem.grid.mx)) - power[i];
      changes += wave[i];
    }
    if (missing > 0 && changes > 0)
      for (const int i : elements)
        power[i] += missing * wave[i] / changes;
  }
  return power;
}

} // namespace bem_contact::contact
