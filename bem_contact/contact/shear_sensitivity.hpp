#pragma once

#include "bem_contact/contact/problem.hpp"
#include "bem_contact/contact/result.hpp"

#include <span>
#include <vector>

namespace bem_contact {

/// A change of the rigid slip w, per unit of what changes it; fields.
struct SlipChange {
  std::vector<double> x, s;
};

/// What it changes of the shear tractions, MPa per the same unit; fields.
struct ShearChange {
  std::vector<double> px, ps;
};

/// Derivatives of the shear tractions of a solved problem in steady rolling, for each of the changes, with
/// the pressure held: the system of Newton's method at the solution, with another right-hand side. Elements
/// keep their state; where one stands between two, the derivative has a jump, and this is one side of it.
/// Exact where shear does not move the pressure: equal materials on a plane.
///
/// `problem` has its influence numbers. Throws InputError for a problem without friction or in other motion
/// than steady rolling, ConvergenceError where the linear system cannot be solved.
std::vector<ShearChange> shear_sensitivities(const ContactProblem& problem, const ContactResult& result,
                                             std::span<const SlipChange> changes);

} // namespace bem_contact
