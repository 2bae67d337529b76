#pragma once

#include "bem_contact/contact/problem.hpp"
#include "bem_contact/contact/solver_options.hpp"
#include "bem_contact/contact/work.hpp"
#include "bem_contact/scene/contact_setup.hpp"

namespace bem_contact {

/// The compliance of a layer under shear, mm^3/N, with which the slope of Fx over the longitudinal creepage
/// is `share` of what it is without the layer: at creepages so small that nothing slips, in steady rolling,
/// on the elements of the problem. The contact and its pressure are those without friction. `problem` has its
/// influence numbers, without such a layer. Returns 0 where there is no contact. Throws what solve() throws.
double compliance_of_slope(const ContactProblem& problem, double share, const SolverOptions& options,
                           WorkBudget& work);

/// That slope: the change of Fx with the longitudinal creepage where nothing slips, N. `frictionless`: the
/// pressure on the problem's elements.
double slope_without_slip(const ContactProblem& problem, const ContactResult& frictionless);

/// The slope of Fx over xi at 0 in the largest patch with this layer, over that without it: 1 / (1 + 3 C11 G
/// L / (8 a)), slopes in series, within 4 % (theory/contact.md, section 6). nan without contact.
double estimated_slope(const ContactSetup& setup, const SurfaceLayer& layer, const ContactProblem& problem,
                       const ContactResult& result);

} // namespace bem_contact
