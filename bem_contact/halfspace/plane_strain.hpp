#pragma once

#include "bem_contact/halfspace/kernels.hpp"

namespace bem_contact::halfspace {

/// Displacement under unit uniform traction on a strip that is `ds` wide and infinitely long, averaged over
/// an equal strip whose centre is s away. It is 0 at `reference_distance`, mm, because in plane strain a
/// displacement is known but for a constant (Johnson 1985, section 2.3; u_x: a line load along x, antiplane).
Matrix3 averaged_plane_strain(const Material& material, double s, double ds, double reference_distance);

} // namespace bem_contact::halfspace
