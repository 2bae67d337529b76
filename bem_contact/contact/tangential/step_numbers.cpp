#include "bem_contact/contact/tangential/step_numbers.hpp"

#include <algorithm>
#include <cstdlib>

namespace bem_contact::contact {

using Eigen::Matrix2d;
using Eigen::MatrixXd;

StepNumbers::StepNumbers(const InfluenceNumbers& numbers, int mx, const std::array<double, 3>& present)
    : mx_(mx), ms_(numbers.rows),
      values_(static_cast<std::size_t>(numbers.rows) * numbers.rows * 4 * (2 * mx - 1)) {
  std::size_t position = 0;
  for (int row_i = 0; row_i < ms_; ++row_i)
    for (int row_j = 0; row_j < ms_; ++row_j)
      for (int c = 0; c < 2; ++c)
        for (int d = 0; d < 2; ++d) {
          const auto a = [&](int m) {
            return (m < 0 ? parity(c, d) : 1) * numbers.at(std::abs(m), row_i, c, row_j, d);
          };
          for (int m = mx - 1; m > -mx; --m)
            values_[position++] = present[0] * a(m) + present[1] * a(m + 1) + present[2] * a(m + 2);
        }
}

Matrix2d step_number(const ContactProblem& problem, const std::array<double, 3>& present, int target,
                     int load) {
  const int mx = problem.grid.mx;
  Matrix2d block = Matrix2d::Zero();
  for (int k = 0; k <= rolling_columns; ++k) {
    if (present[k] == 0)
      continue;
    const int m = target % mx + k - load % mx;
    for (int c = 0; c < 2; ++c)
      for (int d = 0; d < 2; ++d)
        block(c, d) += present[k] * (m < 0 ? parity(c, d) : 1) *
                       problem.numbers.at(std::abs(m), target / mx, c, load / mx, d);
  }
  return block;
}

MatrixXd step_matrix(const ContactProblem& problem, const std::array<double, 3>& present,
                     const std::vector<int>& elements) {
  const int mx = problem.grid.mx;
  std::vector<int> rank(problem.grid.ms, -1), rows;
  int low = mx, high = 0;
  for (const int i : elements) {
    low = std::min(low, i % mx);
    high = std::max(high, i % mx);
    if (int& known = rank[i / mx]; known < 0) {
      known = static_cast<int>(rows.size());
      rows.push_back(i / mx);
    }
  }
  // The entries of two rows depend on the offset along x alone: each of them is computed once.
  const int most = high - low, each = 2 * most + 1;
  std::vector<Matrix2d> lines;
  lines.reserve(rows.size() * rows.size() * each);
  for (const int to : rows)
    for (const int from : rows)
      for (int m = -most; m <= most; ++m)
        lines.push_back(
            step_number(problem, present, to * mx + std::max(m, 0), from * mx + std::max(-m, 0)));
  const auto n = static_cast<Eigen::Index>(elements.size());
  MatrixXd matrix(2 * n, 2 * n);
  for (Eigen::Index b = 0; b < n; ++b)
    for (Eigen::Index a = 0; a < n; ++a) {
      const int target = elements[a], load = elements[b];
      const std::size_t pair = rank[target / mx] * rows.size() + rank[load / mx];
      matrix.block<2, 2>(2 * a, 2 * b) = lines[pair * each + target % mx - load % mx + most];
    }
  return matrix;
}

} // namespace bem_contact::contact
