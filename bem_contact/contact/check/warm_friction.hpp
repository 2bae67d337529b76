#pragma once

#include "bem_contact/contact/problem.hpp"

#include <vector>

namespace bem_contact::contact {

/// Mean temperature of both surfaces, degrees C, from the heat of friction (MPa mm/s; field); field. For
/// elements in contact: by the closed form of surfaces that have one temperature, or by the share of each
/// (theory/estimates_and_heat.md, section 3). Shares nothing with flash_temperatures().
std::vector<double> warm_temperatures(const ContactProblem& problem, const std::vector<double>& heat);

} // namespace bem_contact::contact
