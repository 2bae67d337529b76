#pragma once

#include "bem_contact/base/body_file.hpp"

#include <span>
#include <vector>

namespace bem_contact::fem {

inline constexpr int exact_harmonics = 8;

/// Where the kernel is sampled: k = n pi / L for n = 0 .. 8, then equal steps in log k, at least
/// `samples_per_decade` a decade, up to and with k_max = 10 / shortest_dx (FEM_NOTES: k_max a >= 5 with
/// a = dx/2). 1/mm, ascending, the first is 0.
std::vector<double> wavenumber_samples(double half_period, double shortest_dx, int samples_per_decade);

/// Error of 6-point Lagrange interpolation of k g(k) in log k between the logarithmic samples, largest over
/// `probes` of them and all pairs, relative to sqrt(g_aa g_bb) (the self numbers): each probe is left out and
/// interpolated from its six neighbours; the error in the middle of an interval of the full set is 0.0977 of
/// that ((.5 1.5 2.5)^2 over (1 2 3)^2, the ratio of the node polynomials).
/// kernel[k] is size x size. Returns -1 where there are fewer than 7 logarithmic samples.
double interpolation_error(std::span<const double> wavenumber, std::span<const double> kernel,
                           std::size_t size, int probes = 4);

} // namespace bem_contact::fem
