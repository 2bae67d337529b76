#pragma once

#include "bem_contact/contact/problem.hpp"

#include <vector>

namespace bem_contact::contact {

/// mu over mu(0) of elements in contact whose friction remembers (ContactProblem::memory), from their slip
/// velocities, mm/s; fields. In steady rolling, from mu(0) at the leading edge of each row in contact:
///     d mu / dt = -max(v, least_velocity) / distance (mu - mu(v)),
/// exactly where v does not change from one element to the next.
std::vector<double> remembered_factors(const ContactProblem& problem, const std::vector<double>& velocity,
                                       const std::vector<char>& in_contact);

} // namespace bem_contact::contact
