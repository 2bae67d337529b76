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
    const Eigen::MatrixXd range = range_of(matrix, tolerance);
    EXPECT_LE((matrix - range * (range.transpose() * matrix)).norm(), tolerance);
    EXPECT_NEAR((range.transpose() * range).norm(), std::sqrt(double(range.cols())), 1e-9);
    EXPECT_GT(range.cols(), before);
    EXPECT_LE(range.cols(), found.left.cols());
    before = range.cols();
  }
  EXPECT_LT(range_of(matrix, 1.0).cols(), 12);
  EXPECT_EQ(range_of(Eigen::MatrixXd::Zero(5, 4), 1e-2).cols(), 1);
}

} // namespace
} // namespace bem_contact::fem::test
