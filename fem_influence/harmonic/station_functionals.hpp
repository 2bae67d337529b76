#pragma once

#include "bem_contact/influence/influence_function.hpp"
#include "bem_contact/profile/body_file.hpp"
#include "bem_contact/profile/profile_curve.hpp"
#include "fem_influence/harmonic/section.hpp"
#include "fem_influence/shared/sparse_columns.hpp"

#include <span>

namespace bem_contact::fem {

/// The functionals f_Jj(v) = integral over station J of v . e_j(delta(s)) ds with the local frame
/// (e_x, e_s, e_n into the body) of the profile curve: column 3 J + j, rows 3 node + component.
/// Load vector of a unit traction and, over ds, the sampling of a mean displacement: one array for both
/// keeps Maxwell-Betti exact. ds is arc length; on a wheel it carries no rho (unit load per reference area).
/// Throws InputError unless each station is covered by whole edges of the group `contact`.
SparseColumns station_functionals(const Section& section, const ProfileCurve& curve,
                                  const BodyFile::Strip& strip, std::span<const Station> stations);

} // namespace bem_contact::fem
