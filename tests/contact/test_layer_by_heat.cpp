#include "bem_contact/contact/flash_temperature.hpp"
#include "bem_contact/contact/layer.hpp"
#include "tests/base/message.hpp"
#include "tests/contact/scenes.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

/// A layer whose yield limit falls with the temperature of the surfaces, which its own flow heats.
namespace bem_contact {
namespace {

using testing::HasSubstr;

const YieldLimit by_heat{200, 0, {20, 100, 300}, {200, 150, 40}};

ContactResult solved_warm(const ContactProblem& problem) {
  ContactResult result = solve(problem, scenes::without_estimate);
  EXPECT_TRUE(result.certified()) << result.trust.solver_note << ' ' << result.trust.certificate.worst();
  return result;
}

ContactProblem warm_contact(double xi, const Material& upper = scenes::steel) {
  ContactProblem problem = scenes::flat(scenes::steel, upper, 28, 22, 0.5, 0.5, 8e-4, 1.2e-3);
  problem.force = 5e4;
  scenes::set_creepage(problem, 0.5, xi, 0.3 * xi, 8e-5);
  add_layer({{1e-4}, 0}, problem.numbers);
  problem.speed = 2e4;
  problem.heating.emplace().wheel.temperature = 40;
  return problem;
}

TEST(LayerByHeat, LimitsAreLinearBetweenTemperatures) {
  for (const auto& [temperature, limit] :
       {std::pair{-30.0, 200.0}, {20.0, 200.0}, {60.0, 175.0}, {100.0, 150.0}, {250.0, 67.5}, {900.0, 40.0}})
    EXPECT_NEAR(by_heat.at(temperature), limit, 1e-12);
  EXPECT_EQ((YieldLimit{70, 0}.at(500)), 70);
  EXPECT_EQ(yield_text(by_heat), "yields at 200 MPa (20 degrees C) to 40 MPa (300)");
}

/// One element in full slip: its traction is what the layer bears at the temperature that this traction
/// makes, tau = tau_0(T(tau)) + k w(tau).
TEST(LayerByHeat, OneElementInFullSlipIsTheClosedForm) {
  for (const double hardening : {0.0, 300.0, -200.0})
    for (const double xi : {2e-3, 1e-2, 8e-2}) {
      SCOPED_TRACE(testing::Message() << hardening << ' ' << xi);
      ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, 1, 1, 2, 2, 0, 0);
      problem.force = 900 * 4.0;
      scenes::set_creepage(problem, 0.6, xi, 0, 0);
      problem.speed = 2e4;
      problem.heating.emplace();
      problem.yield = YieldLimit{200, hardening, {20, 100, 300}, {200, 150, 40}};
      const auto a = [&](int m) { return problem.numbers.at(m, 0, component_x, 0, component_x); };
      const double self = 1.5 * a(0) - 2 * a(1) + 0.5 * a(2),
                   rise = 2 * std::sqrt(2.0 / (std::numbers::pi * problem.speed)) * std::sqrt(0.5) /
                          (2 * problem.heating->rail.effusivity()); // half of the heat flows into each body
      const auto slip = [&](double tau) { return xi * 2 - self * tau; };
      const auto temperature = [&](double tau) { return rise * tau * slip(tau) / 2 * problem.speed; };
      double low = 0, high = 250; // what it bears less tau falls
      for (int k = 0; k < 200; ++k) {
        const double tau = 0.5 * (low + high),
                     borne = problem.yield->at(temperature(tau)) + hardening * slip(tau) / 1.5;
        (borne > tau ? low : high) = tau;
      }
      const ContactResult r = solved_warm(problem);
      EXPECT_NEAR(r.px[0], low, 1e-6 * 200);
      EXPECT_NEAR(r.temperatures->mean(0), temperature(low), 1e-4);
      EXPECT_NEAR(r.plastic[0], slip(low) / 1.5, 1e-6 * xi);
    }
}

TEST(LayerByHeat, OneValueAtEveryTemperatureIsThatLimit) {
  for (const double hardening : {0.0, 2e3, -500.0}) {
    ContactProblem problem = warm_contact(5e-3);
    problem.yield = YieldLimit{100, hardening};
    const ContactResult plain = solved_warm(problem);
    for (const YieldLimit& table : {YieldLimit{100, hardening, {20, 300}, {100, 100}},
                                    {100, hardening, {20, 2000, 3000}, {100, 100, 10}}}) {
      problem.yield = table; // the second is flat as far as the contact gets hot
      const ContactResult r = solved_warm(problem);
      ASSERT_LT(std::ranges::max(r.temperatures->rail), 2000);
      for (std::size_t i = 0; i < r.px.size(); ++i)
        ASSERT_NEAR(std::hypot(r.px[i] - plain.px[i], r.ps[i] - plain.ps[i]), 0, 1e-9 * 100) << hardening;
    }
  }
}

/// Each element that flows bears what its own temperature says; hotter bodies bear less.
TEST(LayerByHeat, TheHotterTheSurfacesTheSmallerTheForce) {
  for (const Material& upper : {scenes::steel, Material{40000, 0.3}})
    for (const double hardening : {0.0, 2e3}) {
      double before = 1e9;
      for (const double rail : {-20.0, 60.0, 150.0, 280.0}) {
        SCOPED_TRACE(testing::Message() << upper.shear_modulus << ' ' << hardening << ' ' << rail);
        ContactProblem problem = warm_contact(1e-2, upper);
        problem.yield = by_heat;
        problem.yield->hardening = hardening;
        problem.heating->rail.temperature = rail;
        const ContactResult r = solved_warm(problem);
        EXPECT_LT(r.totals.Fx, 0.99 * before);
        before = r.totals.Fx;
        int flowing = 0;
        for (std::size_t i = 0; i < r.px.size(); ++i) {
          const double bound = by_heat.at(r.temperatures->mean(i)) + hardening * r.plastic[i];
          if (!(r.pn[i] > 0) || r.state[i] != ElementState::slip || bound > 0.99 * 0.5 * r.pn[i])
            continue;
          ++flowing;
          ASSERT_NEAR(std::hypot(r.px[i], r.ps[i]), bound, 1e-4 * bound);
        }
        EXPECT_GT(flowing, 50);
      }
    }
}

TEST(LayerByHeat, TheCertificateKnowsTheTemperature) {
  for (const double hardening : {0.0, 2e3}) {
    ContactProblem problem = warm_contact(1e-2);
    problem.yield = by_heat;
    problem.yield->hardening = hardening;
    const ContactResult r = solved_warm(problem);
    ContactProblem other = problem;
    other.heating->rail.temperature += 1;
    EXPECT_FALSE(certify(other, r).holds());
    other = problem;
    other.yield->shears[1] += 1;
    EXPECT_FALSE(certify(other, r).holds());
  }
}

TEST(LayerByHeat, ErrorsHoldOnSmallerElements) {
  ContactProblem problem = warm_contact(4e-3);
  problem.yield = by_heat;
  const ContactResult coarse = solve(problem);
  ContactProblem finer = scenes::flat(scenes::steel, scenes::steel, 84, 66, 0.5 / 3, 0.5 / 3, 8e-4, 1.2e-3);
  finer.force = problem.force;
  scenes::set_creepage(finer, 0.5, 4e-3, 1.2e-3, 8e-5);
  add_layer({{1e-4}, 0}, finer.numbers);
  finer.speed = problem.speed;
  finer.heating = problem.heating;
  finer.yield = problem.yield;
  const ContactResult fine = solved_warm(finer);
  for (const Measured ContactTotals::*number :
       {&ContactTotals::Fx, &ContactTotals::T_gamma, &ContactTotals::Tmax_rail})
    EXPECT_NEAR(coarse.totals.*number, fine.totals.*number, (coarse.totals.*number).error);
}

TEST(LayerByHeat, FallingFrictionAndForcesGoWithIt) {
  ContactProblem problem = warm_contact(1e-2);
  problem.yield = by_heat;
  const double alone = solved_warm(problem).totals.Fx;
  problem.heating->friction = HotFriction{0.4, 50, 300};
  EXPECT_LT(solved_warm(problem).totals.Fx, alone);
  problem.falling = {exponential_friction(0.2, 0.3, 1000)};
  EXPECT_LT(solved_warm(problem).totals.Fx, alone);
  problem.falling.clear();
  problem.heating->friction.reset();
  problem.force_x = 0.5 * alone;
  EXPECT_NEAR(solved_warm(problem).totals.Fx, 0.5 * alone, 1e-5 * alone);
  problem.force_x = 3 * alone;
  EXPECT_THAT(message_of([&] { solve(problem); }), HasSubstr("cannot be carried"));
}

TEST(LayerByHeat, WhatCannotBeUsedIsRefused) {
  const auto refusal = [](const YieldLimit& limit) {
    ContactProblem problem = warm_contact(1e-2);
    problem.yield = limit;
    return message_of([&] { solve(problem); });
  };
  EXPECT_THAT(refusal({100, 0, {20, 100}, {100, 120}}), HasSubstr("more than one solution"));
  EXPECT_THAT(refusal({100, 0, {100, 20}, {100, 80}}), HasSubstr("temperatures do not rise"));
  EXPECT_THAT(refusal({100, 0, {20, 100}, {100}}), HasSubstr("2 temperatures and 1 limits"));
  EXPECT_THAT(refusal({100, 0, {20, 100}, {100, 0}}), HasSubstr("above 0"));
  ContactProblem cold = warm_contact(1e-2);
  cold.yield = by_heat;
  cold.heating.reset();
  EXPECT_THAT(message_of([&] { solve(cold); }), HasSubstr("temperatures are not asked for"));
}

} // namespace
} // namespace bem_contact
