#pragma once

#include "bem_contact/profile/sections/sectioned_surface.hpp"

#include <vector>

namespace bem_contact {

/// The surface of a wheel from its sections at angles, rad: u is the angle, from -pi to pi and beyond.
///
/// Sections lie within one turn, wherever it begins; those beyond it, as CONTACT's files have them, must say
/// again what the first ones say. From the last one the surface goes on to the first one. Where that is by
/// far the longest way between two, as of sections about a flat, the wheel is round there: it keeps the last
/// section, and then the first. Throws what SectionedSurface does, and for sections that are more than a
/// turn.
SectionedSurface wheel_surface(std::vector<BodySection> sections, bool approximated = false);

} // namespace bem_contact
