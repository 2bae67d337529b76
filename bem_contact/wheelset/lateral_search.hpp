#pragma once

#include <functional>
#include <optional>

namespace bem_contact {

/// Sum of the lateral forces on both rails, N, of a wheelset that stands at this lateral displacement, mm.
/// Nothing where it does not stand.
using AxleLateralForce = std::function<std::optional<double>(double lateral)>;

/// A displacement at which the force is about what is wanted, and its slope there.
struct LateralGuess {
  double lateral = 0, slope = 0; ///< mm, N/mm
};

/// The first one from `start` on, to the side on which the force is met if it grows with the displacement, as
/// it does until a wheel climbs its rail; within rough_lateral_width. Throws InputError, with what the force
/// reaches, where it is not met.
LateralGuess search_lateral(const AxleLateralForce& force, double start, double wanted);

} // namespace bem_contact
