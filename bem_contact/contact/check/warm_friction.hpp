#pragma once

#include "bem_contact/contact/problem.hpp"

#include <vector>

namespace bem_contact::contact {

/// Factor by which the temperature of the surfaces reduces mu, from the heat of friction (MPa mm/s; field);
/// field. Where friction falls with heat (ContactProblem). For elements in contact: by the closed form of
/// surfaces that have one temperature, or by the share of each (theory/estimates_and_heat.md, section 3).
/// Shares nothing with flash_temperatures().
std::vector<double> warm_factors(const ContactProblem& problem, const std::vector<double>& heat);

} // namespace bem_contact::contact
