#pragma once

#include "bem_contact/sequence/solution/solve_case.hpp"

namespace bem_contact {

/// solve_case() for a wheel in steady rolling, with SceneResult::free_rolling.
///
/// The creepage of free rolling is found from the solution, on its elements, as precisely as its stated error
/// asks for (free_creepage_of() in solve_on_grid.hpp). Where that does not succeed the case is solved once
/// more with load.force_x = 0. If motion.from_free_rolling is set, this comes first, and motion.xi is then
/// counted from there. Throws ConvergenceError if it is set and free rolling is not found. If free rolling is
/// only to be reported and is not found, the result has no free_rolling. A scene with motion.free_rolling =
/// false, and one without friction, is solved by solve_case() alone.
SceneResult solve_with_free_rolling(const ContactCase& asked, const SceneFile::Grid& grid,
                                    const SolveResources& resources);

/// Returns the same case with so much longitudinal creepage beyond free rolling, `free` (motion.xi is left
/// out).
ContactCase beyond_free_rolling(ContactCase asked, const FreeRolling& free, double creepage);

} // namespace bem_contact
