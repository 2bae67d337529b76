#pragma once

#include "bem_contact/sequence/derivatives.hpp"
#include "bem_contact/sequence/solution/changed_contact.hpp"
#include "bem_contact/sequence/solution/solve_on_grid.hpp"

#include <vector>

namespace bem_contact {

/// Throws InputError where a scene asks for derivatives that it cannot have, before it is solved.
void require_derivatives(const SceneFile& scene);

/// Derivatives of a certified solution with respect to all numbers that the scene names, and to the points of
/// profiles: tangents of the solved contact (contact/tangent.hpp), on its elements and with elements in the
/// states that they have. What the scene says of the elements is differentiated by small differences, without
/// further solutions. Takes the numbers of `solved`. Throws InputError where there are none.
struct ResultDerivatives {
  std::vector<InputDerivatives> numbers;
  std::vector<ProfileDerivatives> profiles;
};
ResultDerivatives derivatives_of(const ContactCase& asked, GridSolution& solved,
                                 const SolveResources& resources);

} // namespace bem_contact
