#pragma once

#include "bem_contact/influence/influence_function.hpp"
#include "bem_contact/profile/body_file.hpp"
#include "bem_contact/profile/profile_curve.hpp"
#include "fem_influence/shared/elements.hpp"
#include "fem_influence/shared/section.hpp"

namespace bem_contact::fem {

/// The stations of the strip. Throws InputError where the strip is empty, leaves the curve or is not a
/// whole number of stations.
std::vector<Station> make_stations(const BodyFile::Strip& strip, const ProfileCurve& curve);

/// The functionals f_Jj(v) = integral over station J of v . e_j(delta(s)) ds with the local frame
/// (e_x, e_s, e_n into the body) of the profile curve: column 3 J + j, rows 3 node + component.
/// Load vector of a unit traction and, over ds, the sampling of a mean displacement: one array for both
/// keeps Maxwell-Betti exact. ds is arc length; on a wheel it carries no rho (unit load per reference area).
/// Throws InputError unless each station is covered by whole edges of the group `contact`.
SparseColumns station_functionals(const Section& section, const ProfileCurve& curve,
                                  const BodyFile::Strip& strip, std::span<const Station> stations);

/// The remote section: what lies between one and two times `distance` (0: 20 mm, or .8 of
/// the root of the section's mean square distance where that is less) from the strip, weighted with sin^2(pi
/// (d / distance - 1)). Near enough that it moves with the material under the strip when web, foot or disc
/// bend, far enough to be out of the contact's own field. Six functionals of a displacement v with <.> the
/// weighted mean over it and y, z from its centroid:
///     <v_x>, <v_y>, <v_z>, <y v_z - z v_y>/<y^2 + z^2>, <z v_x>/<z^2>, -<y v_x>/<y^2>.
/// Throws InputError where no cell is that far.
SparseColumns remote_functionals(const Section& section, std::span<const Station> stations, double distance);

} // namespace bem_contact::fem
