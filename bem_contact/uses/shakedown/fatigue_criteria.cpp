#include "bem_contact/uses/shakedown/fatigue_criteria.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace bem_contact::shakedown {

namespace {

double hydrostatic(const halfspace::Stress& t) {
  return (t.xx + t.ss + t.nn) / 3;
}

} // namespace

double dang_van(std::span<const halfspace::Stress> stresses, const Ball& ball, double a) {
  double out = -std::numeric_limits<double>::infinity();
  for (const halfspace::Stress& t : stresses) {
    const Deviator amplitude = deviator(t) - ball.middle;
    // no shear exceeds the length of its deviator
    if (const double pressure = a * hydrostatic(t); amplitude.norm() + pressure > out)
      out = std::max(out, largest_shear(stress_of(amplitude)) + pressure);
  }
  return out;
}

double crossland(std::span<const halfspace::Stress> stresses, const Ball& ball, double alpha) {
  double largest = -std::numeric_limits<double>::infinity();
  for (const halfspace::Stress& t : stresses)
    largest = std::max(largest, hydrostatic(t));
  return ball.radius + alpha * largest;
}

double crossland_alpha(double a) {
  return a + 1.5 - std::numbers::sqrt3;
}

} // namespace bem_contact::shakedown
