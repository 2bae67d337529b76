#include "bem_contact/contact/operator/row_pairs.hpp"

#include "bem_contact/base/simd.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>

#define INLINED __attribute__((always_inline))

namespace bem_contact::contact {
namespace {

/// A register of complex numbers and what is done with it. Written out, because one of the two orders is
/// backwards, and compilers turn no order round: element by element it takes four times as many instructions.
template <class Real> struct Wide;

template <> struct Wide<double> {
  using Numbers = double __attribute__((vector_size(32)));
  static constexpr int count = 2;
  static constexpr Numbers conjugate{1, -1, 1, -1}; ///< a factor
  INLINED static void reverse(Numbers& a) { a = __builtin_shufflevector(a, a, 2, 3, 0, 1); }
  INLINED static void swap_parts(Numbers& a) { a = __builtin_shufflevector(a, a, 1, 0, 3, 2); }
  /// Each number of `a` with that of `b` behind it, `stride` reals after the one before.
  INLINED static void store(const Numbers& a, const Numbers& b, double* to, std::ptrdiff_t stride) {
    const Numbers pairs[count] = {__builtin_shufflevector(a, b, 0, 1, 4, 5),
                                  __builtin_shufflevector(a, b, 2, 3, 6, 7)};
    for (int k = 0; k < count; ++k)
      std::memcpy(to + k * stride, &pairs[k], sizeof pairs[k]);
  }
  INLINED static void load(const double* from, std::ptrdiff_t stride, Numbers& a, Numbers& b) {
    Numbers pairs[count];
    for (int k = 0; k < count; ++k)
      std::memcpy(&pairs[k], from + k * stride, sizeof pairs[k]);
    a = __builtin_shufflevector(pairs[0], pairs[1], 0, 1, 4, 5);
    b = __builtin_shufflevector(pairs[0], pairs[1], 2, 3, 6, 7);
  }
};

template <> struct Wide<float> {
  using Numbers = float __attribute__((vector_size(32)));
  using Pair = float __attribute__((vector_size(16)));
  static constexpr int count = 4;
  static constexpr Numbers conjugate{1, -1, 1, -1, 1, -1, 1, -1};
  INLINED static void reverse(Numbers& a) { a = __builtin_shufflevector(a, a, 6, 7, 4, 5, 2, 3, 0, 1); }
  INLINED static void swap_parts(Numbers& a) { a = __builtin_shufflevector(a, a, 1, 0, 3, 2, 5, 4, 7, 6); }
  INLINED static void store(const Numbers& a, const Numbers& b, float* to, std::ptrdiff_t stride) {
    const Numbers even = __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13),
                  odd = __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15);
    const Pair pairs[count] = {
        __builtin_shufflevector(even, even, 0, 1, 2, 3), __builtin_shufflevector(odd, odd, 0, 1, 2, 3),
        __builtin_shufflevector(even, even, 4, 5, 6, 7), __builtin_shufflevector(odd, odd, 4, 5, 6, 7)};
    for (int k = 0; k < count; ++k)
      std::memcpy(to + k * stride, &pairs[k], sizeof pairs[k]);
  }
  INLINED static void load(const float* from, std::ptrdiff_t stride, Numbers& a, Numbers& b) {
    Pair pairs[count];
    for (int k = 0; k < count; ++k)
      std::memcpy(&pairs[k], from + k * stride, sizeof pairs[k]);
    const Numbers even = __builtin_shufflevector(pairs[0], pairs[2], 0, 1, 2, 3, 4, 5, 6, 7),
                  odd = __builtin_shufflevector(pairs[1], pairs[3], 0, 1, 2, 3, 4, 5, 6, 7);
    a = __builtin_shufflevector(even, odd, 0, 1, 8, 9, 4, 5, 12, 13);
    b = __builtin_shufflevector(even, odd, 2, 3, 10, 11, 6, 7, 14, 15);
  }
};

/// Frequency k and its mirror image n - k of a pair face each other. several(pair, k) exchanges those of
/// k .. k + Wide::count - 1, one(pair, k) what is left.
template <class Real, class Several, class One>
INLINED inline void exchange(const RowPairs& rows, const Several& several, const One& one) {
  for (int first = rows.from; first < rows.to; first += exchanged_together)
    for (int pair = 0; pair < rows.pairs; ++pair) {
      const int last = std::min(first + exchanged_together, rows.to);
      int k = first;
      for (; k + Wide<Real>::count <= last; k += Wide<Real>::count)
        several(pair, k);
      for (; k < last; ++k)
        one(pair, k);
    }
}

