#include "bem_contact/contact/normal/normal_lines.hpp"

#include "bem_contact/base/simd.hpp"

namespace bem_contact::contact {
namespace {

/// u[c] += sum_k load[k] line[c - k]
BEM_CONTACT_WIDE void add_loads(const double* load, int count, const double* line, int columns, double* u) {
  int k = 0;
  for (; k + 4 <= count; k += 4) {
    const double *l0 = line - k, *l1 = l0 - 1, *l2 = l0 - 2, *l3 = l0 - 3;
    for (int c = 0; c < columns; ++c)
      u[c] += load[k] * l0[c] + load[k + 1] * l1[c] + load[k + 2] * l2[c] + load[k + 3] * l3[c];
  }
  for (; k < count; ++k)
    for (int c = 0; c < columns; ++c)
      u[c] += load[k] * line[c - k];
}

} // namespace

NormalLines::NormalLines(const InfluenceNumbers& numbers, int mx)
    : mx_(mx), ms_(numbers.rows), translational_(numbers.translational) {
  const auto pairs = numbers.stored_rows();
  values_.resize(pairs.size() * (2 * mx - 1));
  for (int m = 0; m < mx; ++m) // as they lie
    for (const auto& [row_i, row_j] : pairs) {
      double* middle = &values_[static_cast<std::size_t>(pair(row_i, row_j)) * (2 * mx - 1) + mx - 1];
      middle[m] = middle[-m] = numbers.at(m, row_i, component_n, row_j, component_n);
    }
}

Eigen::MatrixXd NormalLines::block(const std::vector<int>& list) const {
  const int n = static_cast<int>(list.size());
  Eigen::MatrixXd matrix(n, n);
  for (int b = 0; b < n; ++b)
    for (int a = b; a < n; ++a)
      matrix(a, b) = at(list[a], list[b]);
  return matrix;
}

Eigen::VectorXd NormalLines::apply(const Eigen::VectorXd& p) const {
  Eigen::VectorXd u = Eigen::VectorXd::Zero(p.size());
  for (int row_j = 0; row_j < ms_; ++row_j) {
    const double* loads = &p[static_cast<Eigen::Index>(row_j) * mx_];
    int from = 0, to = mx_;
    while (from < to && loads[from] == 0)
      ++from;
    while (to > from && loads[to - 1] == 0)
      --to;
    if (from == to)
      continue;
    for (int row_i = 0; row_i < ms_; ++row_i)
      add_loads(loads + from, to - from, line(row_i, row_j) - from, mx_,
                &u[static_cast<Eigen::Index>(row_i) * mx_]);
  }
  return u;
}

} // namespace bem_contact::contact
