#include "bem_contact/base/error.hpp"
#include "tests/contact/scenes.hpp"
#include "tests/reference/rolling.hpp"

#include <gmock/gmock.h>

namespace bem_contact {
namespace {

/// Cattaneo's spheres with a = 1 mm (bem_contact/theory/estimates_and_heat.md 4).
const Material soft{200, 0.42};
constexpr double cattaneo_force = 9.1954, cattaneo_friction = 0.4;

ContactProblem cattaneo_problem(int across, const Material& material = soft) {
  const int n = across * 11 / 10;
  ContactProblem problem = scenes::flat(material, material, n, n, 2.0 / across, 2.0 / across, 0.01, 0.01);
  problem.force = cattaneo_force * material.shear_modulus / soft.shear_modulus * (1 - soft.poisson) /
                  (1 - material.poisson); // a = 1
  problem.motion = MotionKind::shift;
  scenes::set_creepage(problem, cattaneo_friction, 0, 0, 0);
  return problem;
}

double stick_radius(const ContactProblem& problem, const ContactResult& result) {
  double area = 0;
  for (const ElementState state : result.state)
    area += state == ElementState::adhesion ? problem.element_area() : 0;
  return std::sqrt(area / std::numbers::pi);
}

/// Cattaneo 1938, Mindlin 1949. They leave out p_y, which costs them 0.15 % of the shift at this nu.
TEST(Loads, CattaneoByForce) {
  const double shear = 7.0 / 8 * cattaneo_friction * cattaneo_force;
  const auto exact = reference::cattaneo(soft, 1, cattaneo_force, cattaneo_friction, shear);
  ASSERT_NEAR(exact.stick_ratio, 0.5, 1e-4);
  ASSERT_NEAR(exact.shift, 0.0081724, 1e-7);
  ContactProblem problem = cattaneo_problem(32);
  for (const bool along_x : {true, false}) {
    problem.force_x = along_x ? shear : 0;
    problem.force_s = along_x ? 0 : shear;
    const ContactResult result = solve(problem);
    ASSERT_TRUE(result.certified()) << result.trust.solver_note;
    EXPECT_NEAR(along_x ? result.totals.Fx : result.totals.Fs, shear, 1e-6 * shear);
    const double shift = along_x ? result.totals.creepage_x : result.totals.creepage_s;
    EXPECT_NEAR(shift, 0.00816, 0.00001);
    EXPECT_NEAR(along_x ? result.totals.creepage_s : result.totals.creepage_x, 0, 1e-6 * shift);
    EXPECT_NEAR(stick_radius(problem, result), exact.stick_ratio, 0.02);
  }
}

/// At nu = 0 there is no p_y and the solution is exact: mu p0 (sqrt(1 - r^2) - sqrt(theta^2 - r^2)). The
/// tractions converge with a power of h near 1, that of their kinks at whole elements; the shift is an
/// average.
TEST(Loads, CattaneoConverges) {
  const Material material{200, 0};
  double previous = 0;
  for (const int across : {8, 16, 32}) {
    ContactProblem problem = cattaneo_problem(across, material);
    problem.force_x = 7.0 / 8 * cattaneo_friction * problem.force;
    const auto exact = reference::cattaneo(material, 1, problem.force, cattaneo_friction, *problem.force_x);
    const ContactResult result = solve(problem);
    ASSERT_TRUE(result.certified()) << result.trust.solver_note;
    EXPECT_NEAR(result.totals.creepage_x, exact.shift, 0.002 * exact.shift);
    const double peak = cattaneo_friction * 1.5 * problem.force / std::numbers::pi;
    double square = 0, norm = 0;
    for (int i = 0; i < problem.grid.size(); ++i) {
      const double x = problem.grid.x(i % problem.grid.mx), s = problem.rows[i / problem.grid.mx].s;
      const double r2 = x * x + s * s, theta2 = exact.stick_ratio * exact.stick_ratio;
      const double p = peak * (std::sqrt(std::max(0.0, 1 - r2)) - std::sqrt(std::max(0.0, theta2 - r2)));
      square += (result.px[i] - p) * (result.px[i] - p);
      norm += p * p;
    }
    const double error = std::sqrt(square / norm);
    if (previous > 0) {
      EXPECT_LT(error, 0.62 * previous) << across;
    }
    previous = error;
  }
  EXPECT_LT(previous, 0.02);
}

/// The shift prescribed gives the force that asks for that shift.
TEST(Loads, ShiftAndForceAreTheSameProblem) {
  ContactProblem problem = cattaneo_problem(20);
  problem.force_x = 0.6 * cattaneo_friction * cattaneo_force;
  problem.force_s = 0.3 * cattaneo_friction * cattaneo_force;
  const ContactResult by_force = solve(problem);
  ASSERT_TRUE(by_force.certified()) << by_force.trust.solver_note;
  problem.force_x = problem.force_s = std::nullopt;
  scenes::set_creepage(problem, cattaneo_friction, by_force.totals.creepage_x, by_force.totals.creepage_s, 0);
  const ContactResult by_shift = solve(problem);
  ASSERT_TRUE(by_shift.certified());
  EXPECT_NEAR(by_shift.totals.Fx, by_force.totals.Fx, 1e-6 * by_force.totals.Fx);
  EXPECT_NEAR(by_shift.totals.Fs, by_force.totals.Fs, 1e-6 * by_force.totals.Fs);
}

ContactProblem rolling(const Material& lower, const Material& upper, int n) {
  ContactProblem problem = scenes::flat(lower, upper, n, n, 12.0 / n, 12.0 / n, 1e-3, 1.4e-3);
  problem.force = 15000;
  return problem;
}

/// One or two forces, with spin beside them; up to a thousandth below full slip.
TEST(Loads, CreepagesOfSteadyRolling) {
  ContactProblem problem = rolling(scenes::steel, scenes::steel, 24);
  const double carried = 0.3 * problem.force;
  struct Case {
    std::optional<double> fx, fs;
    double eta, phi;
  };
  for (const Case& c : {Case{0.5, {}, 0, 0}, Case{0.99, {}, 0, 0}, Case{0.999, {}, 0, 0},
                        Case{-0.7, {}, 3e-4, 2e-4}, Case{{}, 0.4, 0, 5e-4}, Case{0.3, -0.5, 0, 2e-4},
                        Case{0.0, 0.0, 0, 4e-4}, Case{0.69, 0.69, 0, 1e-4}, Case{0.0, 0.98, 0, 3e-3}}) {
    scenes::set_creepage(problem, 0.3, 0, c.eta, c.phi);
    problem.force_x = c.fx ? std::optional(*c.fx * carried) : std::nullopt;
    problem.force_s = c.fs ? std::optional(*c.fs * carried) : std::nullopt;
    const ContactResult result = solve(problem, {.estimate_discretisation = false});
    EXPECT_TRUE(result.certified()) << result.trust.solver_note << result.trust.certificate.worst();
    EXPECT_NEAR(result.totals.Fx, c.fx.value_or(result.totals.Fx / carried) * carried, 1e-6 * carried);
    EXPECT_NEAR(result.totals.Fy, c.fs.value_or(result.totals.Fy / carried) * carried, 1e-6 * carried);
    EXPECT_LT(result.effort.creepage_iterations, 60);
  }
}

/// A rigid slip that is far off (the rolling radius is) moves the creepages found, and takes no more work.
TEST(Loads, ARigidSlipFarOffIsFoundAsSoon) {
  ContactProblem problem = rolling(scenes::steel, scenes::steel, 24);
  const auto pulled = [&](double xi, double eta) {
    scenes::set_creepage(problem, 0.3, xi, eta, 2e-4);
    problem.force_x = 0.1 * problem.force;
    problem.force_s = -0.05 * problem.force;
    return solve(problem, {.estimate_discretisation = false});
  };
  const ContactResult near = pulled(0, 0), far = pulled(0.05, -0.03);
  ASSERT_TRUE(near.certified() && far.certified());
  EXPECT_NEAR(near.totals.creepage_x, far.totals.creepage_x + 0.05, 1e-8);
  EXPECT_NEAR(near.totals.creepage_s, far.totals.creepage_s - 0.03, 1e-8);
  EXPECT_LE(far.effort.tangential_iterations, near.effort.tangential_iterations + 1);
}

/// Against the difference of two solutions; where both forces are prescribed, the other one is held. A force
/// that is not prescribed has none.
TEST(Loads, ComplianceIsTheChangeOfACreepageWithItsForce) {
  ContactProblem problem = rolling(scenes::steel, scenes::steel, 24);
  const double carried = 0.3 * problem.force;
  scenes::set_creepage(problem, 0.3, 0, 0, 3e-4);
  const auto at = [&](std::optional<double> fx, std::optional<double> fs) {
    problem.force_x = fx ? std::optional(*fx * carried) : std::nullopt;
    problem.force_s = fs ? std::optional(*fs * carried) : std::nullopt;
    return solve(problem, {.estimate_discretisation = false});
  };
  constexpr double step = 2e-3;
  for (const double share : {0.0, 0.5, 0.9}) {
    const ContactResult x = at(share, {}), s = at({}, share), both = at(share, 0.3);
    const auto slope = [&](double less, double more) { return (more - less) / (2 * step * carried); };
    const double along_x =
        slope(at(share - step, {}).totals.creepage_x, at(share + step, {}).totals.creepage_x);
    const double along_s =
        slope(at({}, share - step).totals.creepage_s, at({}, share + step).totals.creepage_s);
    const double beside =
        slope(at(share - step, 0.3).totals.creepage_x, at(share + step, 0.3).totals.creepage_x);
    EXPECT_NEAR(x.totals.compliance_x, along_x, 0.1 * std::abs(along_x)) << share;
    EXPECT_NEAR(s.totals.compliance_s, along_s, 0.1 * std::abs(along_s)) << share;
    EXPECT_NEAR(both.totals.compliance_x, beside, 0.1 * std::abs(beside)) << share;
    EXPECT_TRUE(std::isnan(x.totals.compliance_s) && std::isnan(s.totals.compliance_x)) << share;
  }
  const double eta = 0.05; // all slip along s: Fx is mu N xi / eta
  scenes::set_creepage(problem, 0.3, 0, eta, 0);
  EXPECT_NEAR(at(0, {}).totals.compliance_x, eta / carried, 0.02 * eta / carried);
}

TEST(Loads, ForcesThatFrictionCannotCarryAreRefused) {
  for (const double share : {1.0, 1.5, 1e6}) {
    ContactProblem problem = rolling(scenes::steel, scenes::steel, 12);
    scenes::set_creepage(problem, 0.3, 0, 0, 0);
    problem.force_x = 0.6 * share * 0.3 * problem.force;
    problem.force_s = -0.8 * share * 0.3 * problem.force;
    try {
      solve(problem);
      FAIL() << "accepted";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("The shear force prescribed cannot be carried"));
      EXPECT_THAT(error.what(), testing::HasSubstr("sum mu p_n dS = 4500 N"));
    }
  }
}

/// Full slip carries 0.7 of what adhesion can: more than that is found only where enough sticks.
TEST(Loads, ForcesThatSlipDoesNotCarryAreFoundOrRefused) {
  ContactProblem problem = rolling({23000, 0.31}, scenes::steel, 16);
  problem.kinetic = 0.7;
  scenes::set_creepage(problem, 0.3, 0, 0, 0);
  const double carried = 0.3 * problem.force;
  problem.force_s = 0.65 * carried;
  const ContactResult result = solve(problem, {.estimate_discretisation = false});
  EXPECT_TRUE(result.certified()) << result.trust.solver_note;
  EXPECT_NEAR(result.totals.Fs, 0.65 * carried, 1e-6 * carried);
  problem.force_s = 0.95 * carried;
  try {
    solve(problem);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("The shear force prescribed was not reached"));
    EXPECT_THAT(error.what(), testing::HasSubstr("full slip carries 3150 N"));
  }
}

