#include "bem_contact/base/error.hpp"
#include "bem_contact/contact/flash_temperature.hpp"
#include "tests/base/message.hpp"
#include "tests/contact/scenes.hpp"
#include "tests/sanitized.hpp"

#include <gmock/gmock.h>

#include <algorithm>

namespace bem_contact {
namespace {

using testing::HasSubstr;

/// Vollebregt's locomotive: 106.7 kN, a/b = 0.5, mu = 0.14 + 0.19 2^(-w / 1250 mm/s), 10 m/s.
ContactProblem locomotive(double xi, int mx = 40, int ms = 20) {
  ContactProblem problem =
      scenes::flat(scenes::steel, scenes::steel, mx, ms, 16.0 / mx, 32.0 / ms, 8e-4, 2.814e-4);
  problem.force = 106700;
  problem.speed = 10000;
  scenes::set_creepage(problem, 0.33, xi, 0, 0);
  return problem;
}
const FallingFriction falling = exponential_friction(0.14, 0.19, 1250);
ContactResult solved(const ContactProblem& problem, SolverOptions options = scenes::without_estimate) {
  ContactResult result = solve(problem, options);
  EXPECT_TRUE(result.certified()) << result.trust.solver_note << result.trust.certificate.worst();
  return result;
}

std::string refusal(const ContactProblem& problem) {
  return message_of([&] { solve(problem, scenes::without_estimate); });
}

TEST(FallingFriction, Laws) {
  EXPECT_DOUBLE_EQ(0.33 * falling.factor(0), 0.33);
  EXPECT_DOUBLE_EQ(0.33 * falling.factor(1250), 0.14 + 0.19 / 2);
  EXPECT_NEAR(falling.factor(500), 0.8606, 5e-5);
  EXPECT_NEAR(falling.factor(1000), 0.7549, 5e-5);
  EXPECT_NEAR(falling.factor(2500), 0.5682, 1e-4);
  const FallingFriction polach = polach_friction(0.4, 0.6);
  EXPECT_DOUBLE_EQ(polach.factor(0), 1);
  EXPECT_NEAR(polach.factor(2000), 0.6 * std::exp(-1.2) + 0.4, 1e-15) << "2 m/s";
  const HotFriction hot{0.5, 100, 300};
  EXPECT_EQ(hot.factor(20), 1);
  EXPECT_EQ(hot.factor(200), 0.75);
  EXPECT_EQ(hot.factor(500), 0.5);
}

/// |Fx| / (mu Fn) of Coulomb's law, from another program, 1 % too stiff at small xi.
TEST(FallingFriction, LocomotiveWithCoulomb) {
  const std::pair<double, double> known[] = {{4e-4, 0.2588}, {8e-4, 0.4742},   {1.2e-3, 0.6482},
                                             {2e-3, 0.8816}, {2.8e-3, 0.9832}, {3.2e-3, 0.9976}};
  for (const auto& [xi, ratio] : known) {
    const ContactResult r = solved(locomotive(xi));
    EXPECT_NEAR(r.totals.Fx / (0.33 * 106700), ratio, 0.012) << xi;
    EXPECT_NEAR(r.totals.pmax, 640.7, 5);
    EXPECT_NEAR(r.totals.approach, 0.07651, 2e-4);
  }
}

/// Far in full slip |Fx| / (mu Fn) is the law itself.
TEST(FallingFriction, FullSlipIsTheLaw) {
  for (const auto& [xi, ratio] : {std::pair{0.05, 0.8606}, std::pair{0.1, 0.7549}, std::pair{0.25, 0.5682}}) {
    ContactProblem problem = locomotive(xi);
    problem.falling = {falling};
    const ContactResult r = solved(problem);
    EXPECT_NEAR(r.totals.Fx / (0.33 * 106700), ratio, 1e-3) << xi;
    EXPECT_EQ(count_elements(r).adhesion, 0);
  }
}

/// Each element that slips carries mu(w) p_n with its own slip velocity, and the creep force has a maximum.
TEST(FallingFriction, EachElementHasItsOwnSlip) {
  ContactProblem problem = locomotive(2e-3);
  const ContactResult coulomb = solved(problem);
  problem.falling = {falling};
  const ContactResult r = solved(problem);
  EXPECT_LT(r.totals.Fx, coulomb.totals.Fx);
  EXPECT_GT(r.totals.Fx, 0.95 * coulomb.totals.Fx);
  double largest = 0, least = 1;
  for (int i = 0; i < problem.grid.size(); ++i)
    if (r.state[i] == ElementState::slip) {
      const double mu = 0.33 * falling.factor(problem.speed * std::hypot(r.slip_x[i], r.slip_s[i]));
      EXPECT_NEAR(std::hypot(r.px[i], r.ps[i]), mu * r.pn[i], 1e-6 * r.totals.pmax);
      largest = std::max(largest, mu), least = std::min(least, mu);
    }
  EXPECT_GT(largest - least, 1e-3) << "mu is not the same everywhere";
  ContactResult forged = r; // the certificate sees a law that is not obeyed
  problem.speed *= 1.1;
  EXPECT_FALSE(certify(problem, forged).holds());
}

TEST(FallingFriction, WithoutAFallItIsCoulombExactly) {
  ContactProblem problem = locomotive(1.2e-3, 32, 16);
  const ContactResult coulomb = solved(problem);
  problem.falling = {exponential_friction(0.33, 0, 1250)};
  problem.heating.emplace().friction = HotFriction{1, 0, 1};
  const ContactResult r = solved(problem);
  EXPECT_EQ(r.px, coulomb.px);
  EXPECT_EQ(r.totals.Fx, coulomb.totals.Fx);
}

TEST(FallingFriction, MirrorUnitsAndRows) {
  ContactProblem problem = locomotive(0, 32, 16);
  problem.falling = {falling};
  scenes::set_creepage(problem, 0.33, 3e-3, 1e-3, 1e-4);
  const ContactResult one = solved(problem);
  const double bound = 0.33 * problem.force;
  problem.speed *= 4; // only the ratio counts
  problem.falling = {{falling.ratio, 4 * falling.scale}};
  EXPECT_NEAR(solved(problem).totals.Fx, one.totals.Fx, 1e-7 * bound);
  problem.falling.assign(problem.grid.ms, problem.falling.front());
  EXPECT_NEAR(solved(problem).totals.Fx, one.totals.Fx, 1e-7 * bound);
  scenes::set_creepage(problem, 0.33, 3e-3, -1e-3, -1e-4);
  const ContactResult mirrored = solved(problem);
  EXPECT_NEAR(mirrored.totals.Fx, one.totals.Fx, 1e-6 * bound);
  EXPECT_NEAR(mirrored.totals.Fy, -one.totals.Fy, 1e-6 * bound);

  scenes::set_creepage(problem, 0.33, 0.1, 0, 0);
  problem.speed = 10000;
  for (int is = 0; is < problem.grid.ms; ++is)
    problem.falling[is] = is < problem.grid.ms / 2 ? falling : FallingFriction{1, 1};
  EXPECT_NEAR(solved(problem).totals.Fx, bound * (1 + 0.7549) / 2, 2e-3 * bound)
      << "half of the patch with each law";
}

/// A law that is nearly a jump has two solutions, both certified: fewer elements adhere on the branch that
/// comes from sliding.
TEST(FallingFriction, TwoSolutions) {
  ContactProblem problem = locomotive(8e-4);
  problem.falling = {exponential_friction(0.14, 0.19, 0.3)};
  const ContactResult adhering = solved(problem);
  const ContactResult sliding = solved(problem, {.from_sliding = true, .estimate_discretisation = false});
  EXPECT_GT(adhering.totals.Fx, sliding.totals.Fx + 0.005 * 0.33 * problem.force);
  EXPECT_GT(count_elements(adhering).adhesion, count_elements(sliding).adhesion + 10);
  problem.falling = {falling};
  EXPECT_NEAR(solved(problem).totals.Fx,
              solved(problem, {.from_sliding = true, .estimate_discretisation = false}).totals.Fx,
              1e-7 * problem.force)
      << "as measured it has one";
}

/// What does not settle says so, and is certified only if what still changes is below the certificate's
/// tolerance.
TEST(FallingFriction, WhatDoesNotSettleIsSaid) {
  NEEDS_NO_SANITIZER();
  int unsettled = 0, uncertified = 0;
  for (const double half : {3.0, 2.0, 1.5})
    for (const double xi : {8e-4, 1.6e-3}) {
      ContactProblem problem = locomotive(xi);
      problem.falling = {exponential_friction(0.14, 0.19, half)};
      const ContactResult r = solve(problem, scenes::without_estimate);
      const bool said = r.trust.solver_note.find("did not settle in 100 iterations") != std::string::npos;
      EXPECT_TRUE(r.certified() || said) << r.trust.solver_note;
      if (said) {
        const std::string still = "it still changes by ";
        const double change =
            std::stod(r.trust.solver_note.substr(r.trust.solver_note.find(still) + still.size()));
        EXPECT_EQ(r.certified(), change < r.trust.certificate.tolerance) << r.trust.solver_note;
      }
      unsettled += said;
      uncertified += !r.certified();
    }
  EXPECT_GT(unsettled, 0);
  EXPECT_GT(uncertified, 0);
}

/// mu falls with the temperature of the result's own heat, in adhesion too.
TEST(FallingFriction, WithTemperature) {
  ContactProblem problem = locomotive(0.05, 32, 16);
  problem.heating.emplace().friction = HotFriction{0.4, 20, 150};
  problem.heating->wheel.temperature = 60;
  for (const std::optional<double> share : {std::optional<double>(), std::optional(0.4)}) {
    problem.heating->rail_share = share;
    const ContactResult r = solved(problem);
    EXPECT_LT(r.totals.Fx, 0.9 * 0.33 * problem.force);
    for (int i = 0; i < problem.grid.size(); ++i) {
      if (r.pn[i] > 0) {
        EXPECT_NEAR(std::hypot(r.px[i], r.ps[i]),
                    0.33 * problem.heating->friction->factor(r.temperatures->mean(i)) * r.pn[i],
                    1e-6 * r.totals.pmax);
      }
    }
    ContactProblem hotter = problem;
    hotter.heating->rail.temperature += 30;
    EXPECT_FALSE(certify(hotter, r).holds());
  }
  problem.falling = {falling}; // both laws
  const ContactResult both = solved(problem);
  EXPECT_NEAR(std::hypot(both.px[264], both.ps[264]),
              0.33 * falling.factor(problem.speed * std::hypot(both.slip_x[264], both.slip_s[264])) *
                  problem.heating->friction->factor(both.temperatures->mean(264)) * both.pn[264],
              1e-6 * both.totals.pmax);
}

TEST(FallingFriction, WrongOnesAreRefused) {
  ContactProblem problem = locomotive(1e-3, 8, 8);
  problem.falling = {{1.5, 100}};
  EXPECT_THAT(refusal(problem), HasSubstr("Friction does not fall with the slip velocity"));
  problem.falling = {falling, falling};
  EXPECT_THAT(refusal(problem), HasSubstr("The laws of friction do not fit the grid"));
  problem.falling = {falling};
  problem.kinetic = 0.5;
  EXPECT_THAT(refusal(problem), HasSubstr("There are two laws of friction"));
  problem.kinetic = 1;
  problem.motion = MotionKind::shift;
  EXPECT_THAT(refusal(problem), HasSubstr("A shift has no slip velocity"));
  problem.motion = MotionKind::steady;
  problem.speed = 0;
  EXPECT_THAT(refusal(problem), HasSubstr("The rolling speed is missing"));
  problem.speed = 1e4;
  problem.heating.emplace().rail_share = 1.5;
  EXPECT_THAT(refusal(problem), HasSubstr("share of the heat is not between 0 and 1"));
  problem.heating.emplace().friction = HotFriction{0.5, 100, 50};
  EXPECT_THAT(refusal(problem), HasSubstr("Friction does not fall with temperature"));
  problem.heating.emplace().wheel.conductivity = 0;
  EXPECT_THAT(refusal(problem), HasSubstr("A body does not conduct heat"));
}

/// Larger elements have the same law.
TEST(FallingFriction, ErrorsAreEstimated) {
  ContactProblem problem = locomotive(2e-3);
  problem.falling = {falling};
  const ContactResult r = solve(problem);
  ASSERT_TRUE(r.trust.discretisation);
  EXPECT_LT(r.trust.discretisation->tangential, 0.02);
}

/// Under a prescribed force the creepage from adhesion is found; beyond the largest force there is none.
TEST(FallingFriction, PrescribedForces) {
  ContactProblem problem = locomotive(0);
  problem.falling = {falling};
  problem.force_x = 0.9 * 0.33 * problem.force;
  const ContactResult r = solved(problem);
  EXPECT_NEAR(r.totals.Fx, *problem.force_x, 1e-6 * r.totals.Fx);
  EXPECT_GT(r.totals.creepage_x, 0.0015);
  EXPECT_LT(r.totals.creepage_x, 0.004) << "sliding as a whole carries the same at .034";
  problem.force_x = 0.995 * 0.33 * problem.force;
  EXPECT_THAT(refusal(problem), HasSubstr("cannot be carried"));
  EXPECT_THAT(refusal(problem), HasSubstr("mu falls in sliding"));
}

/// Where all slides at one velocity, friction falls from mu(0) at the leading edge to mu(w) over a distance
/// of slip: mu(w) + (mu(0) - mu(w)) exp(-slip / distance).
TEST(FallingFriction, WithMemoryInFullSlipIsTheClosedForm) {
  const double xi = 0.25, distance = 0.3;
  ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, 44, 1, 0.4, 200, 8e-4, 0);
  problem.force = 106700;
  problem.speed = 10000;
  scenes::set_creepage(problem, 0.33, xi, 0, 0);
  problem.falling = {falling};
  problem.memory = FrictionMemory{distance, 1};
  const ContactResult r = solved(problem);
  ASSERT_EQ(count_elements(r).adhesion, 0);
  int last = problem.grid.mx - 1;
  while (!(r.pn[last] > 0))
    --last;
  const double law = falling.factor(xi * problem.speed);
  for (int i = 0; i <= last; ++i)
    if (r.pn[i] > 0) {
      const double slip = xi * (last + 0.5 - i) * problem.grid.dx;
      EXPECT_NEAR(r.px[i] / (0.33 * r.pn[i]), law + (1 - law) * std::exp(-slip / distance), 2e-3) << i;
    }
}

TEST(FallingFriction, WithoutDistanceMemoryIsNone) {
  ContactProblem problem = locomotive(0.02);
  problem.falling = {falling};
  const ContactResult at_once = solved(problem);
  double before = 1;
  for (const double distance : {1e-2, 1e-3, 1e-5}) {
    problem.memory = FrictionMemory{distance, 1};
    const double more = solved(problem).totals.Fx / at_once.totals.Fx - 1;
    EXPECT_GT(more, -1e-7) << distance;
    EXPECT_LT(more, before) << distance;
    before = more;
  }
  EXPECT_LT(before, 1e-4);
}

/// Steep laws that do not settle without it: with memory over some elements' slip there is one solution.
TEST(FallingFriction, WithMemorySteepLawsSettle) {
  NEEDS_NO_SANITIZER();
  int without = 0, with = 0;
  for (const double half : {3.0, 2.0, 1.5})
    for (const double xi : {8e-4, 1.6e-3}) {
      ContactProblem problem = locomotive(xi);
      problem.falling = {exponential_friction(0.14, 0.19, half)};
      without += solve(problem, scenes::without_estimate).certified();
      problem.memory = FrictionMemory{0.003, 1};
      with += solve(problem, scenes::without_estimate).certified();
    }
  EXPECT_EQ(with, 6);
  EXPECT_LT(without, 6);
}

TEST(FallingFriction, MemoryNeedsAFall) {
  ContactProblem problem = locomotive(0.02);
  problem.memory = FrictionMemory{0.01, 1};
  EXPECT_THAT(refusal(problem), HasSubstr("nothing to remember"));
  problem.falling = {falling};
  problem.memory->distance = 0;
  EXPECT_THAT(refusal(problem), HasSubstr("memory of friction"));
}

} // namespace
} // namespace bem_contact
