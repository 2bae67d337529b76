#include "bem_contact/influence/dense.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <gtest/gtest.h>

using namespace bem_contact;
using Eigen::MatrixXd;
using Eigen::MatrixXf;
using Eigen::VectorXd;
using Eigen::VectorXf;

namespace {

/// Sizes around whole blocks, and beyond what is solved without OpenBLAS.
constexpr int sizes[] = {1, 2, 7, 8, 31, 32, 33, 64, 65, 150, 512, 513};

TEST(Dense, LuFactorsSolve) {
  for (const int n : sizes) {
    MatrixXf a = MatrixXf::Random(n, n);
    a.row(0).swap(a.row(n - 1)); // pivots matter
    a.diagonal(n > 1 ? 1 : 0).array() += static_cast<float>(n);
    const LuFactors factors(a);
    ASSERT_TRUE(factors.regular()) << n;
    for (int k = 0; k < 3; ++k) { // one solution after the other
      const VectorXf right = VectorXf::Random(n);
      VectorXf x = right;
      factors.solve(x);
      const VectorXd exact = a.cast<double>().partialPivLu().solve(right.cast<double>());
      EXPECT_LT((x.cast<double>() - exact).norm(), 1e-4 * exact.norm()) << n;
    }
  }
}

TEST(Dense, ASingularMatrixHasNoSolution) {
  MatrixXf a = MatrixXf::Random(40, 40);
  a.col(7) = a.col(3);
  a.col(7).setZero();
  EXPECT_FALSE(LuFactors(a).regular());
}

TEST(Dense, WhatIsNotPositiveDefiniteHasNoFactor) {
  for (const int n : {3, 40, 600}) {
    const MatrixXd root = MatrixXd::Random(n, n);
    MatrixXd a = root * root.transpose() + MatrixXd::Identity(n, n);
    a(n - 1, n - 1) = -1;
    EXPECT_FALSE(factor_cholesky(a)) << n;
  }
}

TEST(Dense, NothingIsSolvedToo) {
  const LuFactors none{MatrixXf(0, 0)};
  EXPECT_TRUE(none.regular());
  VectorXf x(0);
  none.solve(x);
}

TEST(Dense, TrianglesOfAFactorGiveTheSolution) {
  for (const int n : sizes) {
    const MatrixXd root = MatrixXd::Random(n, n), a = root * root.transpose() + MatrixXd::Identity(n, n),
                   right = MatrixXd::Random(n, 3);
    MatrixXd factor = a;
    ASSERT_TRUE(factor_cholesky(factor));
    MatrixXd together = right;
    solve_lower(factor, together);
    solve_lower_transposed(factor, together);
    VectorXd alone = right.col(1);
    solve_lower(factor, alone);
    solve_lower_transposed(factor, alone);
    const MatrixXd exact = a.llt().solve(right);
    EXPECT_LT((together - exact).norm(), 1e-10 * exact.norm()) << n;
    EXPECT_LT((alone - exact.col(1)).norm(), 1e-10 * exact.norm()) << n;
  }
}

TEST(Dense, ProductsWithVectors) {
  const MatrixXd a = MatrixXd::Random(70, 50);
  const VectorXd x = VectorXd::Random(50);
  VectorXd in_double(70);
  dense_product(a, x, in_double);
  EXPECT_LT((in_double - a * x).norm(), 1e-13 * x.norm());
  VectorXf in_single(70);
  dense_product(a.cast<float>(), x.cast<float>(), in_single);
  EXPECT_LT((in_single.cast<double>() - a * x).norm(), 1e-5 * x.norm());
}

} // namespace
