#pragma once

#include <vector>

namespace bem_contact::fem {

/// Where the kernel is sampled (THEORY.md, 7): k = n pi / L for n = 0 .. 8 with L = half_period, then equal
/// steps in log k, at least `samples_per_decade` a decade and an even number of them, up to and with k_max =
/// 10 / shortest_dx. 1/mm, ascending, the first is 0; lengths in mm. Throws InputError where the harmonics
/// reach beyond k_max.
std::vector<double> wavenumber_samples(double half_period, double shortest_dx, int samples_per_decade);

} // namespace bem_contact::fem
