#include "bem_contact/base/error.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "bem_contact/uses/wear/rates.hpp"
#include "bem_contact/uses/wear/wear_of_result.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <string>

namespace {

using namespace bem_contact;
using namespace bem_contact::wear;
using ::testing::HasSubstr;

/// A steady rolling contact on `n` x `n` elements over 16 x 14 mm.
SceneResult rolling(const std::string& motion, int n = 32) {
  return Sequence().solve(parse_scene_file(
      "kind = \"patch\"\nload.force = 8e4\nsolver.model = \"halfspace\"\n[motion]\nfriction = 0.3\n" +
      motion + "[grid]\ndx = " + std::to_string(16.0 / n) + "\nds = " + std::to_string(14.0 / n) +
      "\nmx = " + std::to_string(n) + "\nms = " + std::to_string(n) + "\n[gap]\na = 1.1e-3\nb = 1.7e-3\n"));
}

const std::string mixed = "xi = 6e-4\neta = 4e-4\nphi = 1e-4\n";

/// A result of one row of `columns` elements of 1 mm x 0.5 mm with I = p_x s_x, made by hand.
SceneResult made_by_hand(int columns, double px, double slip) {
  SceneResult r;
  r.problem.grid = {columns, 1, 1.0, 0.5, 0};
  r.problem.rows = {{7.0, {7.0, 0.0}, 0.0}};
  r.problem.numbers.dx = 1;
  const auto all = static_cast<std::size_t>(columns);
  r.result.px.assign(all, px);
  r.result.ps.assign(all, 0);
  r.result.pn.assign(all, 800);
  r.result.slip_x.assign(all, slip);
  r.result.slip_s.assign(all, 0);
  r.result.totals.T_gamma = {px * slip * columns * 1.0 * 0.5}; // all elements, 1 mm by 0.5 mm
  r.result.trust.certificate = Certificate::without_violation();
  r.bodies.wheel_s = {-7.5};
  return r;
}

/// I = 5 N/mm^2 over 10 mm: 3.40e-5 mm in a passage, and the same on the wheel in a revolution.
TEST(WearOfResult, ClosedVectorOfTheEnergyLaw) {
  const Wear w = wear_of(made_by_hand(10, 200, 0.025), EnergyLaw{});
  ASSERT_EQ(w.rail.depth.size(), 1U);
  EXPECT_NEAR(w.rail.depth[0], 3.397e-5, 1e-8);
  EXPECT_EQ(w.rail.s[0], 7.0);
  EXPECT_EQ(w.wheel.s[0], -7.5);
  EXPECT_EQ(w.wheel.depth, w.rail.depth);
  EXPECT_NEAR(w.sliding_over_s[0], 10 * 0.025, 1e-12); // mm in one passage
  EXPECT_NEAR(w.volume_per_distance, 0.5 * 3.397e-5, 1e-8);
}

/// Archard by hand: k p d / H with d = 0.25 mm in the passage.
TEST(WearOfResult, ClosedVectorOfArchard) {
  const Wear w = wear_of(made_by_hand(10, 200, 0.025),
                         ArchardLaw{.hardness = 2000, .rolling_speed = 1e4, .map = {{}, {}, {4e-4}}});
  EXPECT_NEAR(w.rail.depth[0], 4e-4 * 800 * 0.25 / 2000, 1e-15);
}

/// The area under the depth over s is the volume per distance, and this is the sum over the elements.
TEST(WearOfResult, VolumeIsTheSumOverTheElements) {
  const SceneResult r = rolling(mixed);
  for (const Law& law : {Law(EnergyLaw{}), Law(ArchardLaw{.map = kth_map(3000)})}) {
    const Wear w = wear_of(r, law);
    double sum = 0;
    for (const double rate : w.rate)
      sum += rate * r.problem.grid.dx * r.problem.grid.ds;
    EXPECT_GT(sum, 0);
    EXPECT_NEAR(w.volume_per_distance, sum, 1e-9 * sum);
    EXPECT_NEAR(w.rail.area(), sum, 1e-9 * sum);
  }
}

/// In mild wear the law is linear: the volume is T-gamma times its coefficient over the density.
TEST(WearOfResult, MildWearIsTGamma) {
  const EnergyLaw mild{.mild = 5.3, .mild_until = 1e9, .severe_until = 1e9};
  const SceneResult r = rolling(mixed);
  const double t_gamma = r.result.totals.T_gamma;
  EXPECT_NEAR(wear_of(r, mild).volume_per_distance, 5.3e-12 / 7.8e-6 * t_gamma,
              1e-9 * 5.3e-12 / 7.8e-6 * t_gamma);
}

/// Only what slips wears.
TEST(WearOfResult, AdhesionDoesNotWear) {
  const SceneResult r = rolling(mixed);
  const Wear w = wear_of(r, EnergyLaw{});
  double adhering = 0, slipping = 0;
  for (std::size_t i = 0; i < w.rate.size(); ++i)
    (r.result.state[i] == ElementState::slip ? slipping : adhering) += w.rate[i];
  EXPECT_GT(slipping, 0);
  EXPECT_LT(adhering, 1e-5 * slipping);
}

/// A contact that is mirrored in s wears mirrored.
TEST(WearOfResult, MirrorsWithTheContact) {
  const Wear w = wear_of(rolling("xi = 6e-4\neta = 4e-4\nphi = 1e-4\n"), EnergyLaw{}),
             m = wear_of(rolling("xi = 6e-4\neta = -4e-4\nphi = -1e-4\n"), EnergyLaw{});
  for (std::size_t i = 0; i < w.rail.depth.size(); ++i)
    EXPECT_NEAR(w.rail.depth[i], m.rail.depth[w.rail.depth.size() - 1 - i], 1e-6 * w.rail.area());
}

/// The two sides of the balance of energy in steady rolling, by rolled distance, N. If both bodies have the
/// same elasticity on a plane they are equal: what friction dissipates is what the rigid motion puts in,
///     integral p_t . s dA = Fx xi + Fy eta + Mz phi        (with the signs of base/conventions.hpp).
/// Their difference is then an estimate of the error of discretisation.
struct EnergyBalance {
  double dissipated = 0; ///< sum p_t . s dA
  double supplied = 0;   ///< sum p_t . w dA, w the rigid slip with the creepages that were found
};
EnergyBalance energy_balance(const SceneResult& r) {
  const ContactProblem& p = r.problem;
  EnergyBalance out{.dissipated = r.result.totals.T_gamma};
  for (int i = 0; i < p.grid.size(); ++i) {
    const double wx = p.slip_x[i] + r.result.totals.creepage_x,
                 ws = p.slip_s[i] + r.result.totals.creepage_s * p.lateral_share(i / p.grid.mx);
    out.supplied += p.element_area() * (r.result.px[i] * wx + r.result.ps[i] * ws);
  }
  return out;
}

/// What the rigid motion puts in is Fx xi + Fy eta + Mz phi.
TEST(EnergyBalance, SuppliesForceTimesCreepage) {
  const SceneResult r = rolling(mixed);
  const EnergyBalance e = energy_balance(r);
  EXPECT_NEAR(e.supplied, r.result.totals.Fx * 6e-4 + r.result.totals.Fy * 4e-4 + r.result.totals.Mz * 1e-4,
              1e-9 * e.supplied);
}

/// Both sides are equal on elements of any size: T-gamma is what drives the bodies.
TEST(EnergyBalance, ClosesOnElementsOfAnySize) {
  const auto defect = [](int n) {
    const EnergyBalance e = energy_balance(rolling(mixed, n));
    return std::abs(e.dissipated - e.supplied) / e.supplied;
  };
  EXPECT_LT(defect(16), 1e-9);
  EXPECT_LT(defect(64), 1e-9);
}

std::string message_of(const SceneResult& r, const Law& law = EnergyLaw{}) {
  try {
    wear_of(r, law);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(WearOfResult, RefusesWhatDoesNotRoll) {
  SceneResult r = made_by_hand(4, 200, 0.025);
  r.result.trust.certificate.penetration = 1;
  EXPECT_THAT(message_of(r), HasSubstr("is not a solution"));
  r = made_by_hand(4, 200, 0.025);
  r.problem.motion = MotionKind::shift;
  EXPECT_THAT(message_of(r), HasSubstr("wear is taken from steady rolling"));
  r = made_by_hand(4, 200, 0.025);
  r.problem.tangential = false;
  EXPECT_THAT(message_of(r), HasSubstr("no wear without friction"));
  EXPECT_THAT(message_of(made_by_hand(4, 200, 0.025), EnergyLaw{.density = -1}), HasSubstr("density"));
}

/// I = 5 N/mm^2 over 10 mm takes 1 mm off a wheel of 460 mm in 85 km. On the rail it is 34 mm by a million
/// axles, and axles of 20 t are 50000 by a million tonnes.
TEST(WearOfResult, RatesByKilometreAxlesAndTonnes) {
  SceneResult r = made_by_hand(10, 200, 0.025);
  r.motion.rolling.radius = 460;
  const WearRates w = rates_of(r, wear_of(r, EnergyLaw{}), 20e3 * 9.80665);
  EXPECT_NEAR(1 / w.wheel_depth, 85, 0.2);
  EXPECT_NEAR(w.wheel_area, 0.5 * w.wheel_depth, 1e-12); // one row, 0.5 mm wide
  EXPECT_NEAR(w.rail_depth, 33.97, 0.01);
  EXPECT_NEAR(w.rail_area, 0.5 * w.rail_depth, 1e-9);
  EXPECT_NEAR(w.axle_load, 20, 1e-9);
  EXPECT_NEAR(w.mgt_rail_depth, w.rail_depth / 20, 1e-9);
  EXPECT_NEAR(w.mgt_rail_area, w.rail_area / 20, 1e-9);
  EXPECT_NEAR(w.t_gamma, 200 * 0.025 * 10 * 0.5, 1e-9);
  const record::Record said = record_of(w, wear_of(r, EnergyLaw{}));
  EXPECT_EQ(record::number_at(said, "rail_depth_per_mgt"), w.mgt_rail_depth);
  EXPECT_NEAR(record::number_at(said, "rows/0/wheel_depth_per_km").value(), w.wheel_depth, 1e-15);
  r.motion.rolling.radius = 0;
  EXPECT_THROW(rates_of(r, wear_of(r, EnergyLaw{}), 1e5), InputError) << "a patch has no wheel";
}

} // namespace
