#pragma once

#include "bem_contact/sequence/plan/model_choice.hpp"
#include "bem_contact/sequence/solution/section_ends.hpp"
#include "bem_contact/sequence/solution/solve_on_grid.hpp"

#include <string>

namespace bem_contact {

/// A case solved where its structures' motion has taken the bodies.
struct PlacedSolution {
  ContactCase asked; ///< of the bodies as they stand
  GridSolution solved;
  std::optional<StructuralResult> structure; ///< nothing where no body's structure gives way
  std::optional<SectionEnds> ends;           ///< of a rail of sections with influence files
};

/// solve_on_tangent_planes(), and after it, if structural compliance is included (fem) and the scene wants
/// the bodies placed (solver.structural_motion):
/// 1. the force of the contact on each body gives its structural motion (influence/structure.hpp);
/// 2. the bodies are moved by it and the wheel is lowered until it touches; contact points, gap and rigid
///    slip are found anew;
/// 3. the contact is solved again there. Its influence numbers contain the structural motion too, so the
///    former motion is subtracted from the gap: the numbers then add only the change of the motion.
/// With solver.contact_motion = "placed" (any model but Hertz's) the wheel is moved along y, too, as the
/// surfaces in contact slide past each other.
/// This is repeated until the contact moves by less than position_tolerance. Placed are bodies of a wheel on
/// a rail in steady rolling or without friction. Throws ConvergenceError where the bodies do not come to
/// rest, and what solve_on_tangent_planes() throws.
PlacedSolution solve_on_placed_bodies(const ContactCase& asked, const SceneFile::Grid& grid,
                                      ContactOnGrid first, const SolveTask& task,
                                      const SolveResources& resources);

/// Says whether the geometry follows the contact's own motion (solver.contact_motion), too.
bool is_placed_by_contact(const SceneFile& scene);

/// The approach less the structural motion at the contact, mm; without structural motion the approach itself.
double local_approach(const ContactCase& asked, const GridSolution& solved);

/// The surfaces in contact slide past each other along s as the bodies approach. This is the largest
/// distance, mm, that is not yet part of the geometry with which the case was solved.
double unseen_slide(const ContactCase& asked, const GridSolution& solved);

/// SceneResult::approach_datum.
std::string approach_datum(const ContactCase& asked, Model model);

} // namespace bem_contact
