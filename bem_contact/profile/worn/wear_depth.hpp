#pragma once

#include <span>
#include <vector>

namespace bem_contact {

/// A depth over an arc length, smoothed.
struct SmoothDepth {
  std::vector<double> depth;      ///< mm, at each s
  std::vector<double> wavelength; ///< shortest kept there, mm
};

/// Smooths depths, measured at rising s (mm, at least 5), by squares alone (smoothing_spline.hpp): a wave of
/// length L keeps the share 1 / (1 + (wavelength / L)^6). The wavelength is `given` (mm) everywhere.
SmoothDepth smoothed_depth(std::span<const double> s, std::span<const double> depth, double given);

/// Does the same with the wavelength found from the data, stretch by stretch (Davies and Meise 2008): from
/// longest_depth_wave it is shortened, only where it must be, until what is removed looks like noise of the
/// standard deviation `scatter` (mm): on no stretch of n points, at least a quarter of the wavelength long,
/// may the sum of it exceed scatter sqrt(2 n ln N), N the number of all points (Davies and Kovac 2001). Where
/// it was shortened it is shortened once more. `spacing` (mm) is the usual distance of the points: waves
/// shorter than shortest_depth_wave times that are not looked for.
SmoothDepth smoothed_depth_by_noise(std::span<const double> s, std::span<const double> depth, double scatter,
                                    double spacing);

} // namespace bem_contact
