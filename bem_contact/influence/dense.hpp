#pragma once

#include <Eigen/Core>

namespace bem_contact {

// The large dense products and factorizations, by BLAS and LAPACK on one thread. The small products stay with
// Eigen.

/// x := A^-1 x, A symmetric positive definite (lower triangle read, overwritten by its factor). False if it
/// is not.
bool solve_cholesky(Eigen::MatrixXd& a, Eigen::MatrixXd& x);

/// The same with the factor that solve_cholesky() left in A's place.
void solve_factored(const Eigen::MatrixXd& factor, Eigen::MatrixXd& x);

/// x := A^-1 x by LU with partial pivoting (A is overwritten). False if A is singular.
bool solve_lu(Eigen::MatrixXd& a, Eigen::MatrixXd& x);

/// A B into `out`, column-major.
void dense_product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, double* out);
/// A^T B likewise.
void dense_product_of_columns(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, double* out);

} // namespace bem_contact