/// Where a pair lies in z, and where a frequency of it lies among the rows.
struct PairPlaces {
  RowPairs rows;
  INLINED std::ptrdiff_t of_pair(int pair) const { return 2 * static_cast<std::ptrdiff_t>(pair) * rows.n; }
  INLINED std::ptrdiff_t of_rows(int pair, int k) const {
    return 2 * (static_cast<std::ptrdiff_t>(k - rows.from) * rows.stride + 2 * pair);
  }
  INLINED std::ptrdiff_t stride() const { return 2 * static_cast<std::ptrdiff_t>(rows.stride); }
};

/// The first row's spectrum at k is (z(k) + conj z(n - k)) / 2, the second row's (z(k) - conj z(n - k)) / 2i.
template <class Real>
INLINED inline void separate_rows(const RowPairs& rows, const Real* __restrict z, Real* __restrict out) {
  using W = Wide<Real>;
  const PairPlaces at{rows};
  const auto one = [&](int pair, int k) INLINED {
    const Real* row = z + at.of_pair(pair);
    const Real *a = row + 2 * k, *b = row + 2 * (k == 0 ? 0 : rows.n - k);
    Real* o = out + at.of_rows(pair, k);
    o[0] = Real(0.5) * (a[0] + b[0]);
    o[1] = Real(0.5) * (a[1] - b[1]);
    o[2] = Real(0.5) * (a[1] + b[1]);
    o[3] = Real(0.5) * (b[0] - a[0]);
  };
  const auto several = [&](int pair, int k) INLINED {
    const Real* row = z + at.of_pair(pair);
    typename W::Numbers a, b;
    std::memcpy(&a, row + 2 * k, sizeof a);
    std::memcpy(&b, row + 2 * (rows.n - k - W::count + 1), sizeof b);
    W::reverse(b);
    a *= Real(0.5);
    b *= Real(0.5) * W::conjugate;
    typename W::Numbers second = a - b;
    W::swap_parts(second);
    second *= W::conjugate; // over i
    W::store(a + b, second, out + at.of_rows(pair, k), at.stride());
  };
  for (int pair = 0; rows.from == 0 && pair < rows.pairs; ++pair)
    one(pair, 0); // faces itself
  RowPairs others = rows;
  others.from = std::max(rows.from, 1);
  exchange<Real>(others, several, one);
}

template <class Real>
INLINED inline void join_rows(const RowPairs& rows, const Real* __restrict in, Real* __restrict z) {
  using W = Wide<Real>;
  const PairPlaces at{rows};
  const auto one = [&](int pair, int k) INLINED {
    const Real* i = in + at.of_rows(pair, k);
    Real *a = z + at.of_pair(pair) + 2 * k, *b = z + at.of_pair(pair) + 2 * (rows.n - k);
    a[0] = i[0] - i[3];
    a[1] = i[1] + i[2];
    b[0] = i[0] + i[3];
    b[1] = i[2] - i[1];
  };
  const auto several = [&](int pair, int k) INLINED {
    Real* row = z + at.of_pair(pair);
    typename W::Numbers first, second;
    W::load(in + at.of_rows(pair, k), at.stride(), first, second);
    W::swap_parts(second);
    second *= -W::conjugate; // times i
    const typename W::Numbers a = first + second;
    typename W::Numbers b = (first - second) * W::conjugate;
    W::reverse(b);
    std::memcpy(row + 2 * k, &a, sizeof a);
    std::memcpy(row + 2 * (rows.n - k - W::count + 1), &b, sizeof b);
  };
  for (const int k : {0, rows.n / 2}) // these face themselves, and are real
    for (int pair = 0; rows.from <= k && k < rows.to && pair < rows.pairs; ++pair) {
      Real* a = z + at.of_pair(pair) + 2 * k;
      a[0] = in[at.of_rows(pair, k)];
      a[1] = in[at.of_rows(pair, k) + 2];
    }
  RowPairs others = rows;
  others.from = std::max(rows.from, 1);
  others.to = std::min(rows.to, rows.n / 2);
  exchange<Real>(others, several, one);
}

} // namespace

BEM_CONTACT_WIDE void separate(const RowPairs& rows, const double* z, double* out) {
  separate_rows(rows, z, out);
}
BEM_CONTACT_WIDE void separate(const RowPairs& rows, const float* z, float* out) {
  separate_rows(rows, z, out);
}
BEM_CONTACT_WIDE void join(const RowPairs& rows, const double* in, double* z) {
  join_rows(rows, in, z);
}
BEM_CONTACT_WIDE void join(const RowPairs& rows, const float* in, float* z) {
  join_rows(rows, in, z);
}

} // namespace bem_contact::contact

#undef INLINED
