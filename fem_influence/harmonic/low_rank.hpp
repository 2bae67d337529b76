#pragma once

#include <Eigen/Core>

namespace bem_contact::fem {

/// A matrix as left right^T; the columns of `left` are orthonormal.
struct LowRank {
  Eigen::MatrixXd left, right;
};

/// Columns whose product differs from the matrix by at most `tolerance` in the Frobenius norm: at least one,
/// and hardly more than are needed. Halko, Martinsson and Tropp (2011), section 4: the range from random
/// combinations of the columns, the same ones in each run; then the smallest singular values are left out.
/// `tries`: how many combinations are tried first; if they are too few, twice as many.
LowRank low_rank(const Eigen::MatrixXd& matrix, double tolerance, Eigen::Index tries = 24);

} // namespace bem_contact::fem
