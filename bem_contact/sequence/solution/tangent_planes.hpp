#pragma once

#include "bem_contact/sequence/solution/solve_on_grid.hpp"

namespace bem_contact {

/// solve_on_growing_grid(). On planes (grid.planar) each patch gets a plane of its own, which touches the
/// rail at the patch's centre of pressure. The pressure alone says where that is; where the whole solution
/// leaves that point, the planes are moved there and the case is solved again. Throws InputError where the
/// planes do not come to rest.
GridSolution solve_on_tangent_planes(const ContactCase& asked, ContactOnGrid first, const SolveTask& task,
                                     const SolveResources& resources, bool on_strips);

} // namespace bem_contact
