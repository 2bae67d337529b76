#include "bem_contact/sequence/sequence.hpp"

#include "bem_contact/halfspace/combine.hpp"
#include "bem_contact/halfspace/resample.hpp"
#include "bem_contact/sequence/numbers/add_wheel.hpp"
#include "bem_contact/sequence/numbers/pair_numbers.hpp"
#include "bem_contact/sequence/numbers/sequence_files.hpp"
#include "bem_contact/sequence/plan/contact_case.hpp"
#include "tests/base/message.hpp"
#include "tests/sanitized.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace bem_contact;
using ::testing::HasSubstr;

SceneFile rolling(const std::string& more) {
  return parse_scene_file(
      "rail.profile = \"60E1\"\nwheel.profile = \"S1002\"\nposition.lateral = 6.6\n"
      "load.force = 1e5\nsolver.model = \"halfspace\"\n" +
      std::string(more.find("grid.") == std::string::npos ? "grid.dx = 1.0\ngrid.ds = 0.6\n" : "") + more);
}

TEST(FreeRolling, IsTheCreepageOfNoLongitudinalForce) {
  const SceneResult asked = Sequence().solve(rolling(""));
  const SceneResult prescribed = Sequence().solve(rolling("load.force_x = 0\n"));
  ASSERT_TRUE(asked.motion.free_rolling && prescribed.motion.free_rolling);
  EXPECT_NEAR(prescribed.result.totals.Fx, 0, 0.1);
  EXPECT_NEAR(asked.motion.free_rolling->xi, prescribed.motion.xi, 1e-8);
  EXPECT_NEAR(prescribed.motion.free_rolling->xi, prescribed.motion.xi, 0.0);
  // The error is that of a creepage found for a force.
  EXPECT_NEAR(asked.motion.free_rolling->xi.error, prescribed.result.totals.creepage_x.error,
              1e-3 * asked.motion.free_rolling->xi.error);
  const FreeRolling finer =
      *Sequence().solve(rolling("load.force_x = 0\ngrid.dx = 0.25\ngrid.ds = 0.15\n")).motion.free_rolling;
  EXPECT_NEAR(asked.motion.free_rolling->xi, finer.xi, asked.motion.free_rolling->xi.error);
  EXPECT_NEAR(asked.motion.free_rolling->rolling_radius, finer.rolling_radius,
              asked.motion.free_rolling->radius().error);
  EXPECT_GT(asked.result.totals.Fx, 1000) << "at xi = 0 the wheel does not roll freely here";
}

/// It ends where what is left is a tenth of its stated error, wherever it starts: near free rolling, driven,
/// or where everything slips.
TEST(FreeRolling, IsAsPreciseAsItsErrorOnManyScenes) {
  NEEDS_NO_SANITIZER();
  for (const char* bodies :
       {"position.lateral = 0\nload.force = 8e4\n", "position.lateral = 3\nload.force = 3e4\n",
        "position.lateral = 6.6\nload.force = 1e5\nposition.yaw = 0.01\n",
        "position.lateral = 7.1\nload.force = 4e4\nmotion.friction = 0.15\n",
        "position.lateral = 7\nload.force = 1e5\nmotion.eta = 0.004\n"})
    for (const char* model : {"halfspace", "tangent_plane"}) {
      const std::string scene =
          fmt::format("rail.profile = '60E1'\nwheel.profile = 'S1002'\nsolver.model = '{}'\n"
                      "grid = {{ dx = 0.6, ds = 0.35 }}\n{}",
                      model, bodies);
      const FreeRolling precise =
          *Sequence().solve(parse_scene_file(scene + "load.force_x = 0\n")).motion.free_rolling;
      for (const char* xi : {"0", "1e-3", "-4e-3", "0.03"}) {
        const auto found =
            Sequence().solve(parse_scene_file(scene + "motion.xi = " + xi + "\n")).motion.free_rolling;
        ASSERT_TRUE(found) << scene << xi;
        EXPECT_NEAR(found->xi, precise.xi, 0.1 * precise.xi.error) << scene << xi;
        EXPECT_NEAR(found->xi.error, precise.xi.error, 0.25 * precise.xi.error) << scene << xi;
      }
    }
}

