#include "bem_contact/halfspace/combine.hpp"
#include "bem_contact/halfspace/tangent_plane.hpp"
#include "tests/contact/scenes.hpp"
#include "tests/reference/conformal.hpp"
#include "tests/reference/sphere.hpp"

#include <gmock/gmock.h>

namespace bem_contact {
namespace {

constexpr double groove = 10, clearance = 0.002;

/// Pin in a hole, plane strain, tangent-plane numbers; the force that gives `half_angle`.
ContactProblem pin_in_hole(double half_angle, int count) {
  ContactProblem problem;
  const double ds = 2.7 * half_angle * groove / count;
  problem.grid = {1, count, 0, ds, 0};
  std::vector<ContactRow> pin;
  for (int i = 0; i < count; ++i) {
    const double s = (i - 0.5 * (count - 1)) * ds, t = s / groove;
    const Point2 position{groove * std::sin(t), -groove * (1 - std::cos(t))};
    problem.rows.push_back({s, position, -t});
    pin.push_back({s, -1.0 * position, -t});
    const double r = groove - clearance;
    problem.gap.push_back(groove - clearance * std::cos(t) -
                          std::sqrt(r * r - std::pow(clearance * std::sin(t), 2)));
  }
  const halfspace::StripGrid grid{0, ds, 1, groove};
  problem.numbers = halfspace::combine(halfspace::tangent_plane_numbers(scenes::steel, grid, problem.rows),
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
    ASSERT_TRUE(result.certified()) << result.trust.solver_note;
    double square = 0, norm = 0;
    for (int i = 0; i < count; ++i) {
      const double p =
          reference::persson_pressure(half_angle, problem.rows[i].delta) * problem.force / groove;
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
    const double pmax = reference::persson_pressure(half_angle, 0) * problem.force / groove;
    EXPECT_NEAR(result.patches[0].pmax, pmax, 0.002 * pmax);
    EXPECT_NEAR(0.5 * result.patches[0].area / groove, half_angle, 0.01 * half_angle);
  }
}

INSTANTIATE_TEST_SUITE_P(HalfAngles, Persson, testing::Values(10, 20, 30, 45, 60),
                         [](const auto& test) { return std::to_string(static_cast<int>(test.param)); });

/// The vertical force is prescribed, and the normal force is larger: the more the normals turn.
TEST(Conformal, TheStatedErrorOfTheNormalForceHolds) {
  int cases = 0, held = 0;
  for (const double half_angle : {0.2, 0.5, 0.9})
    for (int count = 54; count <= 126; count += 6) {
      const ContactResult result = solve(pin_in_hole(half_angle, count));
      const ContactResult fine =
          solve(pin_in_hole(half_angle, 4 * count), {.estimate_discretisation = false});
      ASSERT_TRUE(result.certified() && result.trust.discretisation && fine.certified()) << count;
      const double error = result.patches.at(0).fn.error;
      EXPECT_LT(error, 1e-3 * result.patches[0].fn) << count;
      ++cases;
      held += std::abs(result.patches[0].fn - fine.patches[0].fn) <= error;
    }
  EXPECT_GE(held, 0.95 * cases) << cases;
}

/// Ball and seat are bodies of revolution about the normal, not about an axis across it. Under an
/// axisymmetric pressure a row of the strip is a ring, and rings of equal area make what the solver needs of
/// it: one area for all elements, symmetric numbers, cos(delta) whose sum over the area is the vertical
/// force. One element along x, as in plane strain; `ds` is the ring's area, forces are N.
ContactProblem ball_in_seat(const reference::SeatEntry& exact, int across) {
  const Material material{1 / 2.6, 0.3}; // E = 1
  const double edge = 1 - std::cos(exact.half_angle * std::numbers::pi / 180);
  const reference::EqualRings rings{1, edge / across, across * 7 / 5};
  ContactProblem problem;
  problem.grid = {1, rings.count, 0, rings.area(), 0};
  problem.numbers = {1, rings.count, 0, rings.area(), {}};
  problem.numbers.values.assign(problem.numbers.expected_values(), 0.0);
  const double outermost = rings.step / std::sin(std::acos(1 - rings.step * rings.count)); // narrowest, rad
  const auto numbers = reference::ring_numbers(material, material, rings, static_cast<int>(10 / outermost));
  for (int i = 0; i < rings.count; ++i) {
    for (int j = 0; j < rings.count; ++j) {
      problem.numbers.at(0, i, component_n, j, component_n) = numbers[i * rings.count + j];
      // no friction: tangential numbers are there to be positive definite
      for (const int t : {component_x, component_s})
        problem.numbers.at(0, i, t, j, t) = i == j ? numbers[0] : 0;
    }
    const double angle = std::acos(rings.cosine(i));
    problem.rows.push_back({angle, {std::sin(angle), -1 + std::cos(angle)}, -angle});
    problem.gap.push_back(clearance * (1 - rings.cosine(i)));
  }
  problem.force = exact.force * clearance;
  problem.tangential = false;
  return problem;
}

struct BallInSeat : testing::TestWithParam<reference::SeatEntry> {};

TEST_P(BallInSeat, HasTheExactPressureAndHalfAngle) {
  double previous = 0;
  for (const int across : {25, 50, 100}) {
    const ContactProblem problem = ball_in_seat(GetParam(), across);
    const ContactResult result = solve(problem, {.estimate_discretisation = false});
    ASSERT_TRUE(result.certified()) << result.trust.solver_note;
    EXPECT_NEAR(result.totals.Fz, problem.force, 1e-9 * problem.force);
    const double error = std::abs(result.pn[0] / (GetParam().pressure * problem.force) - 1);
    if (previous > 0) {
      EXPECT_LT(error, 0.6 * previous) << across;
    }
    previous = error;
    double area = result.patches.at(0).contact * problem.element_area();
    const double half_angle = std::acos(1 - area / (2 * std::numbers::pi)) * 180 / std::numbers::pi;
    EXPECT_NEAR(half_angle, GetParam().half_angle, 0.02 * GetParam().half_angle);
  }
  EXPECT_LT(previous, 0.005);
}

INSTANTIATE_TEST_SUITE_P(HalfAngles, BallInSeat, testing::ValuesIn(reference::sphere_in_seat()),
                         [](const auto& test) {
                           return std::to_string(static_cast<int>(test.param.half_angle));
                         });

} // namespace
} // namespace bem_contact
