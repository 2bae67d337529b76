#include "bem_contact/profile/measured/smoothing_spline.hpp"

#include "bem_contact/profile/measured/settings.hpp"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <numbers>
#include <utility>
#include <vector>

namespace bem_contact {

namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// 1. Weight of a point that is held, relative to the others: large, and far from the limits of rounding.
constexpr double kink_weight = 1e6;

/// Maps values at t to their divided differences of order 3, times 3!: the third derivative.
Sparse third_derivative(std::span<const double> t) {
  const auto n = static_cast<Eigen::Index>(t.size());
  Sparse product(n, n);
  product.setIdentity();
  for (Eigen::Index order = 1; order <= 3; ++order) {
    const Eigen::Index rows = n - order;
    Sparse next(rows, rows + 1);
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index i = 0; i < rows; ++i) {
      const double factor = static_cast<double>(order) / (t[i + order] - t[i]);
      entries.emplace_back(i, i, -factor);
      entries.emplace_back(i, i + 1, factor);
    }
    next.setFromTriplets(entries.begin(), entries.end());
    product = Sparse(next * product);
  }
  return product;
}

} // namespace

SmoothingSpline::SmoothingSpline(std::span<const double> t, Eigen::MatrixXd measured)
    : measured_(std::move(measured)), weight_(t.size()), length_(t.size() - 3), middle_(t.size() - 3),
      third_(third_derivative(t)) {
  const auto n = static_cast<Eigen::Index>(t.size());
  for (Eigen::Index i = 0; i < n; ++i)
    weight_[i] = (t[std::min(i + 1, n - 1)] - t[std::max<Eigen::Index>(i - 1, 0)]) / 2;
  for (Eigen::Index i = 0; i + 3 < n; ++i) {
    length_[i] = (t[i + 3] - t[i]) / 3;
    middle_[i] = (t[i + 3] + t[i]) / 2;
  }
}

void SmoothingSpline::hold(Eigen::Index i) {
  weight_[i] *= kink_weight;
}

/// By weighted least squares, repeated (Holland and Welsch 1977): where the third derivative is above
/// Huber's bound, the weight of its square is lowered by as much.
Eigen::MatrixXd SmoothingSpline::minimise(const Eigen::VectorXd& wavelength, double highest) const {
  const Eigen::ArrayXd number = 2 * std::numbers::pi / wavelength.array(); // wave number
  const Eigen::ArrayXd steepest = highest * number.cube();
  const Eigen::VectorXd bend = (length_.array() / number.pow(6)).matrix();
  const Sparse transposed = third_.transpose();
  const Sparse weight(weight_.asDiagonal());
  const Eigen::MatrixXd load = weight_.asDiagonal() * measured_;
  Eigen::VectorXd share = Eigen::VectorXd::Ones(bend.size());
  Eigen::SimplicialLDLT<Sparse> factors;
  factors.analyzePattern(Sparse(transposed * third_) + weight);
  for (int round = 1;; ++round) {
    factors.factorize(Sparse(transposed * bend.cwiseProduct(share).asDiagonal() * third_) + weight);
    Eigen::MatrixXd found = factors.solve(load);
    const Eigen::ArrayXd bent = (third_ * found).rowwise().norm().array();
    const Eigen::VectorXd next = (bent <= steepest).select(1.0, steepest / bent).matrix();
    const double change = (next - share).cwiseAbs().maxCoeff();
    if (change <= smoothing_precision || round == most_smoothing_rounds)
      return found;
    share = next;
  }
}

} // namespace bem_contact
