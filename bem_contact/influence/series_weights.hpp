#pragma once

#include "bem_contact/influence/series_points.hpp"

#include <span>
#include <vector>

namespace bem_contact {

/// What the stored samples of the kernel count for in the Fourier series: for each offset m and sample k,
///     A(m dx) = sum_k even[m][k] g(k)   for components even in x,
///     A(m dx) = sum_k odd[m][k] g(k)    for odd ones (series in sin kx; its sign is the caller's).
struct SeriesWeights {
  std::vector<double> even, odd; ///< offsets x wavenumbers, row-major
};

/// Load: 1 on |x| < a = dx/2, periodic with 2 L; response averaged over an element of the same length:
///     a/L g(0) + sum_{n >= 1} 2 sin^2(k_n a) / (L k_n^2 a) g(k_n) cos(k_n x),   k_n = n pi / L.
/// Up to the last sample as SeriesPoints says; beyond it k g(k) = c0 + c1/k through the last two samples. The
/// points serve angles up to offsets dx pi / L.
SeriesWeights series_weights(const SeriesPoints& points, double dx, int offsets);
/// Does the same with points of its own.
SeriesWeights series_weights(std::span<const double> wavenumber, double half_period, double dx, int offsets);

} // namespace bem_contact
