#pragma once

#include "bem_contact/base/material.hpp"
#include "bem_contact/halfspace/line_store.hpp"
#include "bem_contact/influence/influence_numbers.hpp"

namespace bem_contact::halfspace {

/// Influence numbers of one body on a flat strip of equal rows. They depend on the distance of two rows alone
/// and are stored so (translational). `known`: lines of earlier calls; null: none.
InfluenceNumbers influence_numbers(const Material& material, double dx, double ds, int offsets, int rows,
                                   LineStore* known = nullptr);

/// Does the same in plane strain (plane_strain.hpp), with every pair of rows stored.
InfluenceNumbers plane_strain_numbers(const Material& material, double ds, int rows,
                                      double reference_distance);

} // namespace bem_contact::halfspace
