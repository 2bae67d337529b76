#pragma once

#include "bem_contact/contact/problem.hpp"
#include "bem_contact/scene/scene_file.hpp"

namespace bem_contact {

/// Share of the softer body's Young's modulus that no pressure may exceed: strains are tens of percent there,
/// and the theory is one of small strains. (Steel yields at a hundredth of that.)
constexpr double largest_pressure_share = 0.2;

/// Throws InputError where the force prescribed exceeds that pressure even if all of the grid bore it; before
/// anything is solved.
void require_bearable(const SceneFile& scene, const ContactProblem& problem);

/// Throws InputError where a pressure found, MPa, is above it.
void require_elastic(const SceneFile& scene, double pressure);

} // namespace bem_contact
