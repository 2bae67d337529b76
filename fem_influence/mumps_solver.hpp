#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace bem_contact::fem {

/// Columns of a sparse matrix: entries column_begin[c] .. column_begin[c+1]-1, rows from 0.
struct SparseColumns {
  std::vector<std::size_t> column_begin{0};
  std::vector<int> row;
  std::vector<double> value;

  std::size_t columns() const { return column_begin.size() - 1; }
};

/// Appends the columns of `from`, rows renumbered by `unknown`; rows that are none (-1) have a displacement
/// of zero and are left out.
void append_unknowns(SparseColumns& to, const SparseColumns& from, std::span<const int> unknown);

/// Place of each node in the elimination, from 0, by METIS's nested dissection of the graph with the edges
/// column[begin[a]] .. column[begin[a + 1] - 1] of node a; each edge stands once, (a, a) counts for nothing,
/// nor does an edge with a node that is not `used`; those come last.
std::vector<int> nested_dissection(std::span<const std::size_t> begin, std::span<const int> column,
                                   std::span<const char> used);

/// Direct solver of symmetric positive definite matrices of one pattern (MUMPS on one process; MPI must be
/// initialised). The pattern is analysed once; every factorize() replaces the factors.
class MumpsSolver {
public:
  /// One triangle: row[e], column[e] from 0; repeated entries are added. With a `border` B (rows as in the
  /// matrix) factorize() also gives schur(). `place` of each row in the elimination, from 0; empty: METIS
  /// finds it.
  MumpsSolver(int size, std::vector<int> row, std::vector<int> column, const SparseColumns& border = {},
              std::span<const int> place = {});
  ~MumpsSolver();
  MumpsSolver(const MumpsSolver&) = delete;
  MumpsSolver& operator=(const MumpsSolver&) = delete;

  double estimated_memory() const; ///< of the factorization, by the analysis, GiB

  /// Throws InputError where the matrix is not positive definite, Error where memory is short.
  void factorize(std::vector<double> value);

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
