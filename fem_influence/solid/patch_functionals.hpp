#pragma once

#include "fem_influence/shared/sparse_columns.hpp"
#include "fem_influence/solid/solid_body.hpp"
#include "fem_influence/solid/solid_surface.hpp"

#include <span>

namespace bem_contact::fem {

/// Functionals f(v) = integral over the patch of v . e_j ds dx with the surface's own frame: column 3 P + j,
/// rows 3 node + component with hanging nodes replaced by their masters. It is the load vector of a unit
/// traction and, over the area, the mean displacement. One array for both keeps Maxwell-Betti exact. Throws
/// InputError where the group `contact` does not cover a patch.
SparseColumns patch_functionals(const SolidBody& body, const ContactSurface& surface,
                                std::span<const SurfacePatch> patches);

} // namespace bem_contact::fem
