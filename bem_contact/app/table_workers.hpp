#pragma once

#include "bem_contact/table/refine.hpp"

#include <functional>

namespace bem_contact::app {

/// Solves points in `jobs` processes side by side (sweep_workers.hpp); 0: one for each core. `make` gives a
/// solver with a Sequence of its own. Which points start from which others does not depend on `jobs`.
table::PointsSolver side_by_side(std::function<table::PointSolver()> make, int jobs);

} // namespace bem_contact::app
