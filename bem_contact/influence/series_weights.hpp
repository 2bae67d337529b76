#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace bem_contact {

/// Points that stand for a run of harmonics: sum over n of f(n) = sum over the points of weight f(position).
struct HarmonicPoints {
  Eigen::ArrayXd position; ///< in harmonics; not whole numbers where there are fewer points than harmonics
  Eigen::ArrayXd weight;
};

/// For harmonics first .. last of functions that are smooth over the run, times cos(n angle) or sin(n angle)
/// with an angle up to `largest_angle`, rad.
///
/// A run of hundreds of harmonics has few waves of such a function. A polynomial through Chebyshev's points
/// is the function, and the weights are the sums of its Lagrange polynomials over the harmonics. The error
/// falls faster than any power once there are more points than radians in half of the run: it is rounding.
/// Where that would not save points, each harmonic is a point.
HarmonicPoints harmonic_points(long first, long last, double largest_angle);

/// What the stored samples of the kernel count for in the Fourier series: for each offset m and sample k,
///     A(m dx) = sum_k even[m][k] g(k)   for components even in x,
///     A(m dx) = sum_k odd[m][k] g(k)    for odd ones (series in sin kx; its sign is the caller's).
struct SeriesWeights {
  std::vector<double> even, odd; ///< offsets x wavenumbers, row-major
};

/// Load: 1 on |x| < a = dx/2, periodic with 2 L; response averaged over an element of the same length:
///     a/L g(0) + sum_{n >= 1} 2 sin^2(k_n a) / (L k_n^2 a) g(k_n) cos(k_n x),   k_n = n pi / L.
/// Harmonics that are samples count for themselves; between samples k g(k) is 6-point Lagrange in log k;
/// beyond the last sample k g(k) = c0 + c1/k through the last two.
/// `wavenumber`: ascending, the first is 0, at least 3.
SeriesWeights series_weights(std::span<const double> wavenumber, double half_period, double dx, int offsets);

} // namespace bem_contact
