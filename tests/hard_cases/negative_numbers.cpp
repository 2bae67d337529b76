#include "tests/hard_cases/hard_case.hpp"
#include "tests/reference/conformal.hpp"

#include "bem_contact/scene/patch_geometry.hpp"

/// A pin in a hole over most of its half: influence numbers turn negative beyond 42 degrees (Michell 1899),
/// and at radius 10 / 10.02 the patch is decided by hundredths of a millimetre.
namespace bem_contact {
namespace {

/// Numbers of disc and hole in plane strain on equal arcs: A_nn from the half-space's logarithm along the
/// arc, in closed form, and the rest of Michell's kernel, smooth, at the elements' centres. Rigid terms do
/// not matter.
InfluenceNumbers michell_numbers(double radius, double ds, int rows) {
  InfluenceNumbers numbers = halfspace::plane_strain_numbers(scenes::steel, ds, rows, radius);
  numbers = scenes::pair(numbers, numbers);
  const double scale = 4 / (std::numbers::pi * reference::plane_strain_modulus(scenes::steel));
  for (int a = 0; a < rows; ++a)
    for (int b = 0; b < rows; ++b) {
      const double angle = std::abs(a - b) * ds / radius;
      const double rest =
          a == b ? -0.25 * scale
                 : reference::michell_line_load(scenes::steel, 1, angle).radial + scale * std::log(angle);
      numbers.at(0, a, component_n, b, component_n) += rest * ds;
    }
  return numbers;
}

/// A disc of radius `upper` in a hole of radius `radius` over a half angle of 88 degrees; the gap along the
/// normals.
ContactProblem pin_in_hole(double radius, double upper, int rows) {
  ContactProblem problem;
  const double reach = 88 * std::numbers::pi / 180;
  problem.grid = {1, rows, 0, 2 * radius * reach / rows, 0};
  for (int is = 0; is < rows; ++is) {
    const double s = (is - 0.5 * (rows - 1)) * problem.grid.ds;
    problem.rows.push_back(
        {s, {radius * std::sin(s / radius), radius * (std::cos(s / radius) - 1)}, -s / radius});
    problem.gap.push_back(circular_gap(-radius, upper, s));
  }
  problem.numbers = michell_numbers(radius, problem.grid.ds, rows);
  problem.tangential = false;
  return problem;
}

TEST(HardCases, NegativeInfluenceNumbers) {
  for (const double half_angle : {30.0, 60.0, 75.0, 83.0}) {
    const double eps = half_angle * std::numbers::pi / 180, radius = 10.02;
    ContactProblem problem = pin_in_hole(radius, 10, 400);
    problem.force = reference::plane_strain_modulus(scenes::steel) * 0.02 / reference::persson_clearance(eps);
    EXPECT_LT(problem.numbers.at(0, 0, component_n, 200, component_n), 0);
    char name[60];
    std::snprintf(name, sizeof name, "radius 10/10.02, half angle %.0f degrees", half_angle);
    const ContactResult result = hard::certified(
        name,
        half_angle < 42 ? "a gap of hundredths of a mm over several mm" : "influence numbers of both signs",
        problem);
    ASSERT_EQ(result.patches.size(), 1u);
    const double pmax = reference::persson_pressure(eps, 0) * problem.force / 10;
    EXPECT_NEAR(result.patches[0].pmax, pmax, 0.01 * pmax);
    EXPECT_NEAR(result.patches[0].area / 2 / radius, eps, 0.01 * eps);
  }
}

/// The same in three dimensions and rolling: a roller in a groove of 10.02, numbers of the flat strip carried
/// along.
TEST(HardCases, RadiusRatioRolling) {
  const double groove = 10.02;
  ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, 20, 48, 0.6, 0.55, 1e-3, 0);
  for (int is = 0; is < 48; ++is) {
    ContactRow& row = problem.rows[is];
    row.delta = -row.s / groove;
    row.position = {groove * std::sin(row.s / groove), groove * (std::cos(row.s / groove) - 1)};
    for (int ix = 0; ix < 20; ++ix)
      problem.gap[is * 20 + ix] += circular_gap(-groove, 10, row.s);
  }
  scenes::rotate_numbers(problem);
  problem.force = 10000;
  for (const double mu : {0.1, 0.3, 0.6})
    for (const double creepage : {2e-4, 1e-2}) {
      scenes::set_creepage(problem, mu, creepage, 0.5 * creepage, 0.2 * creepage);
      char name[60];
      std::snprintf(name, sizeof name, "radius 10/10.02 rolling, friction %.1f, creepage %.0e", mu, creepage);
      const ContactResult result = hard::certified(
          name, "a patch that turns by tens of degrees, so that pressure and shear act on each other",
          problem);
      EXPECT_FALSE(result.trust.touches_border);
    }
}

} // namespace
} // namespace bem_contact
