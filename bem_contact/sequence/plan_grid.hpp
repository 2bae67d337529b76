#pragma once

#include "bem_contact/scene/grid_plan.hpp"
#include "bem_contact/sequence/contact_estimate.hpp"

namespace bem_contact {

/// The elements of a wheel on a rail. They cover all areas where h < potential_share of the estimated
/// approach times cos(delta), with the rows between them: what the areas do to each other is in the one
/// problem. Or the rows and the numbers mx, ms that the scene asks for. `origin`: rows are centred at origin
/// + whole multiples of ds (a station of the rail's influence file). Throws InputError where there would be
/// too many elements.
GridPlan plan_grid(const ContactEstimate& estimate, const SceneFile::Grid& asked, double origin);

/// Widens a plan so that it covers an area.
void cover(GridPlan& plan, const PotentialArea& area);

} // namespace bem_contact
