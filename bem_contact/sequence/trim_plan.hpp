#pragma once

#include "bem_contact/sequence/solve_on_grid.hpp"

namespace bem_contact {

/// A plan without what the contact does not need, and what it took to know that.
struct TrimmedPlan {
  GridPlan plan;
  PhaseSeconds seconds;
};

/// The estimate is generous, and influence numbers that depend on both rows grow with the square of the rows:
/// where those of a wheel on a rail would be large_numbers or more, the case is first solved on elements
/// trim_factor times as large, and the plan keeps what comes near to touching there. Its elements stay where
/// they are. Any other plan stays as it is, and so does one whose rough solution is none. `on_strips`: all
/// rows must lie on the strips of the influence files.
TrimmedPlan trimmed(const ContactCase& asked, const GridPlan& plan, const SolveTask& task,
                    const SolveResources& resources, bool on_strips);

} // namespace bem_contact
