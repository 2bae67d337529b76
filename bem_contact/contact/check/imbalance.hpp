#pragma once

#include "bem_contact/contact/problem.hpp"
#include "bem_contact/contact/result.hpp"

#include <string>

namespace bem_contact::contact {

/// 1. The largest of what the prescribed forces miss: of the vertical one over itself, of shear forces over
/// what friction can carry. 0 where none is prescribed.
double force_imbalance(const ContactProblem& problem, const ContactResult& result);

/// Why a result that the solvers took for a solution is none. `tolerance`: theirs.
std::string violated_condition(const Certificate& certificate, double tolerance);

} // namespace bem_contact::contact
