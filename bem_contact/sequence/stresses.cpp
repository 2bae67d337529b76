#include "bem_contact/sequence/stresses.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace bem_contact {

namespace {

/// 1. Most points at which stresses are computed: some minutes.
constexpr double most_stress_points = 1e6;
/// 1. Most products of points and elements: some minutes.
constexpr double most_stress_sums = 1e9;
/// 1 (widths). Half length of a plane-strain element where stresses are summed.
constexpr double endless_element = 1e6;

} // namespace
StressesBelow stresses_below(const SceneFile::Stresses& asked, const ContactProblem& problem,
                             const ContactResult& result, double poisson, double reference_s) {
  const std::size_t points = asked.x.size() * asked.s.size() * asked.depths.size();
  if (double(points) > most_stress_points)
    throw InputError("Too many stresses below the surface are asked for",
                     fmt::format("{} x {} x {} points", asked.x.size(), asked.s.size(), asked.depths.size()),
                     "Ask for at most a million of them.");
  const auto loaded = std::count_if(result.pn.begin(), result.pn.end(), [](double p) { return p > 0; });
  if (double(points) * double(loaded) > most_stress_sums)
    throw InputError("Too many stresses below the surface are asked for",
                     fmt::format("{} points under {} elements in contact", points, loaded),
                     "Ask for fewer points, or give larger elements.");
  StressesBelow out{asked.x, asked.s, asked.depths, {}, {}, {}};
  for (double& s : out.s)
    s += reference_s;
  const ContactGrid& grid = problem.grid;
  const double a = problem.plane_strain() ? endless_element * grid.ds : 0.5 * grid.dx, b = 0.5 * grid.ds;
  out.stress.reserve(points);
  for (const double x : out.x)
    for (const double s : out.s)
      for (const double depth : out.depths) {
        halfspace::Stress sum;
        for (int i = 0; i < grid.size(); ++i) {
          if (!(result.pn[i] > 0))
            continue;
          const auto unit = halfspace::rectangle_stress(poisson, x - grid.x(i % grid.mx),
                                                        s - problem.rows[i / grid.mx].s, depth, a, b);
          sum.add(result.px[i], unit[component_x])
              .add(result.ps[i], unit[component_s])
              .add(result.pn[i], unit[component_n]);
        }
        out.stress.push_back(sum);
        out.von_mises.push_back(von_mises(sum));
        out.largest_shear.push_back(largest_shear(sum));
      }
  return out;
}

} // namespace bem_contact
