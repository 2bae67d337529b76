#pragma once

#include "fem_influence/solid/solid_numbers.hpp"

namespace bem_contact::fem {

/// The influence function as a table along x, from loads on all stations. Loads of different meshes differ by
/// the error of the meshes. So the mean of A_ij(m; I, J) and +-A_ji(m; J, I) is stored, which is reciprocal,
/// and half of their largest difference, relative to the self numbers, is the table's betti_error.
InfluenceFunction as_table(const BodyFile& body, const ProfileCurve& curve, const SolidNumbers& numbers);

/// Error by the meshes, relative to the self number. One load is computed again with elements twice as large.
/// Errors go as h^2, so the error is a third of the largest difference; we return half of it. -1: no mesh is
/// coarser.
double mesh_error(const BodyFile& body, const ProfileCurve& curve, const std::filesystem::path& mesh,
                  const SolidNumbers& numbers);

} // namespace bem_contact::fem
