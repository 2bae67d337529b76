#include "bem_contact/influence/column_loops.hpp"

#include "bem_contact/base/simd.hpp"

namespace bem_contact {
namespace {

constexpr int lanes = 16; ///< sums side by side, for wide registers

template <class Real>
inline __attribute__((always_inline)) void add(const Real* __restrict a, std::ptrdiff_t stride, int columns,
                                               const Real* __restrict factors, Real* __restrict to,
                                               std::ptrdiff_t rows) {
  int k = 0;
  for (; k + 8 <= columns; k += 8, a += 8 * stride) { // one pass over `to` for eight
    const Real *f = factors + k, *a1 = a + stride, *a2 = a1 + stride, *a3 = a2 + stride, *a4 = a3 + stride,
               *a5 = a4 + stride, *a6 = a5 + stride, *a7 = a6 + stride;
    const Real f0 = f[0], f1 = f[1], f2 = f[2], f3 = f[3], f4 = f[4], f5 = f[5], f6 = f[6], f7 = f[7];
    for (std::ptrdiff_t i = 0; i < rows; ++i)
      to[i] += f0 * a[i] + f1 * a1[i] + f2 * a2[i] + f3 * a3[i] + f4 * a4[i] + f5 * a5[i] + f6 * a6[i] +
               f7 * a7[i];
  }
  for (; k + 2 <= columns; k += 2, a += 2 * stride) {
    const Real f0 = factors[k], f1 = factors[k + 1], *a1 = a + stride;
    for (std::ptrdiff_t i = 0; i < rows; ++i)
      to[i] += f0 * a[i] + f1 * a1[i];
  }
  if (k < columns)
    for (std::ptrdiff_t i = 0; i < rows; ++i)
      to[i] += factors[k] * a[i];
}

template <class Real>
inline __attribute__((always_inline)) void dot(const Real* __restrict a, std::ptrdiff_t stride, int columns,
                                               const Real* __restrict of, Real* __restrict out,
                                               std::ptrdiff_t rows) {
  for (int k = 0; k < columns; ++k, a += stride) {
    Real sums[lanes] = {};
    std::ptrdiff_t i = 0;
    for (; i + lanes <= rows; i += lanes)
      for (int l = 0; l < lanes; ++l)
        sums[l] += a[i + l] * of[i + l];
    Real sum = 0;
    for (; i < rows; ++i)
      sum += a[i] * of[i];
    for (int l = 0; l < lanes; ++l)
      sum += sums[l];
    out[k] = sum;
  }
}

} // namespace

BEM_CONTACT_WIDE void add_columns(const float* a, std::ptrdiff_t stride, int columns, const float* factors,
                                  float* to, std::ptrdiff_t rows) {
  add(a, stride, columns, factors, to, rows);
}
BEM_CONTACT_WIDE void add_columns(const double* a, std::ptrdiff_t stride, int columns, const double* factors,
                                  double* to, std::ptrdiff_t rows) {
  add(a, stride, columns, factors, to, rows);
}

BEM_CONTACT_WIDE void dot_columns(const float* a, std::ptrdiff_t stride, int columns, const float* of,
                                  float* sums, std::ptrdiff_t rows) {
  dot(a, stride, columns, of, sums, rows);
}
BEM_CONTACT_WIDE void dot_columns(const double* a, std::ptrdiff_t stride, int columns, const double* of,
                                  double* sums, std::ptrdiff_t rows) {
  dot(a, stride, columns, of, sums, rows);
}

} // namespace bem_contact
