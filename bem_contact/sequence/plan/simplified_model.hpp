#pragma once

#include "bem_contact/contact/result.hpp"
#include "bem_contact/scene/contact_setup.hpp"
#include "bem_contact/sequence/plan/model_errors.hpp"

#include <optional>

namespace bem_contact {

/// Kalker's simplified theory (FASTSIM, 1982) on these ellipses, in steady rolling. From p = 0 at the leading
/// edge, with the creepages at the middle of the patch,
///     dp_x/dx = -(xi / L1 - phi s / L3), dp_s/dx = -(eta / L2 + phi x / L3),
///     L1 = 8 a / (3 C11 G), L2 = 8 a / (3 C22 G), L3 = pi a sqrt(a/b) / (4 C23 G),
/// and where |p| exceeds mu times a paraboloid of the normal force it is that in its own direction: bounded
/// slip. The pressure that the result has is Hertz's ellipsoid; in the middle of a patch the paraboloid is
/// 4/3 of it. Creepages of prescribed shear forces are found. A prescribed vertical force is that of pressure
/// and shear together. Throws InputError for a contact that the theory does not fit: without friction, in
/// other motions, in plane strain, with friction that jumps or falls with heat, on elements that are too
/// large or, where friction falls with slip, too small.
ContactResult solve_simplified(const ContactSetup& setup, const ContactProblem& problem);

/// What the error of the simplified theory grows with: means over the patches, by their normal forces.
struct SimplifiedTraits {
  double deviation = 0; ///< largest distance of the undeformed distance from the ellipse's, over the approach
  double turn = 0;      ///< of the normal within the patch, rad
  double inclination = 0; ///< rad
  double spin = 0;        ///< |phi| sqrt(ab) / mu
};
SimplifiedTraits simplified_traits(const ContactSetup& setup, const ContactProblem& problem);

/// Predicts what it misses of the half-space: bounds that held in 98 of 100 random scenes
/// (theory/contact.md, section 6). Nothing for a contact that it does not serve. `traits`: for what
/// half-space theory misses.
std::optional<ClosedFormFit> fit_of_simplified(const ContactSetup& setup, const ContactProblem& problem,
                                               const ContactTraits& traits);

} // namespace bem_contact
