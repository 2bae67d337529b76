#include "fem_influence/harmonic/low_rank.hpp"

#include "bem_contact/influence/dense.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <random>

namespace bem_contact::fem {

namespace {

/// 1 (of the tolerance). What the random combinations may miss; the rest is for what is left out after them.
constexpr double missed_by_combinations = 0.7;

/// Between -1 and 1, the same on each machine.
Eigen::MatrixXd random_matrix(Eigen::Index rows, Eigen::Index columns) {
  std::mt19937_64 generator(1);
  Eigen::MatrixXd out(rows, columns);
  for (double& value : out.reshaped())
    value = std::ldexp(static_cast<double>(generator() >> 11), -52) - 1;
  return out;
}

Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& matrix) {
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(matrix);
  return qr.householderQ() * Eigen::MatrixXd::Identity(matrix.rows(), matrix.cols());
}

/// Left orthonormal, right whatever it is.
LowRank by_combinations(const Eigen::MatrixXd& matrix, double tolerance, Eigen::Index tries) {
  const double all = matrix.squaredNorm();
  const Eigen::Index most = std::min(matrix.rows(), matrix.cols());
  LowRank out;
  for (tries = std::min(tries, most);; tries = std::min(2 * tries, most)) {
    if (tries == matrix.cols()) {
      out.left = orthonormal(matrix);
    } else {
      Eigen::MatrixXd sample(matrix.rows(), tries);
      dense_product(matrix, random_matrix(matrix.cols(), tries), sample.data());
      out.left = orthonormal(sample);
    }
    out.right.resize(matrix.cols(), tries);
    dense_product_of_columns(matrix, out.left, out.right.data());
    if (all - out.right.squaredNorm() <= tolerance * tolerance || tries == most)
      return out;
  }
}

} // namespace

LowRank low_rank(const Eigen::MatrixXd& matrix, double tolerance, Eigen::Index tries) {
  const LowRank form = by_combinations(matrix, missed_by_combinations * tolerance, tries);
  Eigen::MatrixXd gram(form.right.cols(), form.right.cols());
  dense_product_of_columns(form.right, form.right, gram.data());
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> singular(gram); // squares, ascending
  const double allowed = tolerance * tolerance;
  double left_out = std::max(0.0, matrix.squaredNorm() - form.right.squaredNorm());
  Eigen::Index dropped = 0;
  for (; dropped + 1 < gram.rows(); ++dropped) {
    left_out += std::max(0.0, singular.eigenvalues()[dropped]);
    if (left_out > allowed)
      break;
  }
  const Eigen::MatrixXd vectors =
      singular.eigenvectors().rightCols(gram.rows() - dropped).rowwise().reverse();
  LowRank out{Eigen::MatrixXd(matrix.rows(), vectors.cols()), Eigen::MatrixXd(matrix.cols(), vectors.cols())};
  dense_product(form.left, vectors, out.left.data());
  dense_product(form.right, vectors, out.right.data());
  return out;
}

} // namespace bem_contact::fem
