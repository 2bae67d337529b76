#pragma once

#include "bem_contact/base/conventions.hpp"

#include <span>

namespace bem_contact {

/// How far measured points scatter, and what that does to a curve through all of them.
struct ProfileNoise {
  double scatter = 0; ///< standard deviation of a point from the profile, along its normal, mm
  double spacing = 0; ///< median distance of neighbouring points, mm
  double waves = 0;   ///< standard deviation of waves of 2 to 10 mm besides, mm; 0: none are told from shape
  /// Scatter of points as far apart, without waves, which would be as strong at 10 mm, mm.
  double as_white = 0;
  /// The points are too far apart for a curved profile, and scatter cannot be told from shape.
  bool coarse = false;
  double slope = 0;   ///< standard deviation of the slope of a spline through the points, rad
  double bending = 0; ///< standard deviation of its curvature, 1/mm
  double pressure =
      0; ///< standard deviation of the pressure between two steel bodies pressed flat on it, MPa
  /// Shortest wavelength worth keeping, mm: a compromise between the noise left behind and the shape taken
  /// away, measured by tools/benchmarks/profile_noise. 0 where the noise is too small to matter.
  double smoothing = 0;
};

/// Measures the scatter of points in walking order: the median deviation of a point from the cubic that fits
/// it and its four neighbours on either side. Where these span more than 3 mm, they bend with the shape: if
/// two neighbours on either side tell of less than half as much scatter, on the quietest third of the points,
/// that counts. Waves of 2 to 10 mm, as an instrument leaves them that shakes, are measured alike in means
/// over a millimetre, on the quietest third of these. Rounded coordinates scatter too. Kinks and jumps of the
/// curvature are rare and do not move a median. Fewer than 9 points have no measured noise: all is 0.
///
/// White noise of deviation e at the distance h has the spectrum 2 h e^2 up to the wavelength 2 h, which a
/// spline keeps. So the slope has the deviation pi e / (sqrt(3) h), the curvature pi^2 e / (sqrt(5) h^2). A
/// wave with the slope m that is pressed flat between two half-spaces carries a pressure of E* m / 2
/// (Johnson, Contact mechanics, 1985, section 13.2).
ProfileNoise measure_noise(std::span<const Point2> points);

} // namespace bem_contact
