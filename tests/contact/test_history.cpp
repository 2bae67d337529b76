#include "bem_contact/contact/history.hpp"

#include "bem_contact/base/error.hpp"
#include "tests/contact/scenes.hpp"
#include "tests/sanitized.hpp"

#include <gmock/gmock.h>

namespace bem_contact {
namespace {

/// Carter's cylinders (bem_contact/theory/estimates_and_heat.md 4): contact from -1 to 1 mm, one row so long
/// that it is a plane problem.
constexpr double length = 4000, friction = 0.3, radius = 500, carter_creepage = 2.4e-4;
const double normal_force = std::numbers::pi * 82000 / (4 * radius * (1 - 0.28)) * length;

ContactProblem cylinders(int across) {
  ContactProblem problem =
      scenes::flat(scenes::steel, scenes::steel, across * 6 / 5, 1, 2.0 / across, length, 0.5 / radius, 0);
  problem.force = normal_force;
  scenes::set_creepage(problem, friction, 0, 0, 0);
  return problem;
}

/// Shifted by Carter's force, then rolling with it: the creepage tends to Carter's, the better the smaller
/// the elements.
TEST(History, FromCattaneoToCarterByForce) {
  double previous = 0;
  for (const int across : {10, 20, 40}) {
    ContactProblem problem = cylinders(across);
    problem.motion = MotionKind::shift;
    problem.force_x = 0.64 * friction * normal_force;
    const ContactResult shifted = solve(problem, scenes::without_estimate);
    ASSERT_TRUE(shifted.certified());
    problem.motion = MotionKind::transient;
    problem.previous = {tractions_of(shifted)};
    const auto steps = solve_history(
        problem, 3 * across, [](int, ContactProblem&) {}, scenes::without_estimate);
    for (const ContactResult& step : steps) {
      ASSERT_TRUE(step.certified()) << step.trust.solver_note;
      EXPECT_NEAR(step.totals.Fx, *problem.force_x, 1e-6 * *problem.force_x);
    }
    EXPECT_LT(steps.front().totals.creepage_x, 0.6 * carter_creepage) << "a transient it is";
    const double error = std::abs(steps.back().totals.creepage_x / carter_creepage - 1);
    if (previous > 0) {
      EXPECT_LT(error, 0.65 * previous) << across;
    }
    previous = error;
  }
  EXPECT_LT(previous, 0.005);
}

/// In three dimensions, coupled through unlike materials: transient rolling ends in the steady state.
TEST(History, EndsInTheSteadyState) {
  ContactProblem problem = scenes::flat({23000, 0.31}, scenes::steel, 16, 16, 0.7, 0.7, 1e-3, 1.4e-3);
  problem.force = 15000;
  scenes::set_creepage(problem, 0.3, 4e-4, 2e-4, 2e-4);
  const ContactResult steady = solve(problem, scenes::without_estimate);
  problem.motion = MotionKind::transient;
  const auto steps = solve_history(
      problem, 45, [](int, ContactProblem&) {}, scenes::without_estimate);
  for (const ContactResult& step : steps)
    ASSERT_TRUE(step.certified()) << step.trust.solver_note;
  EXPECT_LT(steps.front().totals.Fy, 0.3 * steady.totals.Fy);
  EXPECT_NEAR(steps.back().totals.Fx, steady.totals.Fx, 0.005 * steady.totals.Fy);
  EXPECT_NEAR(steps.back().totals.Fy, steady.totals.Fy, 0.005 * steady.totals.Fy);
  EXPECT_NEAR(steps.back().totals.Mz, steady.totals.Mz, 0.005 * steady.totals.Mz);
}

/// One step by dx: on a grid that moves, and on one that lies still while the contact moves over it.
TEST(History, MovingAndFixedGridAreTheSameStep) {
  ContactProblem problem = cylinders(20);
  const int mx = problem.grid.mx;
  scenes::set_creepage(problem, friction, carter_creepage, 0, 0);
  problem.motion = MotionKind::transient;
  const ContactResult before = solve(problem, scenes::without_estimate);
  problem.previous = {tractions_of(before)};
  const ContactResult moving = solve(problem, scenes::without_estimate);
  // On the material's grid the contact now lies one column further on.
  ContactProblem fixed = problem;
  fixed.motion = MotionKind::shift;
  for (int ix = 0; ix < mx; ++ix) {
    const double x = problem.grid.x(ix) - problem.grid.dx;
    fixed.gap[ix] = 0.5 / radius * x * x;
  }
  scenes::set_creepage(fixed, friction, carter_creepage * problem.grid.dx, 0, 0);
  const ContactResult still = solve(fixed, scenes::without_estimate);
  ASSERT_TRUE(moving.certified() && still.certified());
  EXPECT_NEAR(still.totals.Fx, moving.totals.Fx, 1e-6 * moving.totals.Fx);
  for (int ix = 0; ix + 1 < mx; ++ix)
    EXPECT_NEAR(still.px[ix + 1], moving.px[ix], 1e-5 * friction * moving.patches[0].pmax);
}

/// A shift taken back leaves tractions, but no force that acts alone: to zero force it needs a shift back.
TEST(History, ShiftThereAndBack) {
  ContactProblem problem = scenes::flat({200, 0.42}, {200, 0.42}, 22, 22, 0.1, 0.1, 0.01, 0.01);
  problem.force = 9.1954;
  problem.motion = MotionKind::shift;
  scenes::set_creepage(problem, 0.4, 0, 0, 0);
  const double there = 0.7 * 0.4 * problem.force;
  const auto steps = solve_history(
      problem, 2, [&](int k, ContactProblem& p) { p.force_x = k == 0 ? there : 0.0; },
      scenes::without_estimate);
  ASSERT_TRUE(steps[0].certified() && steps[1].certified()) << steps[1].trust.solver_note;
  // Mindlin and Deresiewicz 1953: unloading slips in from the edge by half of the force's change
  const auto shift = [&](double force) { return 1 - std::pow(1 - force / (0.4 * problem.force), 2.0 / 3); };
  EXPECT_NEAR(steps[1].totals.creepage_x / steps[0].totals.creepage_x, -2 * shift(there / 2) / shift(there),
              0.01);
  EXPECT_GT(steps[1].patches[0].slip, 0);
}

/// Spence 1975: a sphere pressed on a rigid plane in steps, nu = 0: normal and tangential act on each other.
/// Half of the contact's radius sticks at mu = 0.2986, and the pressure in the middle is 1.31 of Hertz's. It
/// has a sharp top there, and its error is of first order; the border of what sticks is that of elements.
TEST(History, Spence) {
  NEEDS_NO_SANITIZER();
  const Material material{1000, 0};
  const double a = 1, gap = 0.01, modulus = 2 * material.shear_modulus; // E* of one body, nu = 0
  const double force = 4.0 / 3 * modulus * 2 * gap * a * a * a;
  double previous = 0;
  for (const int across : {10, 20, 40}) {
    const int n = across * 6 / 5, steps = std::min(across, 20);
    ContactProblem problem = scenes::flat(material, material, n, n, 2 * a / across, 2 * a / across, gap, gap);
    problem.numbers =
        halfspace::influence_numbers(material, problem.grid.dx, problem.grid.ds, problem.grid.mx + 2,
                                     problem.grid.ms); // the upper body is rigid
    problem.motion = MotionKind::shift;
    scenes::set_creepage(problem, 0.2986, 0, 0, 0);
    const auto results = solve_history(
        problem, steps, [&](int k, ContactProblem& p) { p.force = force * std::pow((k + 1.0) / steps, 3); },
        scenes::without_estimate);
    for (const ContactResult& step : results)
      ASSERT_TRUE(step.certified()) << step.trust.solver_note << step.trust.certificate.worst();
    const ContactResult& last = results.back();
    double stick = 0;
    for (const ElementState state : last.state)
      stick += state == ElementState::adhesion ? 1 : 0;
    EXPECT_NEAR(std::sqrt(stick / last.patches[0].contact), 0.5, 0.5 / across) << across;
    const double hertz = 1.5 * force / (std::numbers::pi * a * a);
    const double error = std::abs(last.patches[0].pmax / hertz / 1.31 - 1);
    if (previous > 0) {
      EXPECT_LT(error, 0.6 * previous) << across;
    }
    previous = error;
  }
  EXPECT_LT(previous, 0.01);
}

TEST(History, OfSteadyRollingIsRefused) {
  EXPECT_THROW(solve_history(
                   cylinders(10), 3, [](int, ContactProblem&) {}, scenes::without_estimate),
               InputError);
}

} // namespace
} // namespace bem_contact
