#include "bem_contact/contact/flash_temperature.hpp"

#include "bem_contact/contact/dissipation.hpp"

#include <cmath>
#include <numbers>

namespace bem_contact {
namespace {

/// Rise of temperature times effusivity, m columns behind an element under a unit of heat; sqrt(s).
std::vector<double> rises(const ContactGrid& grid, double speed) {
  std::vector<double> out(grid.mx);
  for (int m = 0; m < grid.mx; ++m)
    out[m] = 2 * std::sqrt(grid.dx / (std::numbers::pi * speed)) *
             (std::sqrt(m + 0.5) - (m > 0 ? std::sqrt(m - 0.5) : 0.0));
  return out;
}

/// One surface: what flowed into it is known ahead of a column.
struct Surface {
  Surface(const ThermalBody& body, int columns)
      : temperature(body.temperature), effusivity(body.effusivity()), heat(columns) {}

  /// At a column, from the heat ahead of it, degrees C.
  double ahead(int column, const std::vector<double>& rise) const {
    double sum = 0;
    for (int j = column + 1; j < static_cast<int>(heat.size()); ++j)
      sum += rise[j - column] * heat[j];
    return temperature + sum / effusivity;
  }

  double temperature, effusivity;
  std::vector<double> heat; ///< that flows in, MPa mm/s
};

} // namespace

SurfaceTemperatures flash_temperatures(const ContactGrid& grid, const Heating& heating, double speed,
                                       std::span<const double> heat, std::span<const char> in_contact) {
  const std::vector<double> rise = rises(grid, speed);
  const std::size_t n = grid.size();
  SurfaceTemperatures out{std::vector<double>(n), std::vector<double>(n)};
  for (int is = 0; is < grid.ms; ++is) {
    Surface rail(heating.rail, grid.mx), wheel(heating.wheel, grid.mx);
    for (int ix = grid.mx - 1; ix >= 0; --ix) { // material meets the largest x first
      const std::size_t i = static_cast<std::size_t>(is) * grid.mx + ix;
      const double at_rail = rail.ahead(ix, rise), at_wheel = wheel.ahead(ix, rise);
      const double per_rail = rise[0] / rail.effusivity, per_wheel = rise[0] / wheel.effusivity;
      if (in_contact[i])
        rail.heat[ix] = heating.rail_share
                            ? *heating.rail_share * heat[i]
                            : (at_wheel - at_rail + per_wheel * heat[i]) / (per_rail + per_wheel);
      wheel.heat[ix] = in_contact[i] ? heat[i] - rail.heat[ix] : 0;
      out.rail[i] = at_rail + per_rail * rail.heat[ix];
      out.wheel[i] = at_wheel + per_wheel * wheel.heat[ix];
    }
  }
  return out;
}

SurfaceTemperatures flash_temperatures(const ContactProblem& problem, const ContactResult& result) {
  return flash_temperatures(problem, result,
                            problem.heat_acts() ? contact::dissipated_in_slip(result)
                                                : friction_work_density(result));
}

SurfaceTemperatures flash_temperatures(const ContactProblem& problem, const ContactResult& result,
                                       std::vector<double> heat) {
  std::vector<char> in_contact(heat.size());
  for (std::size_t i = 0; i < heat.size(); ++i) {
    heat[i] *= problem.speed;
    in_contact[i] = result.pn[i] > 0;
  }
  return flash_temperatures(problem.grid, *problem.heating, problem.speed, heat, in_contact);
}

} // namespace bem_contact