TEST(FreeRolling, LeavesTheResultAsItIs) {
  const SceneResult with = Sequence().solve(rolling(""));
  const SceneResult without = Sequence().solve(rolling("motion.free_rolling = false\n"));
  EXPECT_FALSE(without.motion.free_rolling);
  EXPECT_EQ(with.result.totals.Fx, without.result.totals.Fx);
  EXPECT_EQ(with.result.pn, without.result.pn);
}

TEST(FreeRolling, CreepageIsCountedFromThere) {
  const SceneResult free = Sequence().solve(rolling("motion.from_free_rolling = true\n"));
  EXPECT_NEAR(free.result.totals.Fx, 0, 0.5);
  // Which rolling radius is given hardly matters: that of free rolling is found. What is left is how the slip
  // 1 - r / R_roll differs from row to row, in proportion to 1 / R_roll: 0.2 %.
  const std::string driven = "motion.from_free_rolling = true\nmotion.xi = 1e-3\n";
  const SceneResult one = Sequence().solve(rolling(driven + "motion.rolling_radius = 465\n"));
  const SceneResult other = Sequence().solve(rolling(driven + "motion.rolling_radius = 466\n"));
  EXPECT_GT(one.result.totals.Fx, 4000);
  EXPECT_NEAR(one.result.totals.Fx, other.result.totals.Fx, 3e-3 * one.result.totals.Fx);
  EXPECT_NEAR(one.motion.xi - one.motion.free_rolling->xi, 1e-3, 1e-9);
  EXPECT_NEAR(one.motion.free_rolling->rolling_radius, other.motion.free_rolling->rolling_radius, 1e-2);
}

TEST(FreeRolling, RadiusHardlyDependsOnTheOneGiven) {
  const FreeRolling own = *Sequence().solve(rolling("")).motion.free_rolling;
  for (const double given : {440.0, 455.0, 460.0, 470.0, 920.0}) {
    const std::string radius = fmt::format("motion.rolling_radius = {}\n", given);
    const FreeRolling free = *Sequence().solve(rolling(radius)).motion.free_rolling;
    // What is left is how the slip 1 - r / R_roll differs from row to row.
    EXPECT_NEAR(free.rolling_radius, own.rolling_radius, 2e-3 * std::abs(own.rolling_radius - given))
        << given;
    // The creepage found is the one that may be prescribed.
    const SceneResult again = Sequence().solve(rolling(radius + fmt::format("motion.xi = {}\n", free.xi)));
    EXPECT_NEAR(again.result.totals.Fx, 0, 8 * std::abs(own.rolling_radius - given)) << given;
  }
}

/// A wheel that slides without turning has no spin: free rolling is another state, with an error of its own.
TEST(FreeRolling, AWheelThatHardlyTurnsHasTheSame) {
  const FreeRolling own = *Sequence().solve(rolling("")).motion.free_rolling;
  for (const char* xi : {"0.5", "0.999", "1"}) {
    const FreeRolling free =
        *Sequence().solve(rolling(std::string("motion.xi = ") + xi + "\n")).motion.free_rolling;
    EXPECT_NEAR(free.xi, own.xi, own.xi.error) << xi;
    EXPECT_NEAR(free.xi.error, own.xi.error, 0.5 * own.xi.error) << xi;
  }
}

TEST(FreeRolling, WhatContradictsItIsRefused) {
  EXPECT_THAT(message_of([] { rolling("motion.from_free_rolling = true\nload.force_x = 100\n"); }),
              HasSubstr("its creepage is found"));
  EXPECT_THAT(message_of([] { rolling("motion.from_free_rolling = true\nmotion.kind = \"transient\"\n"); }),
              HasSubstr("free rolling is steady"));
}

