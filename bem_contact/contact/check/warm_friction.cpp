#include "bem_contact/contact/check/warm_friction.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bem_contact::contact {
namespace {

/// K q of an element: theory/estimates_and_heat.md, section 3. MPa sqrt(s)
double heat_behind(const ContactProblem& problem, const std::vector<double>& heat, int element) {
  double sum = 0;
  const int columns = problem.grid.mx - element % problem.grid.mx;
  for (int m = 0; m < columns; ++m) {
    const double far = (m + 0.5) * problem.grid.dx, near = std::max(0.0, far - problem.grid.dx);
    sum += 2 * (std::sqrt(far) - std::sqrt(near)) * heat[element + m];
  }
  return sum / std::sqrt(std::numbers::pi * problem.speed);
}

} // namespace

std::vector<double> warm_temperatures(const ContactProblem& problem, const std::vector<double>& heat) {
  std::vector<double> out(heat.size());
  const Heating& heating = *problem.heating;
  const double rail = heating.rail.effusivity(), wheel = heating.wheel.effusivity();
  const double rail_share = heating.rail_share.value_or(rail / (rail + wheel));
  const double cold =
      heating.rail_share
          ? 0.5 * (heating.rail.temperature + heating.wheel.temperature)
          : (rail * heating.rail.temperature + wheel * heating.wheel.temperature) / (rail + wheel);
  const double rise = 0.5 * (rail_share / rail + (1 - rail_share) / wheel); // of the mean, under a unit
  for (int i = 0; i < problem.grid.size(); ++i)
    out[i] = cold + rise * heat_behind(problem, heat, i);
  return out;
}

} // namespace bem_contact::contact