/// Bentall and Johnson 1967: unlike rollers that roll freely creep. One row, so long that it is plane (what
/// is missing of a plane goes with one over its length: 0.1 % at 400 mm, 1.5 % at 20).
ContactProblem unlike_rollers(double friction, int across) {
  const Material lower{23000, 0.31}, upper{82000, 0.28};
  const auto both = reference::combined(lower, upper);
  const double a = 0.1, radius = 25, length = 8000;
  ContactProblem problem =
      scenes::flat(lower, upper, across * 6 / 5, 1, 2 * a / across, length, 0.5 / radius, 0);
  problem.force = std::numbers::pi * a * a * both.shear_modulus / (4 * radius * (1 - both.poisson)) * length;
  scenes::set_creepage(problem, friction, 0, 0, 0);
  problem.force_x = 0.0;
  return problem;
}
const double bentall_johnson = reference::bentall_johnson_creepage({23000, 0.31}, {82000, 0.28}, 25, 0.1);

TEST(Loads, BentallJohnson) {
  const double mu = 1e-4; // the limit mu -> 0: at 1e-2 the creepage is 4 % less
  double previous = 0;
  for (const int across : {20, 40, 80}) {
    const ContactResult result = solve(unlike_rollers(mu, across), {.estimate_discretisation = false});
    ASSERT_TRUE(result.certified()) << result.trust.solver_note;
    const double error = std::abs(result.totals.creepage_x / bentall_johnson - 1);
    if (previous > 0) {
      EXPECT_LT(error, 0.6 * previous) << across;
    }
    previous = error;
  }
  EXPECT_LT(previous, 0.003);
}

/// Where friction vanishes everything slips, one way or the other, at nearly every creepage, and the forces
/// hardly depend on it: searches that start at creepage zero have to get away from there. In the end the
/// force leaps as one element changes sides, and tractions between the two are the solution.
TEST(Loads, CreepagesOfVanishingFriction) {
  for (const double mu : {1e-3, 1e-4, 1e-5, 1e-6, 1e-8, 1e-10, 1e-13})
    for (const bool lateral : {false, true}) {
      ContactProblem problem = unlike_rollers(mu, 40);
      if (lateral)
        problem.force_s = 0.0;
      const ContactResult result = solve(problem, {.estimate_discretisation = false});
      EXPECT_TRUE(result.certified()) << mu << ' ' << lateral << ' ' << result.trust.solver_note;
      EXPECT_NEAR(result.totals.creepage_x, bentall_johnson, 0.01 * bentall_johnson) << mu;
      EXPECT_NEAR(result.totals.creepage_s, 0, 1e-6 * bentall_johnson) << mu;
    }
}

} // namespace
} // namespace bem_contact
