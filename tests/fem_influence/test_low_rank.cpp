#include "fem_influence/harmonic/low_rank.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace bem_contact::fem::test {
namespace {

TEST(LowRank, LeavesOutWhatIsAllowed) {
  Eigen::MatrixXd matrix(40, 30);
  for (Eigen::Index i = 0; i < 40; ++i)
    for (Eigen::Index j = 0; j < 30; ++j)
      matrix(i, j) = 1 / (1 + 0.1 * std::pow(double(i - j), 2));
  Eigen::Index before = 0;
  for (const double tolerance : {1.0, 1e-2, 1e-6}) {
    const LowRank found = low_rank(matrix, tolerance);
    EXPECT_LE((matrix - found.left * found.right.transpose()).norm(), tolerance);
    EXPECT_NEAR((found.left.transpose() * found.left).norm(), std::sqrt(double(found.left.cols())), 1e-9);
    EXPECT_GT(found.left.cols(), before);
    before = found.left.cols();
    EXPECT_NEAR(double(low_rank(matrix, tolerance, 3).left.cols()), double(before), 1); // however it begins
  }
  EXPECT_LT(low_rank(matrix, 1.0).left.cols(), 12);
  EXPECT_EQ(low_rank(Eigen::MatrixXd::Zero(5, 4), 1e-2).left.cols(), 1);
}

} // namespace
} // namespace bem_contact::fem::test
