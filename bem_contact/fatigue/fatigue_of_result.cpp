#include "bem_contact/fatigue/fatigue_of_result.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/sequence/scene_result.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bem_contact::fatigue {

namespace {

/// The elements of each connected area (8 neighbours) that bears pressure.
std::vector<std::vector<int>> connected_areas(const ContactGrid& grid, const std::vector<double>& pn) {
  std::vector<char> seen(grid.size(), 0);
  std::vector<std::vector<int>> areas;
  for (int first = 0; first < grid.size(); ++first) {
    if (!(pn[first] > 0) || std::exchange(seen[first], 1))
      continue;
    std::vector<int>& area = areas.emplace_back(1, first);
    for (std::size_t k = 0; k < area.size(); ++k) {
      const int ix = area[k] % grid.mx, is = area[k] / grid.mx;
      for (int js = std::max(0, is - 1); js <= std::min(grid.ms - 1, is + 1); ++js)
        for (int jx = std::max(0, ix - 1); jx <= std::min(grid.mx - 1, ix + 1); ++jx)
          if (const int other = js * grid.mx + jx; pn[other] > 0 && !std::exchange(seen[other], 1))
            area.push_back(other);
    }
  }
  return areas;
}

struct Loads {
  const SceneResult& solved;
  const FatigueProperties& properties;
  std::vector<double> power; ///< friction power; field
  std::vector<double> index; ///< field

  PatchFatigue patch(const std::vector<int>& elements) const {
    const ContactResult& r = solved.result;
    const double area = solved.problem.element_area();
    PatchFatigue out;
    out.largest_index = index[elements.front()];
    double fx = 0, fs = 0;
    for (const int i : elements) {
      const ContactRow& row = solved.problem.rows[i / solved.problem.grid.mx];
      out.normal_force += r.pn[i] * area;
      out.s += r.pn[i] * area * row.s;
      out.y += r.pn[i] * area * row.position.y;
      fx += r.px[i] * area;
      fs += r.ps[i] * area;
      out.pmax = std::max(out.pmax, r.pn[i]);
      out.t_gamma += power[i] * area;
      out.largest_index = std::max(out.largest_index, index[i]);
    }
    out.s /= out.normal_force;
    out.y /= out.normal_force;
    out.point = {out.pmax / properties.yield_shear, std::hypot(fx, fs) / out.normal_force};
    out.surface_index = surface_index(out.point);
    out.damage = damage_of(properties.damage, out.t_gamma);
    return out;
  }
};

std::vector<double> index_of_elements(const ContactResult& r, double yield_shear) {
  std::vector<double> out(r.pn.size(), element_index(0, 1e-300, yield_shear));
  for (std::size_t i = 0; i < out.size(); ++i)
    if (r.pn[i] > 0)
      out[i] = element_index(std::hypot(r.px[i], r.ps[i]), r.pn[i], yield_shear);
  return out;
}

} // namespace

Fatigue fatigue_of(const SceneResult& solved, const FatigueProperties& properties) {
  require_yield_shear(properties.yield_shear);
  validate(properties.damage);
  const ContactResult& r = solved.result;
  if (!r.converged)
    throw InputError("There is no fatigue of a result that did not converge",
                     "its tractions are not a solution", "Solve the scene first.");
  Loads loads{solved, properties, friction_power(r), index_of_elements(r, properties.yield_shear)};
  if (solved.problem.motion == MotionKind::shift)
    std::ranges::fill(loads.power, 0.0); // it is work by area there, not power
  Fatigue out;
  for (const std::vector<int>& area : connected_areas(solved.problem.grid, r.pn))
    out.patches.push_back(loads.patch(area));
  std::ranges::stable_sort(out.patches, std::greater<>(), &PatchFatigue::normal_force);
  out.element_index = std::move(loads.index);
  if (properties.stresses && !out.patches.empty())
    out.peaks = stress_peaks(solved.problem, r, properties.poisson);
  return out;
}

} // namespace bem_contact::fatigue
