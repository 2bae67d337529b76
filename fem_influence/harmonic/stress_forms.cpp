#include "fem_influence/harmonic/stress_forms.hpp"

#include "bem_contact/influence/dense.hpp"
#include "fem_influence/harmonic/low_rank.hpp"

#include <cmath>
#include <utility>

namespace bem_contact::fem {

namespace {

/// 1. Columns with which the search for a range begins at the deepest points; at the others with a quarter
/// more than were needed below them, and these. Chosen.
constexpr Eigen::Index fewest_tries = 12;

} // namespace

std::vector<double> few_columns(const DepthMatrices& matrices, double tolerance) {
  std::vector<LowRank> forms(matrices.size());
  Eigen::Index tries = fewest_tries;
  for (std::size_t d = matrices.size(); d-- > 0;) { // the nearer to the surface the more columns
    forms[d] = low_rank(matrices[d], tolerance, tries);
    tries = fewest_tries + 5 * forms[d].left.cols() / 4;
  }
  std::vector<double> out{static_cast<double>(matrices.size())};
  for (const LowRank& form : forms) {
    out.push_back(static_cast<double>(form.left.cols()));
    out.insert(out.end(), form.left.data(), form.left.data() + form.left.size());
    out.insert(out.end(), form.right.data(), form.right.data() + form.right.size());
  }
  return out;
}

FewColumns take_few_columns(std::span<const double>& numbers, std::size_t left_rows, std::size_t right_rows) {
  const auto next = [&] {
    const double value = numbers.empty() ? -1 : numbers.front();
    numbers = numbers.subspan(numbers.empty() ? 0 : 1);
    return value;
  };
  const auto matrix = [&](std::size_t rows, std::size_t columns) {
    Eigen::MatrixXd out = Eigen::Map<const Eigen::MatrixXd>(numbers.data(), static_cast<Eigen::Index>(rows),
                                                            static_cast<Eigen::Index>(columns));
    numbers = numbers.subspan(rows * columns);
    return out;
  };
  FewColumns out;
  for (double left = next(); left >= 1; --left) {
    const double columns = next();
    if (!(columns >= 1 && columns <= static_cast<double>(right_rows)) ||
        numbers.size() < static_cast<std::size_t>(columns) * (left_rows + right_rows))
      return {};
    out.left.push_back(matrix(left_rows, static_cast<std::size_t>(columns)));
    out.right.push_back(matrix(right_rows, static_cast<std::size_t>(columns)));
  }
  return out;
}

namespace {

/// Side by side.
Eigen::MatrixXd joined(const std::vector<Eigen::MatrixXd>& parts) {
  Eigen::Index columns = 0;
  for (const Eigen::MatrixXd& part : parts)
    columns += part.cols();
  Eigen::MatrixXd out(parts.front().rows(), columns);
  columns = 0;
  for (const Eigen::MatrixXd& part : parts) {
    out.middleCols(columns, part.cols()) = part;
    columns += part.cols();
  }
  return out;
}

Eigen::MatrixXd product(const Eigen::MatrixXd& a_transposed, const Eigen::MatrixXd& b) {
  Eigen::MatrixXd out(a_transposed.cols(), b.cols());
  dense_product_of_columns(a_transposed, b, out.data());
  return out;
}

} // namespace

StressForm common_columns(std::vector<double> wavenumbers, const std::vector<FewColumns>& each,
                          double tolerance) {
  StressForm out;
  const std::size_t waves = wavenumbers.size(), depths = waves == 0 ? 0 : each.front().left.size();
  out.wavenumber = std::move(wavenumbers);
  std::vector<std::vector<float>> core(waves);
  for (std::size_t d = 0; d < depths; ++d) {
    const double of_all = tolerance * std::sqrt(static_cast<double>(waves)); // in the mean that of each
    std::vector<Eigen::MatrixXd> parts;
    for (const FewColumns& one : each)
      parts.push_back(one.right[d]);
    const Eigen::MatrixXd from = low_rank(joined(parts), of_all).left;
    for (std::size_t k = 0; k < waves; ++k) {
      const Eigen::MatrixXd felt = product(each[k].right[d], from);
      parts[k].resize(each[k].left[d].rows(), from.cols());
      dense_product(each[k].left[d], felt, parts[k].data());
    }
    const Eigen::MatrixXd to = low_rank(joined(parts), of_all).left;
    out.left_rank.push_back(static_cast<int>(to.cols()));
    out.right_rank.push_back(static_cast<int>(from.cols()));
    for (const double value : to.reshaped())
      out.left.push_back(static_cast<float>(value));
    for (const double value : from.reshaped())
      out.right.push_back(static_cast<float>(value));
    for (std::size_t k = 0; k < waves; ++k) {
      const Eigen::MatrixXd matrix = product(to, parts[k]);
      for (Eigen::Index row = 0; row < matrix.rows(); ++row)
        for (Eigen::Index column = 0; column < matrix.cols(); ++column)
          core[k].push_back(static_cast<float>(matrix(row, column)));
    }
  }
  for (const std::vector<float>& numbers : core)
    out.core.insert(out.core.end(), numbers.begin(), numbers.end());
  return out;
}

} // namespace bem_contact::fem
