#pragma once

#include "bem_contact/scene/contact_setup.hpp"
#include "bem_contact/scene/warning.hpp"

#include <string>

namespace bem_contact {

/// Input that can be solved but is probably a mistake, in sentences: another unit, a diameter for a radius, a
/// wheel that stands on its flange, keys that have no effect. `setup`: of the scene.
Warnings input_warnings(const SceneFile& scene, const ContactSetup& setup);

/// Warns of a vertical force on so many wheels that is probably in kN.
void warn_of_kilonewtons(const char* key, double force, int wheels, Warnings& warnings);

/// What is wrong with inclining a rail by `given` (rad) that its file has inclined already, or leaning the
/// other way; "": nothing.
std::string inclined_twice(const RailInclination& rail, double given);

/// Says whether gauge and flange backs place the bodies, not coordinates of their own.
bool by_gauge_and_flange(const SceneFile& scene);

/// What is wrong with a wheel whose flange, at lateral displacement 0, stands where the rail's gauge face is;
/// "": nothing. The wheelset then has no play, and stands on both of its flanges.
std::string no_play(const WheelsetPosition& position, const TabulatedProfile& wheel);

} // namespace bem_contact
