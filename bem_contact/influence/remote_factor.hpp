#pragma once

#include "bem_contact/influence/influence_function.hpp"

#include <Eigen/Core>

/// Private to this room.
namespace bem_contact {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The structural part of the kernel at wavenumber[k] is factor^T factor, mm/MPa; factor is 6 x 3 stations.
/// Throws InputError where the remote section's own compliance is not positive definite.
RowMajor remote_factor(const InfluenceStrip& strip, StationRange range, Eigen::Index k);

} // namespace bem_contact
