#include "bem_contact/influence/few_unknowns.hpp"

#include "bem_contact/influence/column_loops.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace bem_contact::few {
namespace {

constexpr int together = 8; ///< columns that are taken off at once: as add_columns() does it fastest
constexpr int panel = 32;   ///< columns from which they are taken off while they are in the cache. Chosen

std::ptrdiff_t at(int row, int column, int n) {
  return row + static_cast<std::ptrdiff_t>(column) * n;
}

/// Takes columns from .. to - 1 of L off column j, from its diagonal on.
void take_off(double* a, int n, int from, int to, int j) {
  std::array<double, together> factors{};
  for (int k = from; k < to; k += together) {
    const int count = std::min(together, to - k);
    for (int q = 0; q < count; ++q)
      factors[q] = -a[at(j, k + q, n)];
    add_columns(a + at(j, k, n), n, count, factors.data(), a + at(j, j, n), n - j);
  }
}

/// x := L^-1 x for a block of L on the diagonal, which has ones there. `Count`, or 0 for `count`.
template <int Count> void solve_block(const float* __restrict l, int n, int count, float* __restrict x) {
  if constexpr (Count > 0)
    count = Count;
#pragma GCC unroll 8
  for (int r = 0; r < count; ++r, l += n)
#pragma GCC unroll 8
    for (int q = r + 1; q < count; ++q)
      x[q] -= l[q] * x[r];
}

/// Eliminates rows from .. to - 1 of column j.
void eliminate(float* a, int n, int from, int to, int j) {
  std::array<float, together> factors{};
  float* column = a + at(0, j, n);
  for (int k = from; k < to; k += together) {
    const int count = std::min(together, to - k);
    if (count == together)
      solve_block<together>(a + at(k, k, n), n, count, column + k);
    else
      solve_block<0>(a + at(k, k, n), n, count, column + k);
    std::transform(column + k, column + k + count, factors.begin(), [](float x) { return -x; });
    add_columns(a + at(k + count, k, n), n, count, factors.data(), column + k + count, n - k - count);
  }
}

} // namespace

bool factor_cholesky(double* a, int n) {
  for (int first = 0; first < n; first += panel) {
    const int end = std::min(first + panel, n);
    for (int k = 0; k < first; k += together)
      for (int j = first; j < end; ++j)
        take_off(a, n, k, k + together, j);
    for (int j = first; j < end; ++j) {
      take_off(a, n, first, j, j);
      double* diagonal = a + at(j, j, n);
      if (!(*diagonal > 0) || !std::isfinite(*diagonal))
        return false;
      const double scale = 1 / std::sqrt(*diagonal);
      std::for_each(diagonal, diagonal + (n - j), [scale](double& v) { v *= scale; });
    }
  }
  return true;
}

void solve_lower(const double* factor, int n, double* x) {
  std::array<double, together> factors{};
  for (int k = 0; k < n; k += together) {
    const int count = std::min(together, n - k), below = k + count;
    for (int q = k; q < below; ++q) {
      for (int r = k; r < q; ++r)
        x[q] -= factor[at(q, r, n)] * x[r];
      x[q] /= factor[at(q, q, n)];
      factors[q - k] = -x[q];
    }
    add_columns(factor + at(below, k, n), n, count, factors.data(), x + below, n - below);
  }
}

void solve_lower_transposed(const double* factor, int n, double* x) {
  std::array<double, together> sums{};
  for (int k = (n - 1) / together * together; k >= 0 && n > 0; k -= together) {
    const int count = std::min(together, n - k), below = k + count;
    dot_columns(factor + at(below, k, n), n, count, x + below, sums.data(), n - below);
    for (int q = below - 1; q >= k; --q) {
      x[q] -= sums[q - k];
      for (int r = q + 1; r < below; ++r)
        x[q] -= factor[at(r, q, n)] * x[r];
      x[q] /= factor[at(q, q, n)];
    }
  }
}

bool factor_lu(float* a, int n, int* pivots) {
  const auto exchange_rows = [&](int row, int other, int first, int end) {
    for (int j = first; j < end && row != other; ++j)
      std::swap(a[at(row, j, n)], a[at(other, j, n)]);
  };
  for (int first = 0; first < n; first += panel) {
    const int end = std::min(first + panel, n);
    for (int k = 0; k < first; ++k)
      exchange_rows(k, pivots[k], first, end);
    for (int k = 0; k < first; k += together)
      for (int j = first; j < end; ++j)
        eliminate(a, n, k, k + together, j);
    for (int j = first; j < end; ++j) {
      eliminate(a, n, first, j, j);
      float* column = a + at(0, j, n);
      const auto larger = [](float one, float other) { return std::abs(one) < std::abs(other); };
      pivots[j] = static_cast<int>(std::max_element(column + j, column + n, larger) - column);
      exchange_rows(j, pivots[j], 0, end);
      if (!(std::abs(column[j]) > 0) || !std::isfinite(column[j]))
        return false;
      const float scale = 1 / column[j];
      std::for_each(column + j + 1, column + n, [scale](float& v) { v *= scale; });
    }
  }
  return true;
}

} // namespace bem_contact::few
