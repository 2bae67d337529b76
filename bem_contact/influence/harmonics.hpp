#pragma once

#include <cstddef>

namespace bem_contact {

/// Consecutive harmonics first, first + 1, ... of a Fourier series at several angles. Each array has `angles`
/// entries: cosine and sine of first times the angle, and of the angle itself, by which they are turned.
struct Harmonics {
  const double *first_cos, *first_sin, *turn_cos, *turn_sin;
  std::size_t angles, count;
};

/// What each harmonic counts for in each of at most 6 sums: value[b * width + h], b the sum, h the harmonic.
struct HarmonicWeights {
  const double* value;
  std::size_t sums, width;
};

/// cosine[b][m] += sum over h of weight[b][h] cos((first + h) angle_m), and sine likewise; row-major, one row
/// a sum.
void add_harmonics(const HarmonicWeights& weights, const Harmonics& harmonics, double* cosine, double* sine);

} // namespace bem_contact
