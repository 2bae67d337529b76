#pragma once

#include "bem_contact/sequence/derivatives.hpp"
#include "bem_contact/sequence/solution/solve_on_grid.hpp"

#include <vector>

namespace bem_contact {

/// Throws InputError where a scene asks for derivatives that it cannot have, before it is solved.
void require_derivatives(const SceneFile& scene);

/// What the scene says of the elements of `contact` with one of its numbers changed to both sides, and a half
/// of the difference between the two, in its unit.
struct ChangedContact {
  ContactCase lower_case, upper_case;
  ContactOnGrid lower, upper;
  double step = 0;
};
/// `which`: of derivative_inputs() of the scene.
ChangedContact changed_contact(const ContactCase& asked, const ContactOnGrid& contact, int which);

/// Derivatives of a certified solution with respect to all numbers that the scene names: tangents of the
/// solved contact (contact/tangent.hpp), on its elements and with elements in the states that they have. What
/// the scene says of the elements is differentiated by small differences, without further solutions. Takes
/// the numbers of `solved`. Throws InputError where there are none.
std::vector<InputDerivatives> derivatives_of(const ContactCase& asked, GridSolution& solved,
                                             const SolveResources& resources);

} // namespace bem_contact
