#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace bem_contact {

/// Normal numbers of mean 0 and deviation 1 (Box and Muller 1958). The same seed gives the same numbers on
/// every machine; the standard library's own normal numbers differ from one library to another.
class NormalDraws {
public:
  explicit NormalDraws(std::uint64_t seed) : bits_(seed) {}
  double next() {
    const double radius = std::sqrt(-2 * std::log(1 - uniform()));
    return radius * std::cos(2 * std::numbers::pi * uniform());
  }

private:
  double uniform() { return static_cast<double>(bits_() >> 11) * 0x1p-53; } // [0, 1)
  std::mt19937_64 bits_;
};

} // namespace bem_contact
