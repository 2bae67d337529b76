#pragma once

#include "bem_contact/sequence/scene_result.hpp"

#include <vector>

namespace bem_contact {

/// Adds to the stated errors of a wheel on a rail what linear kinematics leaves open (theory/contact.md,
/// section 1): the surfaces in contact slide past each other along s, and the geometry does not follow.
/// Returns its part of the error of Fy, N; 0 where the geometry follows (solver.contact_motion) and where no
/// error is stated.
///
/// A wheel that slides by d along the rail carries its contact along, to where the rail is inclined
/// otherwise, by its curvature times d. With the vertical force given, the resultant of normal and shear
/// force turns with it: Fy changes by (Fy^2 + Fz^2)/Fz times that turn, the normal force by its share Fy/Fz
/// times the turn, and pressure, area and approach as Hertz's do with the normal force. Errors that are not
/// stated, or 0 because a number is prescribed, stay as they are.
double add_slide_errors(SceneResult& solved);

/// What a search for a lateral force solved on its way.
struct LateralTrial {
  ContactTotals totals;
  double moment = 0; ///< SceneResult::moment, N mm
};
/// Where Fy is prescribed, what it is uncertain by is another lateral displacement. Adds to all stated errors
/// what `lateral_force` (N, add_slide_errors()) changes there, by the difference to a trial beside it.
void add_position_errors(const std::vector<LateralTrial>& trials, double lateral_force, SceneResult& solved);

} // namespace bem_contact
