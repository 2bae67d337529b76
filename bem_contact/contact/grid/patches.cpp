#include "bem_contact/contact/grid/patches.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bem_contact::contact {
namespace {

PatchSummary summarise(const ContactProblem& problem, const ContactResult& result,
                       const std::vector<int>& elements) {
  const int mx = problem.grid.mx;
  const double area = problem.element_area();
  PatchSummary patch;
  patch.approach = -std::numeric_limits<double>::infinity();
  for (const int i : elements) {
    const ContactRow& row = problem.rows[i / mx];
    const double p = result.pn[i];
    patch.fn += p * area;
    patch.fx += result.px[i] * area;
    patch.fs += result.ps[i] * area;
    patch.approach = std::max(patch.approach, result.approach * std::cos(row.delta) - problem.gap[i]);
    patch.pmax = std::max(patch.pmax, p);
    patch.area += area;
    ++patch.contact;
    ++(result.state[i] == ElementState::adhesion ? patch.adhesion : patch.slip);
    patch.x += p * area * problem.grid.x(i % mx);
    patch.s += p * area * row.s;
  }
  patch.x /= patch.fn;
  patch.s /= patch.fn;
  return patch;
}

} // namespace

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

std::vector<PatchSummary> find_patches(const ContactProblem& problem, const ContactResult& result) {
  std::vector<PatchSummary> patches;
  for (const std::vector<int>& elements : connected_elements(problem.grid, result.state))
    patches.push_back(summarise(problem, result, elements));
  std::stable_sort(patches.begin(), patches.end(),
                   [](const PatchSummary& a, const PatchSummary& b) { return a.fn > b.fn; });
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
