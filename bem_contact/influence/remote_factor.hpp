#pragma once

#include "bem_contact/influence/influence_function.hpp"

#include <Eigen/Core>

/// Private to this room.
namespace bem_contact {

/// Stations first .. first + count - 1 of a body.
struct StationRange {
  int first = 0, count = 0;
};

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The structural part of the kernel at wavenumber[k] is factor^T factor, mm/MPa; factor is 6 x 3 stations.
/// Throws InputError where the remote section's own compliance is not positive definite.
RowMajor remote_factor(const InfluenceFunction& function, StationRange range, Eigen::Index k);

} // namespace bem_contact
