#pragma once

#include <cstddef>

namespace bem_contact::few {

// Factorizations of few unknowns, without BLAS: to open it takes as long as a hundred of them, and most cases
// have no others. Matrices are column-major, n x n. Blocks of columns are taken off at once (left-looking;
// Golub, Van Loan 2013, sections 3.2.9 and 4.2.6), so that they stay in the cache.

/// Unknowns. Up to here these take no more instructions than OpenBLAS's (measured).
constexpr int most = 512;

/// A = L L^T, L in place of the lower triangle. False if A is not positive definite.
bool factor_cholesky(double* a, int n);
/// x := L^-1 x and x := L^-T x, of any size.
void solve_lower(const double* factor, int n, double* x);
void solve_lower_transposed(const double* factor, int n, double* x);

/// P A = L U, both in place of A; row k was exchanged with row pivots[k] (from 0 on). False if A is singular.
bool factor_lu(float* a, int n, int* pivots);

} // namespace bem_contact::few
