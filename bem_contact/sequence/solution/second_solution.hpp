#pragma once

#include "bem_contact/contact/solve.hpp"

#include <string>

namespace bem_contact {

/// Where friction falls with slip velocity or temperature, a contact may have several solutions: `result` is
/// the one that comes from adhesion. Looks for one that comes from sliding and says what it is, with figures;
/// "" if there is none. Prescribed shear forces: whether a larger creepage gives the same force, as all
/// slides.
std::string second_solution(const ContactProblem& problem, const ContactResult& result, SolverOptions options,
                            WorkBudget& work);

} // namespace bem_contact
