#include "bem_contact/sequence/solution/track_frame.hpp"

#include <cmath>

namespace bem_contact {

namespace {

Measured scaled(const Measured& value, double by) {
  return {value.value * by, value.error * std::abs(by)};
}

/// A place in the frame, and the same in the track frame.
void move(const RailFrame& frame, double& x, Point2& p) {
  const Vector3 at = frame.point_in_track({x, p.y, p.z});
  x = at[0];
  p = {at[1], at[2]};
}

void turn_totals(const WheelOnRail& pair, ContactTotals& totals, double* slope_force) {
  const RailFrame& frame = pair.sections->frame();
  const double rise = frame.rise(), slope = slope_force ? *slope_force : 0;
  // Fz of the problem holds what shear bears of the vertical: its own part along z of the frame is without.
  const Vector3 track = frame.in_track({totals.Fx + slope, totals.Fy, totals.Fz - rise * totals.Fx});
  if (slope_force)
    *slope_force = track[0] - totals.Fx;
  totals.Fy.value = track[1];
  totals.Fz = scaled(totals.Fz, pair.upright());
  totals.approach = scaled(totals.approach, 1 / pair.upright());
}

} // namespace

void in_track_frame(const WheelOnRail& pair, SceneResult& out) {
  const RailFrame& frame = pair.sections->frame();
  out.motion.frame = frame;
  turn_totals(pair, out.result.totals, out.motion.slope_force ? &*out.motion.slope_force : nullptr);
  for (ContactResult& step : out.history)
    turn_totals(pair, step.totals, nullptr);
  for (PatchSummary& patch : out.result.patches) {
    const Vector3 force = frame.in_track({patch.fx, patch.fy, patch.fz});
    patch.fy.value = force[1];
    patch.fz.value = force[2];
    move(frame, patch.x, patch.position);
  }
  move(frame, out.motion.reference.x, out.motion.reference.position);
}

} // namespace bem_contact
