#pragma once

#include "bem_contact/sequence/solution/solve_on_grid.hpp"

namespace bem_contact {

/// The elements of a plan that are joined `factor` by `factor`. `on_strips`: as far as the strips of the
/// influence files reach.
GridPlan rough_plan(const ContactCase& asked, const GridPlan& plan, int factor, bool on_strips);

/// Says whether the influence numbers on a plan depend on both rows and take large_numbers or more, where the
/// scene leaves it open which rows and columns are solved.
bool has_large_numbers(const ContactCase& asked, const GridPlan& plan, Model model);

/// A plan without the rows and columns that the contact does not need, and the work that found them.
struct TrimmedPlan {
  GridPlan plan;
  PhaseSeconds seconds;
};

/// The estimate of a wheel on a rail is generous, and numbers that depend on both rows grow with their
/// square. So the case is first solved on elements trim_factor times as large. The plan keeps the rows and
/// columns where the bodies come near to touching; its elements stay where they are. It stays as it is where
/// there is no rough solution. `on_strips`: all rows must lie on the strips of the influence files.
TrimmedPlan trimmed(const ContactCase& asked, const GridPlan& plan, const SolveTask& task,
                    const SolveResources& resources, bool on_strips);

/// A plan for a contact that lies where a former solution had it: larger where that is beyond the plan; and,
/// for models whose numbers depend on both rows, without the rows and columns that it does not need.
/// `former`: null, or of areas alike() the case's.
GridPlan fitted(const ContactCase& asked, GridPlan plan, Model model, const FormerSolution* former);

} // namespace bem_contact
