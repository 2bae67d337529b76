#pragma once

#include "bem_contact/influence/influence_numbers.hpp"

#include <Eigen/Core>

#include <vector>

namespace bem_contact::contact {

/// The numbers A_nn line by line, for a contact of so few elements that direct sums are faster than
/// transforms and their plans.
class NormalLines {
public:
  NormalLines(const InfluenceNumbers& numbers, int mx);

  /// Returns the numbers of a pair of rows; [ix - jx] from 1 - mx to mx - 1.
  const double* line(int row_i, int row_j) const {
    return &values_[static_cast<std::size_t>(pair(row_i, row_j)) * (2 * mx_ - 1) + mx_ - 1];
  }
  /// Returns the number of two elements of the grid.
  double at(int element, int loaded) const {
    return line(element / mx_, loaded / mx_)[element % mx_ - loaded % mx_];
  }
  /// The block of A_nn of these elements, lower triangle.
  Eigen::MatrixXd block(const std::vector<int>& list) const;
  /// (A p)_n on the whole grid; zeros of p cost nothing. mm
  Eigen::VectorXd apply(const Eigen::VectorXd& p) const;

private:
  int pair(int row_i, int row_j) const {
    return translational_ ? row_i - row_j + ms_ - 1 : row_i * ms_ + row_j;
  }
  int mx_, ms_;
  bool translational_;
  std::vector<double> values_;
};

} // namespace bem_contact::contact