/// A_nn and A_ns of the wheel all the same: u_r does not depend on x, and its integral is linear.
TEST(RadialDisplacement, IsAUniformSlipUnderUniformNumbers) {
  InfluenceNumbers pair{4, 2, 0.5, 0.5, {}};
  pair.values.assign(pair.expected_values(), 0.0);
  const double delta[] = {0.0, -0.5};
  NumberLines wheel(2, 4);
  for (int row = 0; row < 2; ++row) {
    wheel.begin(row);
    for (int column = 0; column <= row; ++column)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          std::ranges::fill(wheel.line(column, i, j), i != component_n && j != component_n   ? 0.0
                                                      : i == component_n && j == component_n ? 2e-6
                                                      : i == component_x || j == component_x ? 0.0
                                                                                             : 1e-6);
    add_wheel(wheel, delta, 400, pair);
  }
  for (int m = 0; m < pair.offsets; ++m)
    for (int row_i = 0; row_i < 2; ++row_i)
      for (int row_j = 0; row_j < 2; ++row_j) {
        // Pressure moves the wheel's surface towards the axle: u falls with x by |u_r| / R per length. In the
        // contact frame the pressure on the wheel has the other sign.
        const double towards_axle = 2e-6 * std::cos(delta[row_i]) + 1e-6 * std::sin(delta[row_i]);
        EXPECT_NEAR(pair.at(m, row_i, component_x, row_j, component_n), towards_axle * 0.5 * m / 400, 1e-20);
        EXPECT_EQ(pair.at(m, row_i, component_n, row_j, component_n), 2e-6);
        EXPECT_EQ(pair.at(m, row_i, component_n, row_j, component_x), 0);
      }
}

SceneFile conformal(bool radial) {
  SceneFile scene = read_scene_file(CONFORMAL_SOURCE_DIR "/data/scenes/conformal_small.toml");
  scene.motion.radial_displacement = radial;
  return with_model(scene, Model::fem);
}

/// A table of the wheel's own, its displacements integrated number by number, and then added to the rail's.
TEST(RadialDisplacement, LinesAddedToTheRailAreBothTablesAdded) {
  const SceneFile scene = conformal(true);
  SequenceFiles files;
  const ContactCase asked = prepare_case(scene, files);
  const ContactOnGrid contact = asked.setup.on(first_plan(asked, scene.grid, true));
  const ContactGrid& grid = contact.problem.grid;
  const auto table = [&](InfluenceFile& file, const std::vector<double>& row_s, double radius) {
    return halfspace::resample(file.around(file.strip().all_stations()),
                               {.dx = grid.dx, .offsets = grid.mx + 2, .contact_radius = radius}, row_s,
                               grid.ds);
  };
  InfluenceNumbers wheel = table(*asked.files.wheel, contact.wheel_s, contact.contact_radius);
  const auto inclination = radial_inclination(asked.setup, contact.problem.rows);
  ASSERT_FALSE(inclination.empty());
  for (const auto& [row_i, row_j] : wheel.stored_rows())
    for (int j = 0; j < 3; ++j) {
      double sum = 0;
      const auto inwards = [&](int m) {
        return -std::sin(inclination[row_i]) * wheel.at(m, row_i, component_s, row_j, j) -
               std::cos(inclination[row_i]) * wheel.at(m, row_i, component_n, row_j, j);
      };
      for (int m = 1; m < wheel.offsets; ++m) {
        sum += 0.5 * grid.dx / contact.contact_radius * (inwards(m - 1) + inwards(m));
        wheel.at(m, row_i, component_x, row_j, j) += sum;
      }
    }
  const InfluenceNumbers apart =
      halfspace::combine(table(*asked.files.rail, contact.rail_s, 0), std::move(wheel));
  for (const int threads : {1, 2}) {
    const InfluenceNumbers pair = fem_pair(asked.setup, asked.files, contact, nullptr, threads);
    ASSERT_EQ(pair.values.size(), apart.values.size());
    const double scale = apart.at(0, 0, component_n, 0, component_n);
    double largest = 0;
    for (std::size_t k = 0; k < apart.values.size(); ++k)
      largest = std::max(largest, std::abs(pair.values[k] - apart.values[k]));
    EXPECT_LT(largest, 1e-15 * scale) << threads;
  }
}

TEST(RadialDisplacement, MovesFreeRollingAndNothingElse) {
  Sequence sequence;
  SceneFile with = conformal(true), without = conformal(false);
  const SceneResult a = sequence.solve(with), b = sequence.solve(without);
  // 0.8e-4 by an independent 3-D analysis of these profiles, whose wheel is not this coarse one.
  EXPECT_NEAR(a.motion.free_rolling->xi - b.motion.free_rolling->xi, -0.8e-4, 0.3e-4);
  with.motion.from_free_rolling = without.motion.from_free_rolling = true;
  with.motion.xi = without.motion.xi = 1e-3;
  const double fx = sequence.solve(with).result.totals.Fx;
  EXPECT_NEAR(sequence.solve(without).result.totals.Fx, fx, 5e-3 * fx);
}

} // namespace
