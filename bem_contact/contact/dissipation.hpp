#pragma once

#include "bem_contact/contact/problem.hpp"
#include "bem_contact/contact/result.hpp"

#include <span>

namespace bem_contact::contact {

/// ContactFields::dissipated. In steady rolling friction dissipates what the motion of the bodies drives, and
/// the slip of elements shows only a part of that: waves of the tractions lose energy on elements
/// (slip_step.hpp). What is missing of a patch's driving power is put where the tractions change most from
/// element to element, for there waves are short (theory/estimates_and_heat.md, section 2).
std::vector<double> dissipated(const ContactProblem& problem, const ContactResult& result);

/// p_t S over the step's length, what the slip of each element shows, MPa (shift: MPa mm); field.
std::vector<double> dissipated_in_slip(const ContactResult& result);

/// What the rigid motion of the bodies does on element i through shear, per area: p_t w. `lateral_share`:
/// ContactProblem::lateral_share() of its row.
double shear_drive(const ContactProblem& problem, const ContactResult& result, int i, double lateral_share);

/// What it does through the pressure on the elements of a patch: the sum over them, per area of one element.
/// 0 where the contact reaches the first or last column of the grid.
double pressure_drive(const ContactProblem& problem, const ContactResult& result,
                      std::span<const int> elements);

} // namespace bem_contact::contact
