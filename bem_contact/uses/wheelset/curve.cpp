#include "bem_contact/uses/wheelset/curve.hpp"

#include "bem_contact/base/gravity.hpp"

namespace bem_contact {

CurveDemand curve_demand(const SceneFile& scene) {
  const SceneFile::Track& track = scene.track;
  if (!track.curve_radius)
    return {};
  const double speed = scene.motion.speed.value_or(0), right = *track.curve_radius > 0 ? 1 : -1;
  // Outwards is to the left where the centre is to the right.
  const double lean = right * track.superelevation / track.base;
  return {-*scene.wheelset.force * (speed * speed * track.curvature() / standard_gravity - lean),
          -scene.position.wheel_radius * track.base * track.curvature()};
}

SceneFile with_curve_force(SceneFile scene) {
  if (scene.track.curve_radius && scene.wheelset.force_y)
    *scene.wheelset.force_y += curve_demand(scene).force;
  return scene;
}

} // namespace bem_contact
