#pragma once

#include "bem_contact/base/normal_draws.hpp"
#include "bem_contact/profile/profile_curve.hpp"

#include <vector>

namespace bem_contact {

/// The profile as an instrument with this noise (standard deviation along the normal, mm) might measure it:
/// points some 0.2 mm apart, in walking order.
std::vector<Point2> noisy_points(const ProfileCurve& curve, double noise, NormalDraws& draws);

/// The wavelength with which such points are smoothed, mm: `smoothing` if it is above 0, else what their own
/// noise asks for (measure_noise()); 0: none.
double smoothing_of(const std::vector<Point2>& points, double smoothing);

/// The curve that is read of such points, smoothed so.
ProfileCurve noisy_profile(const ProfileCurve& curve, double noise, double smoothing, NormalDraws& draws);

} // namespace bem_contact
