#pragma once

#include "bem_contact/sequence/solution/solve_on_grid.hpp"

namespace bem_contact {

/// Solves on a grid that grows until the contact lies inside and no second area would overlap outside (a
/// patch: a warning says so). The solution has the grid at which it ended. `on_strips`: all rows must lie on
/// the strips of the influence files. Throws InputError where these end before, or where the grid would grow
/// more than most_growths times.
GridSolution solve_on_growing_grid(const ContactCase& asked, ContactOnGrid first, const SolveTask& task,
                                   const SolveResources& resources, bool on_strips);

} // namespace bem_contact
