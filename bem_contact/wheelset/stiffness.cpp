#include "bem_contact/wheelset/stiffness.hpp"

#include "bem_contact/wheelset/settings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bem_contact {

namespace {

/// dFx over the longitudinal creepage, N.
double creep_slope(const PatchSummary& p, const SceneResult& r, const SceneFile& scene) {
  const double shear_modulus =
      2 / (1 / scene.rail.material.shear_modulus + 1 / scene.wheel.material.shear_modulus);
  const double bound = r.problem.largest_friction() * p.fn;
  const double used = std::min(1.0, std::hypot(p.fx, p.fs) / bound);
  return kalker_c11 * shear_modulus * p.area / std::numbers::pi *
         std::max(least_creep_slope, std::pow(1 - used, 2.0 / 3));
}

/// Of one wheel, in the frame of its side.
WheelsetStiffness stiffness_of_wheel(const SceneResult& r, Point2 centre, const WheelsetState& state,
                                     const SceneFile& scene) {
  WheelsetStiffness out;
  for (const PatchSummary& p : r.result.patches) {
    const Point2 across = p.position - centre;
    const Vector3 arm{p.x, across.y, across.z};
    const Wrench force = wrench_at({p.fx, p.fy, p.fz}, arm);
    const double by_height = hertz_exponent * std::cos(p.delta) / p.approach;
    const double lever = across.y + across.z * std::tan(p.delta); // of the normal, over its vertical part
    out.by_height += by_height * force;
    out.by_roll += by_height * lever * force;
    if (state.pose.rolling_radius) {
      const double creepage = across.z / std::pow(*state.pose.rolling_radius, 2); // xi = 1 - r / R
      out.by_rolling_radius += wrench_at({creep_slope(p, r, scene) * creepage, 0, 0}, arm);
    }
  }
  return out;
}

} // namespace

WheelsetStiffness stiffness_of(const WheelsetState& state, const SceneFile& scene) {
  const double y = state.pose.lateral, z = state.pose.vertical - state.wheel_radius;
  WheelsetStiffness out = stiffness_of_wheel(state.right, {y, z}, state, scene);
  const WheelsetStiffness left = stiffness_of_wheel(state.left, {-y, z}, state, scene);
  out.by_height += mirrored(left.by_height);
  out.by_roll += -1 * mirrored(left.by_roll); // the mirror image rolls the other way
  out.by_rolling_radius += mirrored(left.by_rolling_radius);
  return out;
}

} // namespace bem_contact
