#pragma once

#include <Eigen/Core>

namespace bem_contact::fem {

/// A matrix as left right^T; the columns of `left` are orthonormal.
struct LowRank {
  Eigen::MatrixXd left, right;
};

/// Columns whose product differs from the matrix by at most `tolerance` in the Frobenius norm; at least one,
/// and up to twice as many as are needed. Halko, Martinsson and Tropp (2011), section 4: the range from
/// random combinations of the columns, the same ones in each run.
LowRank low_rank(const Eigen::MatrixXd& matrix, double tolerance);

/// The fewest orthonormal columns that span those of the matrix within the tolerance.
Eigen::MatrixXd range_of(const Eigen::MatrixXd& matrix, double tolerance);

} // namespace bem_contact::fem
