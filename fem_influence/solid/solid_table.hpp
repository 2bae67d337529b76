#pragma once

#include "fem_influence/solid/solid_numbers.hpp"

namespace bem_contact::fem {

/// The influence function as a table along x, from loads on all stations: made reciprocal by the mean of
/// A_ij(m; I, J) and +-A_ji(m; J, I); half of their largest difference, relative to the self numbers, is its
/// betti_error: loads of different meshes differ by the error of the meshes.
InfluenceFunction as_table(const BodyFile& body, const ProfileCurve& curve, const SolidNumbers& numbers);

/// Error by the meshes, relative to the self number, largest over the first offsets: against one load with
/// elements twice as large. Errors go as h^2 and are a third of the difference; half of it is given.
double mesh_error(const BodyFile& body, const ProfileCurve& curve, const std::filesystem::path& mesh,
                  const SolidNumbers& numbers);

} // namespace bem_contact::fem
