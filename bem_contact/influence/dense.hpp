#pragma once

#include <Eigen/Core>

namespace bem_contact {

// The large dense products and factorizations, by BLAS and LAPACK on one thread. The small products stay with
// Eigen.

/// Cholesky's factor in place of A, which is symmetric positive definite (the lower triangle is read). False
/// if it is not.
bool factor_cholesky(Eigen::MatrixXd& a);

/// x := A^-1 x with the factor that factor_cholesky() left in A's place.
void solve_factored(const Eigen::MatrixXd& factor, Eigen::Ref<Eigen::VectorXd> x);

/// x := A^-1 x by LU with partial pivoting (A is overwritten), in single precision. False if A is singular.
bool solve_lu(Eigen::MatrixXf& a, Eigen::VectorXf& x);

/// A B into `out`, column-major.
void dense_product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, double* out);
/// A^T B likewise.
void dense_product_of_columns(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, double* out);

} // namespace bem_contact
