#include "bem_contact/sequence/stresses.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace bem_contact {

namespace {

/// 1. Most points at which stresses are computed: some minutes.
constexpr double most_stress_points = 1e6;
/// 1. Most products of points and elements: some minutes.
constexpr double most_stress_sums = 1e9;
/// 1 (widths). Half length of a plane-strain element where stresses are summed.
constexpr double endless_element = 1e6;

void require_few(const SceneFile::Stresses& asked, const inside::SurfaceTractions& tractions) {
  const std::size_t points = asked.x.size() * asked.s.size() * asked.depths.size();
  if (double(points) > most_stress_points)
    throw InputError("Too many stresses below the surface are asked for",
                     fmt::format("{} x {} x {} points", asked.x.size(), asked.s.size(), asked.depths.size()),
                     "Ask for at most a million of them.");
  const auto loaded = std::ranges::count_if(tractions.pn, [](double p) { return p > 0; });
  if (double(points) * double(loaded) > most_stress_sums)
    throw InputError("Too many stresses below the surface are asked for",
                     fmt::format("{} points under {} elements in contact", points, loaded),
                     "Ask for fewer points, or give larger elements.");
}

} // namespace

void StressField::add(const halfspace::Stress& t) {
  stress.push_back(t);
  von_mises.push_back(halfspace::von_mises(t));
  largest_shear.push_back(halfspace::largest_shear(t));
}

inside::SurfaceTractions surface_tractions(const ContactProblem& problem, const ContactResult& result,
                                           double poisson) {
  const ContactGrid& grid = problem.grid;
  inside::SurfaceTractions out{.dx = problem.plane_strain() ? 2 * endless_element * grid.ds : grid.dx,
                               .ds = grid.ds,
                               .x0 = grid.x0,
                               .columns = grid.mx,
                               .px = result.px,
                               .ps = result.ps,
                               .pn = result.pn,
                               .poisson = poisson};
  for (const ContactRow& row : problem.rows)
    out.s.push_back(row.s);
  out.px.resize(out.pn.size()); // empty without friction
  out.ps.resize(out.pn.size());
  return out;
}

StressesBelow stresses_below(const SceneFile::Stresses& asked, const inside::SurfaceTractions& tractions,
                             double reference_s) {
  require_few(asked, tractions);
  StressesBelow out{{}, asked.x, asked.s, asked.depths, {}};
  for (double& s : out.s)
    s += reference_s;
  for (const double x : out.x)
    for (const double s : out.s)
      for (const double depth : out.depths)
        out.add(inside::halfspace_stress(tractions, {s, depth}, x));
  return out;
}

StressesInBody stresses_in_body(const SceneFile::Stresses& asked, std::vector<double> s,
                                const inside::SurfaceTractions& tractions, inside::Side side,
                                const inside::FileOfStresses& file) {
  inside::AreaStresses area;
  area.x = asked.x;
  for (const double at : s)
    for (const double depth : asked.depths) {
      area.points.push_back({at, depth});
      inside::Passage& passage = area.flat.emplace_back();
      for (const double x : asked.x)
        passage.push_back(inside::halfspace_stress(tractions, area.points.back(), x));
    }
  inside::StressesInside all;
  all.side = side;
  all.poisson = tractions.poisson;
  all.areas.push_back(std::move(area));
  inside::add_stresses_by_file(all, tractions, file.strip, file.kernel);
  const inside::AreaStresses& found = all.areas.front();
  StressesInBody out{side, all.body, std::move(s), {}, {}, found.error};
  for (std::size_t place = 0; place < asked.x.size(); ++place)
    for (std::size_t point = 0; point < found.points.size(); ++point) {
      out.in_body.add(found.body[point][place]);
      out.halfspace.add(found.flat[point][place]);
    }
  return out;
}

} // namespace bem_contact
