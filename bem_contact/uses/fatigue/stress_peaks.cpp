#include "bem_contact/uses/fatigue/stress_peaks.hpp"

#include "bem_contact/sequence/stresses.hpp"
#include "bem_contact/uses/fatigue/settings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace bem_contact::fatigue {

namespace {

/// 1. Points along x and along s of a patch at which the search for the largest stress begins. Stresses below
/// the surface are smoother than the tractions; twice as many found the same peaks in the tests.
constexpr int search_points = 9;
/// 1. Depths at each of these points, between the least depth and the patch's smaller side.
constexpr int search_depths = 10;
/// 1. Bound of its steps.
constexpr int most_search_steps = 200;

/// The elements in contact lie between these, mm.
struct Extent {
  double x_from = 0, x_to = 0, s_from = 0, s_to = 0;
  bool any = false;
};

Extent extent_of(const ContactProblem& problem, const ContactResult& result) {
  Extent out;
  const ContactGrid& grid = problem.grid;
  for (int i = 0; i < grid.size(); ++i) {
    if (!(result.pn[i] > 0))
      continue;
    const double x = grid.x(i % grid.mx), s = problem.rows[i / grid.mx].s;
    if (!out.any)
      out = {x, x, s, s, true};
    out.x_from = std::min(out.x_from, x);
    out.x_to = std::max(out.x_to, x);
    out.s_from = std::min(out.s_from, s);
    out.s_to = std::max(out.s_to, s);
  }
  return out;
}

std::vector<double> steps(double from, double to, int count) {
  if (from == to)
    return {from};
  std::vector<double> out(count);
  for (int i = 0; i < count; ++i)
    out[i] = from + (to - from) * i / (count - 1);
  return out;
}

/// Closer to each other near the surface.
std::vector<double> depths(double from, double to) {
  std::vector<double> out(search_depths);
  for (int i = 0; i < search_depths; ++i)
    out[i] = from * std::pow(to / from, double(i) / (search_depths - 1));
  return out;
}

using Measure = std::vector<double> StressesBelow::*;

class Search {
public:
  explicit Search(inside::SurfaceTractions tractions) : tractions_(std::move(tractions)) {}

  StressesBelow at(std::vector<double> x, std::vector<double> s, std::vector<double> depth) const {
    return stresses_below({.x = std::move(x), .s = std::move(s), .depths = std::move(depth)}, tractions_, 0);
  }

  StressPeak refine(StressPeak best, std::array<double, 3> step, double side, Measure measure) const {
    const double top = least_depth * side;
    for (int i = 0; i<most_search_steps&& * std::ranges::max_element(step)> last_step * side; ++i) {
      const StressPeak before = best;
      for (int d = 0; d < 3; ++d)
        for (const double sign : {-1.0, 1.0}) {
          const std::array<double, 3> at_point{before.x + (d == 0 ? sign * step[0] : 0),
                                               before.s + (d == 1 ? sign * step[1] : 0),
                                               std::max(top, before.depth + (d == 2 ? sign * step[2] : 0))};
          const double stress = (at({at_point[0]}, {at_point[1]}, {at_point[2]}).*measure)[0];
          if (stress > best.stress)
            best = {stress, at_point[0], at_point[1], at_point[2]};
        }
      if (best.stress == before.stress)
        for (double& one : step)
          one /= 2;
    }
    return best;
  }

private:
  inside::SurfaceTractions tractions_;
};

StressPeak largest(const StressesBelow& b, Measure measure) {
  const auto& values = b.*measure;
  const std::size_t at = std::ranges::max_element(values) - values.begin();
  const std::size_t nd = b.depths.size(), ns = b.s.size();
  return {values[at], b.x[at / nd / ns], b.s[at / nd % ns], b.depths[at % nd]};
}

} // namespace

StressPeaks stress_peaks(const ContactProblem& problem, const ContactResult& result, double poisson) {
  const Extent contact = extent_of(problem, result);
  if (!contact.any)
    return {};
  const ContactGrid& grid = problem.grid;
  const double side = problem.plane_strain() ? grid.ds : std::min(grid.dx, grid.ds);
  const double wide_x = contact.x_to - contact.x_from + grid.dx,
               wide_s = contact.s_to - contact.s_from + grid.ds;
  const double deep =
      std::max(2 * least_depth * side, problem.plane_strain() ? wide_s : std::min(wide_x, wide_s));
  const Search search(surface_tractions(problem, result, poisson));
  const StressesBelow lattice =
      search.at(steps(contact.x_from, contact.x_to, search_points),
                steps(contact.s_from, contact.s_to, search_points), depths(least_depth * side, deep));
  const std::array<double, 3> step{problem.plane_strain() ? 0 : wide_x / search_points / 2,
                                   wide_s / search_points / 2, deep / search_depths / 2};
  const auto peak = [&](Measure measure) {
    return search.refine(largest(lattice, measure), step, side, measure);
  };
  return {peak(&StressesBelow::von_mises), peak(&StressesBelow::largest_shear)};
}

StressPeaks stress_peaks(const inside::StressesInside& inside, bool of_halfspace, double depth) {
  const auto largest_of = [&](double (*measure)(const halfspace::Stress&)) {
    StressPeak best;
    for (const inside::AreaStresses& area : inside.areas) {
      const std::vector<inside::Passage>& stresses = of_halfspace ? area.flat : area.best();
      for (std::size_t i = 0; i < area.points.size(); ++i)
        for (std::size_t j = 0; j < area.x.size() && area.points[i].depth >= depth; ++j)
          if (const halfspace::Stress& t = stresses[i][j]; std::isfinite(t.xx))
            if (const double stress = measure(t); stress > best.stress)
              best = {stress, area.x[j], area.points[i].s, area.points[i].depth};
    }
    return best;
  };
  return {largest_of(halfspace::von_mises), largest_of(halfspace::largest_shear)};
}

} // namespace bem_contact::fatigue
