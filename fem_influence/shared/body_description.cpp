#include "fem_influence/shared/body_description.hpp"

#include "bem_contact/profile/standard_profiles.hpp"

#include <numbers>

namespace bem_contact::fem {

double reference_radius_of(const BodyFile& body) {
  if (body.body.kind == BodyKind::outline)
    return body.body.reference_radius;
  return body.body.kind == BodyKind::wheel ? wheel_reference_radius : 0.0;
}

double half_period_of(const BodyFile& body) {
  const double radius = reference_radius_of(body);
  return radius > 0 ? std::numbers::pi * radius : body.harmonic.half_period;
}

InfluenceFunction describe(const BodyFile& body, const ProfileCurve& curve, std::vector<Station> stations) {
  InfluenceFunction f;
  f.body = body_name(body);
  f.profile = curve.name();
  f.profile_digest = curve.digest();
  f.material = body.material;
  f.reference_radius = reference_radius_of(body);
  f.invariance = f.reference_radius > 0 ? Invariance::revolution : Invariance::prismatic;
  f.half_period = half_period_of(body);
  f.station_width = body.strip.station_width;
  f.stations = std::move(stations);
  return f;
}

} // namespace bem_contact::fem
