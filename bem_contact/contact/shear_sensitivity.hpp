#pragma once

#include "bem_contact/contact/problem.hpp"
#include "bem_contact/contact/result.hpp"

#include <vector>

namespace bem_contact {

/// The derivative of the rigid slip w by some quantity, such as a creepage; fields.
struct SlipChange {
  std::vector<double> x, s;
};

/// The derivative of the shear tractions by the same quantity, MPa per its unit; fields.
struct ShearChange {
  std::vector<double> px, ps;
};

/// The derivative of the shear tractions of a solved problem in steady rolling, with the pressure held: the
/// system of Newton's method at the solution, with another right-hand side. Elements keep their state; where
/// one stands between two, the derivative has a jump, and this is one side of it. Exact where shear does not
/// move the pressure: equal materials on a plane.
///
/// `problem` has its influence numbers. Throws InputError for a problem without friction or in other motion
/// than steady rolling, ConvergenceError where the linear system cannot be solved.
ShearChange shear_sensitivity(const ContactProblem& problem, const ContactResult& result,
                              const SlipChange& change);

} // namespace bem_contact
