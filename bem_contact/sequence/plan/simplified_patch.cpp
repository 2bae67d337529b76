#include "bem_contact/sequence/plan/simplified_patch.hpp"

#include "bem_contact/contact/totals.hpp"
#include "bem_contact/reference/creep_coefficients.hpp"
#include "bem_contact/reference/hertz.hpp"
#include "bem_contact/sequence/plan/contact_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace bem_contact {

namespace {

/// 1. Ratios of the semi-axes for which there are creep coefficients (reference/creep_coefficients.hpp);
/// beyond them the nearest are taken.
constexpr double flattest = 0.1, longest = 10;

/// Flexibilities of a patch.
void set_flexibilities(const ContactSetup& setup, const SurfaceLayer& layer, int row,
                       SimplifiedPatch& patch) {
  const Material &one = setup.rail.material, &other = setup.wheel.material;
  const double shear = 2 / (1 / one.shear_modulus + 1 / other.shear_modulus),
               poisson =
                   0.5 * shear * (one.poisson / one.shear_modulus + other.poisson / other.shear_modulus);
  const double a = patch.semi_axis_x, ratio = std::clamp(a / patch.semi_axis_s, flattest, longest);
  const auto [c11, c22, c23] = reference::quick_creep_coefficients(ratio, poisson);
  const double compliance = layer.shear_of(row);
  patch.of_xi = 8 * a / (3 * c11 * shear) + compliance;
  patch.of_eta = 8 * a / (3 * c22 * shear) + compliance;
  patch.of_phi = std::numbers::pi * a * std::sqrt(a / patch.semi_axis_s) / (4 * c23 * shear) + compliance;
}

/// Where the undeformed distance of a row is least, mm: the vertex of a parabola through the three elements
/// about it. A shift along x of half an element is as much as a creepage.
double nearest_x(const ContactProblem& problem, int row) {
  const ContactGrid& grid = problem.grid;
  const double* h = problem.gap.data() + static_cast<std::size_t>(row) * grid.mx;
  const int ix = std::clamp(static_cast<int>(std::min_element(h, h + grid.mx) - h), 1, grid.mx - 2);
  const double bend = h[ix - 1] - 2 * h[ix] + h[ix + 1];
  const double off = bend > 0 ? std::clamp(0.5 * (h[ix - 1] - h[ix + 1]) / bend, -1.0, 1.0) : 0.0;
  return grid.x(ix) + off * grid.dx;
}

} // namespace

std::vector<SimplifiedPatch> simplified_patches(const ContactSetup& setup, const ContactProblem& problem) {
  const double modulus = reference::contact_modulus(setup.rail.material, setup.wheel.material);
  const PairCompliance compliance = pair_compliance(setup);
  const SurfaceLayer layer = setup.layer.on(problem.rows);
  std::vector<SimplifiedPatch> out;
  const std::optional<ContactEstimate> estimate = estimate_contact(problem, compliance);
  if (!estimate)
    return out;
  for (const EstimatedArea& area : estimated_areas(*estimate, compliance)) {
    const double along = std::sqrt(area.depth / area.half),
                 across = area.overlap / (std::numbers::pi * along);
    if (!(area.normal > 0) || !(across > 0))
      continue;
    SimplifiedPatch patch{.x = area.x, .s = area.s, .normal = area.normal, .delta = area.delta};
    patch.curvature_x = area.half;
    patch.curvature_s = area.depth / (across * across);
    const auto hertz = reference::hertz_by_force(patch.curvature_x, patch.curvature_s, modulus, area.normal);
    patch.semi_axis_x = hertz.semi_axis_x;
    patch.semi_axis_s = hertz.semi_axis_s;
    patch.pressure = hertz.max_pressure;
    patch.approach = hertz.approach;
    const int row = static_cast<int>(std::lround(row_index(problem, patch.s)));
    patch.x = nearest_x(problem, row);
    set_flexibilities(setup, layer, row, patch);
    out.push_back(patch);
  }
  std::ranges::sort(out, std::greater(), &SimplifiedPatch::normal);
  return out;
}

double radius_in(const SimplifiedPatch& patch, double x, double s) {
  return std::hypot((x - patch.x) / patch.semi_axis_x, (s - patch.s) / patch.semi_axis_s);
}

std::vector<std::vector<int>> elements_of_patches(const ContactProblem& problem,
                                                  const std::vector<SimplifiedPatch>& patches) {
  const ContactGrid& grid = problem.grid;
  std::vector<std::vector<int>> out(patches.size());
  for (int is = 0; is < grid.ms; ++is)
    for (int ix = grid.mx - 1; ix >= 0; --ix)
      for (std::size_t k = 0; k < patches.size(); ++k)
        if (radius_in(patches[k], grid.x(ix), problem.rows[is].s) < 1) {
          out[k].push_back(is * grid.mx + ix);
          break;
        }
  return out;
}

PatchCreepage patch_creepage(const ContactProblem& problem, const SimplifiedPatch& patch,
                             const std::vector<int>& elements) {
  PatchCreepage out;
  double x_mean = 0, s_mean = 0, turning = 0, squares = 0;
  const double n = double(elements.size());
  for (const int i : elements) {
    out.xi += problem.slip_x[i] / n;
    out.eta += problem.slip_s[i] / n;
    x_mean += (problem.grid.x(i % problem.grid.mx) - patch.x) / n;
    s_mean += (problem.rows[i / problem.grid.mx].s - patch.s) / n;
  }
  for (const int i : elements) {
    const double x = problem.grid.x(i % problem.grid.mx) - patch.x - x_mean,
                 s = problem.rows[i / problem.grid.mx].s - patch.s - s_mean;
    turning += x * (problem.slip_s[i] - out.eta) - s * (problem.slip_x[i] - out.xi);
    squares += x * x + s * s;
  }
  out.phi = turning / squares;
  out.xi += out.phi * s_mean;
  out.eta -= out.phi * x_mean;
  return out;
}

} // namespace bem_contact
