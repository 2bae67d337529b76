#pragma once

#include "bem_contact/scene/grid_plan.hpp"
#include "bem_contact/sequence/plan/potential_area.hpp"

namespace bem_contact {

/// The elements of a wheel on a rail. They cover all areas where h < potential_share of the estimated
/// approach times cos(delta), and the rows between them: one problem has all areas, because they act on each
/// other. If the scene asks for rows or for mx and ms, the plan has these. `origin`: rows are centred at
/// origin
/// + whole multiples of ds (a station of the rail's influence file). Throws InputError where there would be
/// too many elements.
GridPlan plan_grid(const ContactEstimate& estimate, const SceneFile::Grid& asked, double origin);

/// Widens a plan so that it covers an area.
void cover(GridPlan& plan, const PotentialArea& area);

} // namespace bem_contact
