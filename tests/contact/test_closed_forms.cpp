#include "bem_contact/reference/creep_coefficients.hpp"
#include "bem_contact/reference/hertz.hpp"
#include "tests/contact/scenes.hpp"
#include "tests/reference/line_and_quartic.hpp"
#include "tests/sanitized.hpp"

#include <gmock/gmock.h>

#include <array>

/// Closed forms as limits: the error at several sizes of the elements, and what extrapolation leaves.
namespace bem_contact {
namespace {

/// Steuermann 1939: gap A r^4. The force for a given approach, of first order or better, extrapolated to
/// 0.2 %.
TEST(ClosedForms, SteuermannsQuartic) {
  const double radius = 3, coefficient = 1e-4;
  const auto exact = reference::steuermann_by_radius(
      coefficient, reference::contact_modulus(scenes::steel, scenes::steel), radius);
  double previous = 0, force_before = 0;
  for (const int across : {10, 20, 40}) {
    const int n = across * 6 / 5;
    ContactProblem problem =
        scenes::flat(scenes::steel, scenes::steel, n, n, 2 * radius / across, 2 * radius / across, 0, 0);
    for (int i = 0; i < problem.grid.size(); ++i) {
      const double x = problem.grid.x(i % n), s = problem.rows[i / n].s, square = x * x + s * s;
      problem.gap[i] = coefficient * square * square;
    }
    problem.load = LoadKind::approach;
    problem.approach = exact.approach;
    const ContactResult result = solve(problem);
    ASSERT_TRUE(result.certified());
    const double error = std::abs(result.totals.Fz / exact.force - 1);
    if (previous > 0) {
      EXPECT_LT(error, 0.4 * previous) << across;
    }
    if (across == 40) {
      EXPECT_LT(error, 0.01);
      EXPECT_NEAR((4 * result.totals.Fz - force_before) / 3, exact.force, 0.002 * exact.force);
      EXPECT_NEAR(std::sqrt(result.patches[0].area / std::numbers::pi), radius, 0.02 * radius);
      // p ~ (1 + 2 r^2/a^2) sqrt(1 - r^2/a^2): largest in a ring (Johnson 1985, eq. 5.26)
      const double middle = result.pn[(n / 2) * n + n / 2];
      EXPECT_LT(middle, result.patches[0].pmax);
    }
    previous = error;
    force_before = result.totals.Fz;
  }
}

/// Kalker's coefficients. A pattern of whole elements covers more than the ellipse, and how much changes from
/// size to size: c^2 = area in contact / pi, and the mean over four positions of the grid on the ellipse, an
/// eighth and three eighths of an element off in x and in s. By the ellipse's symmetries (a mirror in x
/// exchanges C23 of spin and of creepage) that is as good as sixteen, at all eighths.
using FourCoefficients = std::array<double, 4>; // C11, C22, C23, C33

FourCoefficients mean_coefficients(double a_over_b, double poisson, int across) {
  const Material material{1, poisson};
  const double modulus = reference::contact_modulus(material, material), unit = 1e-4;
  // Hertz: the ratio of curvatures that gives the ratio of semi-axes, then the force that gives their size
  double low = 1e-3, high = 1e3;
  for (int step = 0; step < 60; ++step) {
    const double ratio = std::sqrt(low * high);
    const auto h = reference::hertz_by_force(1e-3, 1e-3 * ratio, modulus, 1);
    (h.semi_axis_x / h.semi_axis_s < a_over_b ? low : high) = ratio;
  }
  const double a = std::max(1.0, a_over_b), b = a / a_over_b, curvature_s = 1e-3 * low;
  const double force = std::pow(a / reference::hertz_by_force(1e-3, curvature_s, modulus, 1).semi_axis_x, 3);
  const int n = across * 11 / 10 + 2;
  SolverOptions options;
  options.estimate_discretisation = false;
  FourCoefficients mean{};
  ContactProblem problem = scenes::flat(material, material, n, n, 2 * a / across, 2 * b / across, 0, 0);
  problem.force = force;
  const ContactProblem centred = problem;
  for (int shift = 0; shift < 4; ++shift) {
    const double shift_x = (shift % 2 ? 0.125 : 0.375) * problem.grid.dx,
                 shift_s = (shift / 2 ? 0.125 : 0.375) * problem.grid.ds;
    problem.grid.x0 = centred.grid.x0 + shift_x;
    for (int is = 0; is < n; ++is)
      problem.rows[is].s = problem.rows[is].position.y = centred.rows[is].s + shift_s;
    for (int i = 0; i < problem.grid.size(); ++i) {
      const double x = problem.grid.x(i % n), s = problem.rows[i / n].s;
      problem.gap[i] = 1e-3 * x * x + curvature_s * s * s;
    }
    std::array<ContactResult, 3> rolled;
    for (int i = 0; i < 3; ++i) {
      scenes::set_creepage(problem, 1e6, i == 0 ? unit : 0, i == 1 ? unit : 0, i == 2 ? unit : 0);
      rolled[i] = solve(problem, options);
      EXPECT_TRUE(rolled[i].certified()) << rolled[i].trust.solver_note;
    }
    const auto& [along, lateral, spin] = rolled;
    const double cc = along.patches[0].area / std::numbers::pi, c = std::sqrt(cc);
    const FourCoefficients values{along.totals.Fx / (cc * unit), lateral.totals.Fy / (cc * unit),
                                  0.5 * (spin.totals.Fy - lateral.totals.Mz) / (cc * c * unit),
                                  spin.totals.Mz / (cc * cc * unit)};
    for (std::size_t i = 0; i < 4; ++i)
      mean[i] += values[i] / 4;
  }
  return mean;
}

struct ContactEllipse {
  double a_over_b, poisson;
};
struct KalkersCoefficients : testing::TestWithParam<ContactEllipse> {};

/// Against the linear theory, a method of its own: the error is of first order, and three sizes leave of it,
/// with terms of first and second order taken off, less than 0.1 % (C33: 0.5 %).
TEST_P(KalkersCoefficients, WithinHalfAPercentExtrapolated) {
  NEEDS_NO_SANITIZER();
  const auto& [a_over_b, poisson] = GetParam();
  const reference::CreepCoefficients k = reference::creep_coefficients(a_over_b, poisson);
  const FourCoefficients exact{k.c11, k.c22, k.c23, k.c33};
  const FourCoefficients coarse = mean_coefficients(a_over_b, poisson, 20),
                         middle = mean_coefficients(a_over_b, poisson, 40),
                         fine = mean_coefficients(a_over_b, poisson, 80);
  double coarse_error = 0, middle_error = 0, fine_error = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const double limit = (8 * fine[i] - 6 * middle[i] + coarse[i]) / 3;
    EXPECT_NEAR(limit, exact[i], (i < 3 ? 0.001 : 0.005) * exact[i]) << i;
    coarse_error += std::abs(coarse[i] / exact[i] - 1);
    middle_error += std::abs(middle[i] / exact[i] - 1);
    fine_error += std::abs(fine[i] / exact[i] - 1);
  }
  EXPECT_LT(middle_error, 0.7 * coarse_error);
  EXPECT_LT(fine_error, 0.7 * middle_error);
}

const auto ellipses =
    testing::Values(ContactEllipse{2, 0.25}, ContactEllipse{1, 0}, ContactEllipse{1, 0.25},
                    ContactEllipse{1, 0.28}, ContactEllipse{1, 0.5}, ContactEllipse{0.5, 0.25});
INSTANTIATE_TEST_SUITE_P(References, KalkersCoefficients, ellipses,
                         [](const auto& test) { return "point" + std::to_string(test.index); });

} // namespace
} // namespace bem_contact
