#include "bem_contact/geometry/rail_frame.hpp"

#include <cmath>

namespace bem_contact {

RailFrame::RailFrame(const Vector3& about, const Vector3& direction) : origin(about) {
  const double level = std::hypot(direction[0], direction[1]), length = std::hypot(level, direction[2]);
  const double cosine = level / length, sine = direction[2] / length;
  const double forward = direction[0] / level, aside = direction[1] / level;
  along = {cosine * forward, cosine * aside, sine};
  across = {-aside, forward, 0};
  into = {-sine * forward, -sine * aside, cosine};
}

Vector3 RailFrame::seen(const Vector3& v) const {
  return {dot(along, v), dot(across, v), dot(into, v)};
}

Vector3 RailFrame::in_track(const Vector3& v) const {
  Vector3 out;
  for (int i = 0; i < 3; ++i)
    out[i] = v[0] * along[i] + v[1] * across[i] + v[2] * into[i];
  return out;
}

Vector3 RailFrame::seen_point(const Vector3& p) const {
  const Vector3 v = seen(between(origin, p));
  return {origin[0] + v[0], origin[1] + v[1], origin[2] + v[2]};
}

Vector3 RailFrame::point_in_track(const Vector3& p) const {
  const Vector3 v = in_track(between(origin, p));
  return {origin[0] + v[0], origin[1] + v[1], origin[2] + v[2]};
}

WheelFrame RailFrame::wheel(const WheelFrame& f) const {
  return {seen_point(f.centre), seen(f.forward), seen(f.axle), seen(f.down)};
}

} // namespace bem_contact
