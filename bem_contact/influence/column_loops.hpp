#pragma once

#include <cstddef>

namespace bem_contact {

// Loops over columns of a dense matrix, `stride` numbers from one column to the next, for the processor's
// wider registers where it has them (base/simd.hpp). Small products and factorizations consist of them.

/// to[i] += sum over k of factors[k] a[i + k stride], i < rows, k < columns
void add_columns(const float* a, std::ptrdiff_t stride, int columns, const float* factors, float* to,
                 std::ptrdiff_t rows);
void add_columns(const double* a, std::ptrdiff_t stride, int columns, const double* factors, double* to,
                 std::ptrdiff_t rows);

/// sums[k] = sum over i of a[i + k stride] of[i], i < rows, k < columns
void dot_columns(const float* a, std::ptrdiff_t stride, int columns, const float* of, float* sums,
                 std::ptrdiff_t rows);
void dot_columns(const double* a, std::ptrdiff_t stride, int columns, const double* of, double* sums,
                 std::ptrdiff_t rows);

} // namespace bem_contact
