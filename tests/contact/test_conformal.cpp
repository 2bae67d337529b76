#include "bem_contact/halfspace/resample.hpp"
#include "bem_contact/halfspace/tangent_plane.hpp"
#include "bem_contact/reference/conformal.hpp"
#include "tests/contact/scenes.hpp"

#include <gmock/gmock.h>

namespace bem_contact {
namespace {

constexpr double radius = 10, clearance = 0.002;

/// Pin in a hole, plane strain, tangent-plane numbers; the force that gives `half_angle`.
ContactProblem pin_in_hole(double half_angle, int count) {
  ContactProblem problem;
  const double ds = 2.7 * half_angle * radius / count;
  problem.grid = {1, count, 0, ds, 0};
  std::vector<halfspace::StripRow> hole, pin;
  for (int i = 0; i < count; ++i) {
    const double s = (i - 0.5 * (count - 1)) * ds, t = s / radius;
    const Point2 position{radius * std::sin(t), -radius * (1 - std::cos(t))};
    problem.rows.push_back({s, position, -t});
    hole.push_back({position, -t});
    pin.push_back({-1.0 * position, -t});
    const double r = radius - clearance;
    problem.gap.push_back(radius - clearance * std::cos(t) -
                          std::sqrt(r * r - std::pow(clearance * std::sin(t), 2)));
  }
  const halfspace::StripGrid grid{0, ds, 1, radius};
  problem.numbers = halfspace::combine(halfspace::tangent_plane_numbers(scenes::steel, grid, hole),
                                       halfspace::tangent_plane_numbers(scenes::steel, grid, pin));
  problem.force =
      reference::plane_strain_modulus(scenes::steel) * clearance / reference::persson_clearance(half_angle);
  problem.tangential = false;
  return problem;
}

struct Persson : testing::TestWithParam<double> {};

TEST_P(Persson, ByTangentPlaneNumbers) {
  const double half_angle = GetParam() * std::numbers::pi / 180;
  double previous = 0;
  for (const int count : {54, 108, 216}) {
    const ContactProblem problem = pin_in_hole(half_angle, count);
    const ContactResult result = solve(problem);
    ASSERT_TRUE(result.converged) << result.remark;
    double square = 0, norm = 0;
    for (int i = 0; i < count; ++i) {
      const double p =
          reference::persson_pressure(half_angle, problem.rows[i].delta) * problem.force / radius;
      square += (result.pn[i] - p) * (result.pn[i] - p);
      norm += p * p;
    }
    const double error = std::sqrt(square / norm);
    if (previous > 0) {
      EXPECT_LT(error, 0.65 * previous) << count;
    }
    previous = error;
    if (count < 216)
      continue;
    const double pmax = reference::persson_pressure(half_angle, 0) * problem.force / radius;
    EXPECT_NEAR(result.patches[0].pmax, pmax, 0.002 * pmax);
    EXPECT_NEAR(0.5 * result.patches[0].area / radius, half_angle, 0.01 * half_angle);
  }
}

INSTANTIATE_TEST_SUITE_P(HalfAngles, Persson, testing::Values(10, 20, 30, 45, 60),
                         [](const auto& test) { return std::to_string(static_cast<int>(test.param)); });

} // namespace
} // namespace bem_contact
