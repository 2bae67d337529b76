#include "bem_contact/fatigue/fatigue_of_result.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/sequence/scene_result.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact::fatigue {

namespace {

/// `largest_index`: of the elements of the patch.
PatchFatigue fatigue_of_patch(const PatchSummary& patch, double largest_index, bool power,
                              const FatigueProperties& properties) {
  PatchFatigue out;
  out.s = patch.s;
  out.y = patch.position.y;
  out.normal_force = patch.fn;
  out.pmax = patch.pmax;
  out.point = {patch.pmax / properties.yield_shear, std::hypot(patch.fx, patch.fs) / patch.fn};
  out.surface_index = surface_index(out.point);
  out.largest_index = largest_index;
  out.t_gamma = power ? patch.friction_power : 0.0;
  out.damage = damage_of(properties.damage, out.t_gamma);
  return out;
}

std::vector<double> index_of_elements(const ContactResult& r, double yield_shear) {
  std::vector<double> out(r.pn.size(), least_element_index);
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
  const bool power = solved.problem.motion != MotionKind::shift; // it is work by area there
  Fatigue out;
  out.element_index = index_of_elements(r, properties.yield_shear);
  const std::vector<std::vector<int>> elements = patch_elements(solved.problem, r);
  for (std::size_t k = 0; k < r.patches.size(); ++k) {
    double largest = least_element_index;
    if (k < elements.size()) // a small Hertz contact may have none
      for (const int i : elements[k])
        largest = std::max(largest, out.element_index[i]);
    out.patches.push_back(fatigue_of_patch(r.patches[k], largest, power, properties));
  }
  if (properties.stresses && !out.patches.empty())
    out.peaks = stress_peaks(solved.problem, r, properties.poisson);
  return out;
}

} // namespace bem_contact::fatigue
