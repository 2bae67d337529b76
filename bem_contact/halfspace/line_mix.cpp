#include "bem_contact/halfspace/line_mix.hpp"

#include "bem_contact/base/simd.hpp"

namespace bem_contact::halfspace {

BEM_CONTACT_WIDE void add_mix(const LineMix& mix, std::size_t shift, double factor, double* line,
                              std::size_t offsets) {
  for (std::size_t m = 0; m < offsets; ++m)
    line[m] *= factor;
  for (std::size_t b = 0; b < mix.count; ++b) {
    const double weight = mix.weight[b];
    const double* __restrict from = mix.block[b] + shift;
    for (std::size_t m = 0; m < offsets; ++m)
      line[m] += weight * from[m];
  }
}

} // namespace bem_contact::halfspace
