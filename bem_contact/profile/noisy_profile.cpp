#include "bem_contact/profile/noisy_profile.hpp"

#include "bem_contact/profile/measured/profile_noise.hpp"
#include "bem_contact/profile/measured/profile_smoothing.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact {

namespace {

/// mm. Distance of the points: instruments measure about as densely.
constexpr double drawn_spacing = 0.2;

} // namespace

std::vector<Point2> noisy_points(const ProfileCurve& curve, double noise, NormalDraws& draws) {
  const double length = curve.s_end() - curve.s_begin();
  const int steps = std::max(8, static_cast<int>(length / drawn_spacing));
  std::vector<Point2> out;
  for (int i = 0; i <= steps; ++i) {
    const CurvePoint at = curve.at(i == steps ? curve.s_end() : curve.s_begin() + length * i / steps);
    const double off = noise * draws.next();
    out.push_back({at.position.y - off * std::sin(at.delta), at.position.z + off * std::cos(at.delta)});
  }
  return out;
}

double smoothing_of(const std::vector<Point2>& points, double smoothing) {
  return smoothing > 0 ? smoothing : measure_noise(points).smoothing;
}

ProfileCurve noisy_profile(const ProfileCurve& curve, double noise, double smoothing, NormalDraws& draws) {
  const std::vector<Point2> points = noisy_points(curve, noise, draws);
  const double wavelength = smoothing_of(points, smoothing);
  if (wavelength == 0)
    return ProfileCurve::through_points(curve.name(), points);
  const SmoothedProfile smooth = smoothed(points, wavelength);
  return ProfileCurve::through_points(curve.name(), smooth.points, smooth.kinks);
}

} // namespace bem_contact
