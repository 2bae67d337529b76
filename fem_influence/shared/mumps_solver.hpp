#pragma once

#include "fem_influence/shared/elements.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace bem_contact::fem {

/// Direct solver of symmetric positive definite matrices of one pattern (MUMPS on one process; MPI must be
/// initialised). The pattern is analysed once; every factorize() replaces the factors.
class MumpsSolver {
public:
  /// The matrix is the sum of dense ones of the elements' unknowns, which are eliminated in the order of
  /// their numbers. With a `border` B (rows as in the matrix) factorize() gives schur() and keeps no factors
  /// for solve().
  MumpsSolver(int size, Elements elements, const SparseColumns& border = {});
  ~MumpsSolver();
  MumpsSolver(const MumpsSolver&) = delete;
  MumpsSolver& operator=(const MumpsSolver&) = delete;

  double estimated_memory() const; ///< of the factorization, by the analysis, GiB

  /// `value`: element after element its lower triangle, column by column; it is the same again afterwards.
  /// Throws InputError if the matrix is not positive definite, Error if memory is short.
  void factorize(std::vector<double>& value);

  /// B^T K^-1 B of the last factorize(), row-major: a Schur complement, symmetric to the last bit. It comes
  /// with the factors and costs less than a forward substitution: no solution is ever formed.
  const std::vector<double>& schur() const;

  /// Solves in blocks and hands over each column: use(column, solution).
  void solve(const SparseColumns& rhs, const std::function<void(std::size_t, std::span<const double>)>& use);

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace bem_contact::fem
