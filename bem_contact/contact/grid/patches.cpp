#include "bem_contact/contact/grid/patches.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace bem_contact::contact {
namespace {

/// Moments of the tractions about the centre of pressure, turned into the directions x, s, n there.
void add_moments(const ContactProblem& problem, const ContactResult& result, const std::vector<int>& elements,
                 PatchSummary& patch) {
  const int mx = problem.grid.mx;
  const double area = problem.element_area();
  double about_y = 0, about_z = 0;
  for (const int i : elements) {
    const ContactRow& row = problem.rows[i / mx];
    const double x = problem.grid.x(i % mx) - patch.x;
    const Point2 arm = row.position - patch.position;
    const double fx = result.px[i] * area;
    const Point2 f = area * (result.ps[i] * tangent_of(row.delta) + result.pn[i] * normal_of(row.delta));
    patch.fy.value += f.y;
    patch.fz.value += f.z;
    patch.moment_x += cross(arm, f);
    about_y += arm.z * fx - x * f.z;
    about_z += x * f.y - arm.y * fx;
  }
  const Point2 about{about_y, about_z};
  patch.moment_s = dot(about, tangent_of(patch.delta));
  patch.moment_n.value = dot(about, normal_of(patch.delta));
}

/// Second moments of the pressure about its centre, over its sum, mm^2.
struct SecondMoments {
  double xx = 0, ss = 0, xs = 0;
};

SecondMoments second_moments(const ContactProblem& problem, const ContactResult& result,
                             const std::vector<int>& elements, const PatchSummary& patch) {
  const ContactGrid& grid = problem.grid;
  SecondMoments m{grid.dx * grid.dx / 12, grid.ds * grid.ds / 12, 0}; // of each element about its own middle
  for (const int i : elements) {
    const double share = result.pn[i] * problem.element_area() / patch.fn;
    const double x = grid.x(i % grid.mx) - patch.x, s = problem.rows[i / grid.mx].s - patch.s;
    m.xx += share * x * x;
    m.ss += share * s * s;
    m.xs += share * x * s;
  }
  return m;
}

/// Hertz's pressure on an ellipse with semi-axes a, b has the second moments a^2/5, b^2/5 over its sum, on a
/// strip b^2/4. Second moments of the area would change by leaps, with whole elements.
void add_ellipse(const ContactProblem& problem, const SecondMoments& m, PatchSummary& patch) {
  if (problem.plane_strain()) {
    patch.semi_axis_a = std::numeric_limits<double>::quiet_NaN();
    patch.semi_axis_b = std::sqrt(4 * m.ss);
    return;
  }
  const double mean = 0.5 * (m.xx + m.ss), difference = 0.5 * (m.xx - m.ss);
  const double deviation = std::hypot(difference, m.xs);
  constexpr double rounding = 1e-12; // of the sums: a circle has no axes
  // Half of the angle to the larger axis; that of the axis nearest to x has |angle| <= pi/4.
  const bool larger_along_x = difference >= 0;
  patch.semi_axis_a = std::sqrt(5 * (mean + (larger_along_x ? deviation : -deviation)));
  patch.semi_axis_b = std::sqrt(5 * (mean - (larger_along_x ? deviation : -deviation)));
  if (deviation > rounding * mean)
    patch.axis_angle = 0.5 * std::atan2(larger_along_x ? m.xs : -m.xs, std::abs(difference));
}

PatchSummary summarise(const ContactProblem& problem, const ContactResult& result,
                       const std::vector<double>& power, const std::vector<int>& elements) {
  const int mx = problem.grid.mx;
  const double area = problem.element_area();
  PatchSummary patch;
  patch.overlap.value = -std::numeric_limits<double>::infinity();
  for (const int i : elements) {
    const ContactRow& row = problem.rows[i / mx];
    const double p = result.pn[i];
    patch.fn.value += p * area;
    patch.fx.value += result.px[i] * area;
    patch.fs.value += result.ps[i] * area;
    patch.T_gamma.value += power[i] * area;
    patch.overlap.value =
        std::max(patch.overlap.value, result.totals.approach * std::cos(row.delta) - problem.gap[i]);
    patch.pmax.value = std::max(patch.pmax.value, p);
    patch.area.value += area;
    ++patch.contact;
    ++(result.state[i] == ElementState::adhesion ? patch.adhesion : patch.slip);
    patch.x += p * area * problem.grid.x(i % mx);
    patch.s += p * area * row.s;
  }
  patch.x /= patch.fn;
  patch.s /= patch.fn;
  const ContactRow centre = row_at(problem, patch.s);
  patch.position = centre.position;
  patch.delta = centre.delta;
  add_moments(problem, result, elements, patch);
  add_ellipse(problem, second_moments(problem, result, elements, patch), patch);
  return patch;
}

/// The elements of each connected area (8 neighbours) of state != exterior, in no order.
std::vector<std::vector<int>> connected_elements(const ContactGrid& grid,
                                                 const std::vector<ElementState>& state) {
  const int mx = grid.mx, ms = grid.ms;
  std::vector<char> seen(grid.size(), 0);
  std::vector<std::vector<int>> areas;
  for (int start = 0; start < grid.size(); ++start) {
    if (seen[start] || state[start] == ElementState::exterior)
      continue;
    std::vector<int> elements{start};
    seen[start] = 1;
    for (std::size_t k = 0; k < elements.size(); ++k) {
      const int ix = elements[k] % mx, is = elements[k] / mx;
      for (int js = std::max(is - 1, 0); js <= std::min(is + 1, ms - 1); ++js)
        for (int jx = std::max(ix - 1, 0); jx <= std::min(ix + 1, mx - 1); ++jx) {
          const int neighbour = js * mx + jx;
          if (!seen[neighbour] && state[neighbour] != ElementState::exterior) {
            seen[neighbour] = 1;
            elements.push_back(neighbour);
          }
        }
    }
    areas.push_back(std::move(elements));
  }
  return areas;
}

} // namespace

std::vector<PatchSummary> find_patches(const ContactProblem& problem, const ContactResult& result) {
  const std::vector<double> power = friction_work_density(result);
  std::vector<PatchSummary> patches;
  for (const std::vector<int>& elements : patch_elements(problem, result))
    patches.push_back(summarise(problem, result, power, elements));
  return patches;
}

bool touches_border(const ContactGrid& grid, const std::vector<ElementState>& state) {
  for (int i = 0; i < grid.size(); ++i) {
    const int ix = i % grid.mx, is = i / grid.mx;
    const bool at_edge =
        (grid.mx > 1 && (ix == 0 || ix == grid.mx - 1)) || (grid.ms > 1 && (is == 0 || is == grid.ms - 1));
    if (at_edge && state[i] != ElementState::exterior)
      return true;
  }
  return false;
}

} // namespace bem_contact::contact

namespace bem_contact {

std::vector<std::vector<int>> patch_elements(const ContactProblem& problem, const ContactResult& result) {
  const double area = problem.element_area();
  std::vector<std::pair<double, std::vector<int>>> patches; // with their normal forces
  for (std::vector<int>& elements : contact::connected_elements(problem.grid, result.state)) {
    double fn = 0;
    for (const int i : elements)
      fn += result.pn[i] * area;
    patches.emplace_back(fn, std::move(elements));
  }
  std::ranges::stable_sort(patches, std::greater<>(), &std::pair<double, std::vector<int>>::first);
  std::vector<std::vector<int>> out;
  for (auto& [fn, elements] : patches)
    out.push_back(std::move(elements));
  return out;
}

} // namespace bem_contact
