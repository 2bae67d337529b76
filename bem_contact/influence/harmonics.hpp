#pragma once

#include <cstddef>

namespace bem_contact {

/// cosine(b, m) += sum over h of weight(b, h) cos((first + h) angle_m), sine likewise; weight: counts x
/// `width`, `harmonics` of each row count. Cosines and sines of first angle_m are given, and those of
/// angle_m, by which they are turned.
void add_harmonics(const double* weight, std::size_t counts, std::size_t width, std::size_t harmonics,
                   const double* first_cos, const double* first_sin, const double* turn_cos,
                   const double* turn_sin, std::size_t angles, double* cosine, double* sine);

} // namespace bem_contact
