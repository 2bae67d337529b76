#pragma once

#include <vector>

namespace bem_contact {

/// Points that stand for a run of harmonics: sum over n of f(n) = sum over the points of weight f(position).
struct HarmonicPoints {
  std::vector<double>
      position; ///< in harmonics; not whole numbers where there are fewer points than harmonics
  std::vector<double> weight;
};

/// Returns points for harmonics first .. last of functions that are smooth over the run, times cos(n angle)
/// or sin(n angle) with an angle up to `largest_angle`, rad.
///
/// A run of hundreds of harmonics has few waves of such a function. A polynomial through Chebyshev's points
/// is the function, and the weights are the sums of its Lagrange polynomials over the harmonics. The error
/// falls faster than any power once there are more points than radians in half of the run: it is rounding.
/// Where that would not save points, each harmonic is a point.
HarmonicPoints harmonic_points(long first, long last, double largest_angle);

} // namespace bem_contact
