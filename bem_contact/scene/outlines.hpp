#pragma once

#include "bem_contact/scene/contact_setup.hpp"

#include <vector>

namespace bem_contact {

/// Holds both bodies at approach 0, for pictures: points in the frame of the rows, mm. Wheel on rail: the
/// whole profile of the rail and the contact locus of the wheel, fine near the rows; patch: the rows, and the
/// upper body above the middle column.
struct Outlines {
  std::vector<Point2> rail, wheel;
};
Outlines outlines(const ContactSetup& setup, const ContactProblem& problem);

} // namespace bem_contact
