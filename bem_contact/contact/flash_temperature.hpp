#pragma once

#include "bem_contact/contact/problem.hpp"
#include "bem_contact/contact/result.hpp"

#include <span>

namespace bem_contact {

/// Temperatures of both surfaces under a moving source of heat on a half-space whose speed is so high that
/// heat flows along the normal alone (Carslaw, Jaeger 1959, section 10.7; Peclet number V a / (2 chi) above
/// some 10). The integral over each element is exact for heat that is constant on it, at the element's
/// centre. theory/estimates_and_heat.md, section 3. `heat`: per area and time, MPa mm/s (mW/mm^2); field.
/// `in_contact`: elements where the surfaces touch; field. `speed`: mm/s.
SurfaceTemperatures flash_temperatures(const ContactGrid& grid, const Heating& heating, double speed,
                                       std::span<const double> heat, std::span<const char> in_contact);

/// Returns the temperatures of a result, heated by its friction. `problem` has speed and heating. Where heat
/// acts on friction or layer they are those that its law was solved with, of the heat that the slip of
/// elements shows.
SurfaceTemperatures flash_temperatures(const ContactProblem& problem, const ContactResult& result);
/// The same with other heat, MPa; field.
SurfaceTemperatures flash_temperatures(const ContactProblem& problem, const ContactResult& result,
                                       std::vector<double> heat);

} // namespace bem_contact
