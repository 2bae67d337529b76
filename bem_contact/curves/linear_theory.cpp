#include "bem_contact/curves/linear_theory.hpp"

#include "bem_contact/curves/settings.hpp"
#include "bem_contact/sequence/hertz_model.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace bem_contact {

double LinearTheory::c() const {
  return std::sqrt(semi_axis_x * semi_axis_s);
}

std::optional<LinearTheory> linear_theory(const SceneResult& result, const Material& rail,
                                          const Material& wheel) {
  if (result.result.patches.size() != 1)
    return std::nullopt;
  const std::optional<HertzModel> hertz = fit_hertz(result.problem, rail, wheel);
  if (!hertz || !(hertz->contact.force > 0))
    return std::nullopt;
  LinearTheory out;
  out.semi_axis_x = hertz->contact.semi_axis_x;
  out.semi_axis_s = hertz->contact.semi_axis_s;
  // Its own x axis may lie nearer to s.
  const double quarter = 0.5 * std::numbers::pi, turns = std::round(hertz->angle / quarter);
  if (std::fmod(std::abs(turns), 2) == 1)
    std::swap(out.semi_axis_x, out.semi_axis_s);
  out.tilt = hertz->angle - turns * quarter;
  out.deviation = hertz->deviation;
  const double ratio = out.semi_axis_x / out.semi_axis_s;
  if (!(ratio < longest_ellipse && ratio > 1 / longest_ellipse))
    return std::nullopt;
  // Equal bodies with the same sums of compliances (Kalker 1990, section 1.4).
  out.shear_modulus = 2 / (1 / rail.shear_modulus + 1 / wheel.shear_modulus);
  out.poisson =
      0.5 * out.shear_modulus * (rail.poisson / rail.shear_modulus + wheel.poisson / wheel.shear_modulus);
  out.coefficients = reference::creep_coefficients(ratio, out.poisson);
  const double c = out.c(), cc = c * c * out.shear_modulus;
  const reference::CreepCoefficients& k = out.coefficients;
  out.slopes = {
      {{cc * k.c11, 0, 0}, {0, cc * k.c22, cc * c * k.c23}, {0, -cc * c * k.c23, cc * c * c * k.c33}}};
  return out;
}

} // namespace bem_contact
