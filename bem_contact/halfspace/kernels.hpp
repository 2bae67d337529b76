#pragma once

#include "bem_contact/halfspace/rectangle.hpp"

#include <array>

/// Private to this room: what the closed forms of a single element and of a line of elements share.
namespace bem_contact::halfspace {

// The closed forms are differences of large numbers; extended precision keeps elements of a large aspect
// ratio exact where double would lose (r^2 / (4 a b))^2 digits.
using Real = long double;

/// The five basic kernels of Boussinesq-Cerruti, point-wise or integrated.
struct Kernels {
  double xx_r3 = 0; ///< x^2 / r^3
  double ss_r3 = 0; ///< s^2 / r^3
  double xs_r3 = 0; ///< x s / r^3
  double x_r2 = 0;  ///< x / r^2
  double s_r2 = 0;  ///< s / r^2

  Kernels& add(double weight, const Kernels& k) {
    xx_r3 += weight * k.xx_r3;
    ss_r3 += weight * k.ss_r3;
    xs_r3 += weight * k.xs_r3;
    x_r2 += weight * k.x_r2;
    s_r2 += weight * k.s_r2;
    return *this;
  }
};

/// Influence number of one body from the kernels (Boussinesq-Cerruti; Kalker 1990, appendix E).
Matrix3 assemble(const Material& material, const Kernels& k);

/// Throws InputError unless `value` is a positive length.
void require_size(double value, const char* name);

/// Gauss-Legendre points and weights on [-1, 1].
template <std::size_t N> struct Gauss { std::array<double, N> point, weight; };
template <std::size_t N> inline constexpr Gauss<N> gauss{};
template <>
inline constexpr Gauss<3> gauss<3>{{-0.7745966692414834, 0, 0.7745966692414834},
                                   {0.5555555555555556, 0.8888888888888888, 0.5555555555555556}};
template <>
inline constexpr Gauss<4> gauss<4>{
    {-0.8611363115940526, -0.3399810435848563, 0.3399810435848563, 0.8611363115940526},
    {0.3478548451374538, 0.6521451548625461, 0.6521451548625461, 0.3478548451374538}};
template <>
inline constexpr Gauss<6> gauss<6>{{-0.9324695142031521, -0.6612093864662645, -0.2386191860831969,
                                    0.2386191860831969, 0.6612093864662645, 0.9324695142031521},
                                   {0.1713244923791704, 0.3607615730481386, 0.4679139345726910,
                                    0.4679139345726910, 0.3607615730481386, 0.1713244923791704}};

} // namespace bem_contact::halfspace
