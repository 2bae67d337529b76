#pragma once

#include "bem_contact/profile/read_profile.hpp"

#include <string>
#include <vector>

namespace bem_contact::app {

/// A standard profile where it lies on the unworn part of a measured one.
struct PlacedStandard {
  NominalPlace place;
  std::vector<CurvePoint> points; ///< of the standard, in the frame of the measured profile
  std::vector<double> depth;      ///< worn off it along its normal at each of these, mm; NaN: not measured
};

/// `step`: of the points, mm.
PlacedStandard placed_standard(const ProfileCurve& standard, const MeasuredProfile& measured, double step);

} // namespace bem_contact::app
