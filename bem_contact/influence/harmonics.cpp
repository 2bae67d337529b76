#include "bem_contact/influence/harmonics.hpp"

#include "bem_contact/base/simd.hpp"

#include <algorithm>

namespace bem_contact {

BEM_CONTACT_WIDE void add_harmonics(const HarmonicWeights& weights, const Harmonics& harmonics,
                                    double* cosine, double* sine) {
  const auto [weight, counts, width] = weights;
  const auto [first_cos, first_sin, turn_cos, turn_sin, angles, count] = harmonics;
  constexpr std::size_t block = 4, most = 6;
  for (std::size_t m = 0; m < angles; m += block) {
    const std::size_t some = std::min(block, angles - m);
    double c[block] = {}, s[block] = {}, tc[block] = {}, ts[block] = {};
    for (std::size_t l = 0; l < some; ++l) {
      c[l] = first_cos[m + l];
      s[l] = first_sin[m + l];
      tc[l] = turn_cos[m + l];
      ts[l] = turn_sin[m + l];
    }
    double even[most][block] = {}, odd[most][block] = {};
    for (std::size_t h = 0; h < count; ++h) {
      for (std::size_t b = 0; b < most; ++b) {
        const double factor = b < counts ? weight[b * width + h] : 0.0;
        for (std::size_t l = 0; l < block; ++l) {
          even[b][l] += factor * c[l];
          odd[b][l] += factor * s[l];
        }
      }
      for (std::size_t l = 0; l < block; ++l) {
        const double turned = c[l] * tc[l] - s[l] * ts[l];
        s[l] = s[l] * tc[l] + c[l] * ts[l];
        c[l] = turned;
      }
    }
    for (std::size_t b = 0; b < counts; ++b)
      for (std::size_t l = 0; l < some; ++l) {
        cosine[b * angles + m + l] += even[b][l];
        sine[b * angles + m + l] += odd[b][l];
      }
  }
}

} // namespace bem_contact
