#pragma once

#include "bem_contact/profile/standard_profiles.hpp"
#include "bem_contact/profile/worn/nominal_place.hpp"

#include <cmath>
#include <vector>

namespace bem_contact {

struct Bump {
  double depth, at, width; ///< depth exp(-((s - at) / width)^2), mm
};

inline double depth_at(const std::vector<Bump>& wear, double s) {
  double sum = 0;
  for (const Bump& b : wear)
    sum += b.depth * std::exp(-std::pow((s - b.at) / b.width, 2));
  return sum;
}

/// Points of a profile, worn along its normal, then placed; one every `step` mm.
inline std::vector<Point2> worn_points(const ProfileCurve& curve, const std::vector<Bump>& wear,
                                       const NominalPlace& place, double step) {
  const double length = curve.s_end() - curve.s_begin();
  const int count = static_cast<int>(length / step);
  std::vector<Point2> out;
  for (int i = 0; i <= count; ++i) {
    const CurvePoint p = curve.at(curve.s_begin() + length * i / count);
    out.push_back(place.to_measured(p.position + depth_at(wear, p.s) * normal_of(p.delta)));
  }
  return out;
}
inline std::vector<Point2> worn_points(const char* standard, const std::vector<Bump>& wear,
                                       const NominalPlace& place, double step) {
  return worn_points(standard_profile(standard), wear, place, step);
}

} // namespace bem_contact
