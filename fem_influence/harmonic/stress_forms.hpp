#pragma once

#include "bem_contact/influence/stress_kernel.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <span>
#include <vector>

namespace bem_contact::fem {

/// One matrix for each depth, [6 place + component][3 station + component], MPa per MPa.
using DepthMatrices = std::vector<Eigen::MatrixXd>;

/// The same with few columns (low_rank.hpp), as numbers: how many depths there are; then of each the number
/// of columns, all of left and all of right.
std::vector<double> few_columns(const DepthMatrices& matrices, double tolerance);

/// Takes one of these from the front of some numbers, for so many rows of left and right; empty where they
/// are none.
struct FewColumns {
  std::vector<Eigen::MatrixXd> left, right; ///< [depth]
};
FewColumns take_few_columns(std::span<const double>& numbers, std::size_t left_rows, std::size_t right_rows);

/// All wavenumbers of one form: of each depth the columns that serve all of them.
StressForm common_columns(std::vector<double> wavenumbers, const std::vector<FewColumns>& each,
                          double tolerance);

} // namespace bem_contact::fem
