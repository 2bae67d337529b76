#pragma once

#include <boost/math/quadrature/gauss.hpp>

#include <array>
#include <cstddef>

/// Private to this room.
namespace bem_contact::halfspace {

/// Gauss-Legendre points, ascending, and weights on [-1, 1].
template <std::size_t N> struct Gauss { std::array<double, N> point{}, weight{}; };

template <std::size_t N> const Gauss<N>& gauss() {
  static const Gauss<N> rule = [] {
    using Half = boost::math::quadrature::gauss<double, N>; // the points that are not negative
    Gauss<N> whole;
    for (std::size_t g = 0; g < Half::abscissa().size(); ++g) {
      whole.point[(N - 1) / 2 - g] = -Half::abscissa()[g];
      whole.point[N / 2 + g] = Half::abscissa()[g];
      whole.weight[(N - 1) / 2 - g] = whole.weight[N / 2 + g] = Half::weights()[g];
    }
    return whole;
  }();
  return rule;
}

} // namespace bem_contact::halfspace
