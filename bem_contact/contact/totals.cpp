#include "bem_contact/contact/totals.hpp"

#include "bem_contact/contact/grid/patches.hpp"

#include <algorithm>

namespace bem_contact {

namespace {

void sum_forces(const ContactProblem& problem, ContactResult& result) {
  ContactTotals& totals = result.totals;
  totals.Fx = totals.Fy = totals.Fz = totals.Fs = Measured{};
  totals.Mz = 0;
  const double area = problem.element_area();
  const int mx = problem.grid.mx;
  for (int is = 0; is < problem.grid.ms; ++is) {
    const ContactRow& row = problem.rows[is];
    const Point2 tangent = tangent_of(row.delta), normal = normal_of(row.delta);
    const double share = problem.lateral_share(is);
    for (int ix = 0; ix < mx; ++ix) {
      const int i = is * mx + ix;
      const double fx = result.px[i] * area;
      const Point2 f = area * (result.ps[i] * tangent + result.pn[i] * normal);
      totals.Fx.value += fx;
      totals.Fy.value += f.y;
      totals.Fz.value += f.z + problem.rise * fx;
      totals.Fs.value += result.ps[i] * area * share;
      totals.Mz += problem.grid.x(ix) * f.y - row.position.y * fx;
    }
  }
}

/// The sum over all elements.
double power_of_friction(const ContactProblem& problem, const ContactResult& result) {
  double sum = 0;
  for (const double power : friction_work_density(result))
    sum += power * problem.element_area();
  return sum;
}

} // namespace

void set_totals_of_patches(ContactResult& result) {
  ContactTotals& totals = result.totals;
  totals.pmax = totals.area = Measured{};
  for (const PatchSummary& patch : result.patches) {
    totals.pmax.value = std::max(totals.pmax.value, patch.pmax.value);
    totals.area.value += patch.area;
  }
  const ElementCounts counts = count_elements(result);
  totals.adhesion_share = {counts.contact > 0 ? double(counts.adhesion) / counts.contact : 0.0};
}

void set_totals(const ContactProblem& problem, ContactResult& result) {
  sum_forces(problem, result);
  result.patches = contact::find_patches(problem, result);
  set_totals_of_patches(result);
  result.totals.T_gamma = {power_of_friction(problem, result)};
  if (result.temperatures) {
    result.totals.Tmax_rail = {std::ranges::max(result.temperatures->rail)};
    result.totals.Tmax_wheel = {std::ranges::max(result.temperatures->wheel)};
  }
  result.trust.touches_border = contact::touches_border(problem.grid, result.state);
}

} // namespace bem_contact
