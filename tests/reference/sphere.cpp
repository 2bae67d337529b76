#include "tests/reference/sphere.hpp"

#include "bem_contact/reference/positive.hpp"

#include <numbers>

namespace bem_contact::reference {
namespace {

void require_mode(const Material& material, double radius, int n) {
  require_positive({{"shear modulus", material.shear_modulus}, {"radius", radius}});
  if (n < 0 || n == 1)
    throw InputError("the sphere has no such mode", "n = " + std::to_string(n) + "; n = 1 is a rigid motion",
                     "give n = 0 or n >= 2");
}

} // namespace

// Both: Lur'e 1964, "Three-Dimensional Problems of the Theory of Elasticity", chapter 6, the general solution
// of degree n with its shear traction made zero on the surface. Inside, with r = R = 1,
//   u_r = A (n+1)(n-2+4nu) + B n,  sigma/2G = A (n+1)(n^2-n-2-2nu) + B n(n-1),
//   tau/2G ~ A (n^2+2n-1+2nu) + B (n-1);
// outside n is replaced by -(n+1).
double ball_mode(const Material& material, double radius, int n) {
  require_mode(material, radius, n);
  const double m = n, nu = material.poisson;
  const double a = 1 / (4 * material.shear_modulus * (m * m + m + 1 + (2 * m + 1) * nu));
  const double rest = n == 0 ? 0 : m * (m * m + 2 * m - 1 + 2 * nu) / (m - 1);
  return radius * a * ((m + 1) * (m - 2 + 4 * nu) - rest);
}

double cavity_mode(const Material& material, double radius, int n) {
  require_mode(material, radius, n);
  const double m = n, nu = material.poisson;
  const double c = 1 / (4 * material.shear_modulus * (m * m + m + 1 - (2 * m + 1) * nu));
  return radius * c * (m * (m + 3 - 4 * nu) - (m + 1) * (m * m - 2 + 2 * nu) / (m + 2));
}

double EqualRings::area() const {
  return 2 * std::numbers::pi * radius * radius * step;
}

double EqualRings::cosine(int ring) const {
  return 1 - step * (ring + 0.5);
}

std::vector<double> ring_numbers(const Material& ball, const Material& seat, const EqualRings& rings,
                                 int modes) {
  require_positive({{"radius", rings.radius}, {"step of the rings", rings.step}});
  if (rings.count < 1 || rings.count * rings.step > 2 || modes < 2)
    throw InputError("there are no such rings on a sphere",
                     std::to_string(rings.count) + " of " + std::to_string(rings.step) + ", " +
                         std::to_string(modes) + " modes",
                     "give at least one ring, at most a whole sphere, and at least two modes");
  const std::size_t n = rings.count;
  std::vector<double> border(n + 1), before(n + 1, 1.0), current(n + 1), share(n);
  for (std::size_t i = 0; i <= n; ++i)
    current[i] = border[i] = 1 - rings.step * static_cast<double>(i);
  std::vector<double> numbers(n * n);
  const auto add = [&](double compliance, double degree) {
    const double weight = compliance * (2 * degree + 1) / (2 * rings.step);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        numbers[i * n + j] += weight * share[i] * share[j];
  };
  const auto compliance = [&](int degree) {
    return cavity_mode(seat, rings.radius, degree) - ball_mode(ball, rings.radius, degree);
  };
  share.assign(n, rings.step); // the integral of P_0 over each ring
  add(compliance(0), 0);
  for (int degree = 1; degree <= modes; ++degree) {
    const double m = degree;
    std::vector<double> next(n + 1);
    for (std::size_t i = 0; i <= n; ++i)
      next[i] = ((2 * m + 1) * border[i] * current[i] - m * before[i]) / (m + 1);
    // the integral of P_n is (P_{n+1} - P_{n-1})/(2n + 1)
    for (std::size_t i = 0; i < n; ++i)
      share[i] = (next[i] - before[i] - next[i + 1] + before[i + 1]) / (2 * m + 1);
    if (degree > 1)
      add(compliance(degree), m);
    before = std::move(current);
    current = std::move(next);
  }
  return numbers;
}

} // namespace bem_contact::reference
