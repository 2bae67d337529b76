#pragma once

#include <Eigen/Core>

#include <vector>

namespace bem_contact {

// Dense products and factorizations: large ones by BLAS and LAPACK on one thread, others by few_unknowns.hpp.

/// Cholesky's factor in place of A, which is symmetric positive definite (the lower triangle is read). False
/// if it is not.
bool factor_cholesky(Eigen::MatrixXd& a);

/// x := L^-1 x with the lower triangle L of `factor`, and x := L^-T x.
void solve_lower(const Eigen::MatrixXd& factor, Eigen::Ref<Eigen::MatrixXd> x);
void solve_lower_transposed(const Eigen::MatrixXd& factor, Eigen::Ref<Eigen::MatrixXd> x);

/// LU factors with partial pivoting, in single precision, for many solutions one after the other. The blocks
/// on the diagonal are inverted, so that a solution consists of products with blocks: for 290 unknowns a
/// third of the instructions of BLAS's strsv, which goes column by column.
class LuFactors {
public:
  explicit LuFactors(Eigen::MatrixXf a);

  bool regular() const { return regular_; } ///< else there is no solution
  /// x := A^-1 x
  void solve(Eigen::Ref<Eigen::VectorXf> x) const;

private:
  Eigen::MatrixXf factors_;
  std::vector<int> pivots_;
  bool regular_ = true;
  Eigen::MatrixXf lower_, upper_; ///< inverses of the blocks on the diagonal, side by side
};

/// out = A x
void dense_product(const Eigen::MatrixXf& a, Eigen::Ref<const Eigen::VectorXf> x,
                   Eigen::Ref<Eigen::VectorXf> out);
void dense_product(const Eigen::MatrixXd& a, Eigen::Ref<const Eigen::VectorXd> x,
                   Eigen::Ref<Eigen::VectorXd> out);

/// A B into `out`, column-major.
void dense_product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, double* out);
/// A^T B likewise.
void dense_product_of_columns(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, double* out);

} // namespace bem_contact
