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

} // namespace

double shear_drive(const ContactProblem& problem, const ContactResult& result, int i, double lateral_share) {
  const double along_x = problem.slip_x[i] + result.totals.creepage_x;
  const double along_s = problem.slip_s[i] + result.totals.creepage_s * lateral_share;
  return result.px[i] * along_x + result.ps[i] * along_s;
}

/// p_n d(h - e)/dx: where surfaces touch and beside them, h - e is the normal displacement. The difference is
/// the part of rolling_step in which no wave loses energy.
double pressure_drive(const ContactProblem& problem, const ContactResult& result, int i) {
  const int ix = i % problem.grid.mx;
  if (ix < 2 || ix + 2 >= problem.grid.mx)
    return 0;
  const auto h = [&](int k) { return problem.gap[i + k] - result.deformed_distance[i + k]; };
  return result.pn[i] * (h(1) - h(-1) - 0.25 * (h(2) - h(-2))) / problem.grid.dx;
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
    double missing = 0, changes = 0;
    const std::vector<double> wave = waves(problem, result, elements);
    for (const int i : elements) {
      missing += shear_drive(problem, result, i, problem.lateral_share(i / problem.grid.mx)) +
                 pressure_drive(problem, result, i) - power[i];
      changes += wave[i];
    }
    if (missing > 0 && changes > 0)
      for (const int i : elements)
        power[i] += missing * wave[i] / changes;
  }
  return power;
}

} // namespace bem_contact::contact
