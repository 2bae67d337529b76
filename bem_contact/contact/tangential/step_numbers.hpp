#pragma once

#include "bem_contact/contact/slip_step.hpp"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace bem_contact::contact {

/// The matrix of one rolling step or load step, tangential components:
/// B = sum_k present[k] A(x_I + k dx - x_J) (SlipStep::present). Its entries, unrolled for dot products along
/// x: for rows I, J and components c, d the 2 mx - 1 values of offset mx - 1 .. -(mx - 1).
class StepNumbers {
public:
  StepNumbers(const InfluenceNumbers& numbers, int mx, const std::array<double, 3>& present);

  /// Value at [ix'] is B_cd of the element (ix, row_i) under a load at (ix', row_j), mm/MPa.
  const double* line(int ix, int row_i, int c, int row_j, int d) const {
    return &values_[(((static_cast<std::size_t>(row_i) * ms_ + row_j) * 2 + c) * 2 + d) * (2 * mx_ - 1) +
                    mx_ - 1 - ix];
  }

private:
  int mx_, ms_;
  std::vector<double> values_;
};

/// B of the element `target` under a load on the element `load`, mm/MPa.
Eigen::Matrix2d step_number(const ContactProblem& problem, const std::array<double, 3>& present, int target,
                            int load);
/// B of all pairs of these elements: [x, s] of the first element, of the second, ...
Eigen::MatrixXd step_matrix(const ContactProblem& problem, const std::array<double, 3>& present,
                            const std::vector<int>& elements);

} // namespace bem_contact::contact
