#include "bem_contact/sequence/sequence.hpp"

#include "bem_contact/base/error.hpp"
#include "tests/base/message.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace bem_contact;
using ::testing::HasSubstr;

const std::string small = CONFORMAL_SOURCE_DIR "/data/scenes/conformal_small.toml";

TEST(Comparison, AtEqualForcesAllModelsBearTheSame) {
  const Comparison c =
      Sequence().compare(read_scene_file(small), {Model::halfspace, Model::tangent_plane, Model::fem});
  ASSERT_EQ(c.models[c.reference], Model::fem);
  ASSERT_EQ(c.at_forces.size(), 3u);
  const ContactResult& fem = c.at_forces[2].result;
  for (const SceneResult& r : c.at_forces) {
    EXPECT_TRUE(r.result.trust.certificate.holds());
    EXPECT_NEAR(r.result.totals.Fx, 0, 0.1) << "free rolling";
    EXPECT_NEAR(r.result.totals.Fy, fem.totals.Fy, 0.2);
    EXPECT_NEAR(r.result.totals.Fz, fem.totals.Fz, 0.1);
  }
  // What the independent 3-D analysis says: a shift of 0.02 mm makes most of the difference at equal
  // position.
  EXPECT_NEAR(*c.at_forces[0].motion.lateral - *c.at_forces[2].motion.lateral, 0.02, 0.01);
  const auto off = [](const SceneResult& a, const SceneResult& b) {
    return b.result.totals.pmax / a.result.totals.pmax - 1;
  };
  EXPECT_LT(off(c.at_position[0], c.at_position[2]), -0.05);
  EXPECT_GT(off(c.at_forces[0], c.at_forces[2]), -0.02);
}

TEST(Comparison, OnATreadWhereTheLateralForceSaysLittleOfThePositionAllModelsStayInPlace) {
  const SceneFile scene =
      parse_scene_file("kind = 'wheel_rail'\nrail.profile = '60E1'\nwheel.profile = 'S1002'\n"
                       "position.rail_inclination = 0.025\nload.force = 1e5\nmotion.friction = 0.3\n"
                       "grid.elements = 300\n");
  const Comparison c = Sequence().compare(scene, {Model::halfspace, Model::tangent_plane});
  const SceneResult &halfspace = c.at_forces[0], &planes = c.at_forces[1];
  EXPECT_EQ(*halfspace.motion.lateral, *planes.motion.lateral);
  EXPECT_NE(halfspace.result.totals.Fy, planes.result.totals.Fy) << "this test would say nothing";
  EXPECT_NEAR(halfspace.result.totals.Fy, planes.result.totals.Fy, 0.005 * 1e5);
  EXPECT_NEAR(halfspace.result.totals.pmax / planes.result.totals.pmax, 1, 0.02);
}

TEST(Comparison, CreepForcesBeyondFreeRollingAreNearlyTheSame) {
  const Comparison c = Sequence().compare(read_scene_file(small));
  const CreepForces& forces = c.creep_forces;
  ASSERT_EQ(forces.creepage.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(forces.Fx[0][k], forces.Fx[1][k], 0.01 * 0.3 * 1.07e5) << forces.creepage[k]; // 1 % of mu Fn
    for (const std::vector<double>& errors : forces.Fx_error)
      EXPECT_TRUE(errors[k] > 0 && errors[k] < 0.02 * 0.3 * 1.07e5) << errors[k];
  }
  EXPECT_GT(c.at_forces[1].motion.free_rolling->xi - c.at_forces[0].motion.free_rolling->xi, 5e-4)
      << "what differs is free rolling itself";
}

TEST(Comparison, APrescribedLateralForceIsTheCommonOne) {
  SceneFile scene = read_scene_file(small);
  scene.load.force_y = 3e4;
  const Comparison c = Sequence().compare(scene);
  for (const SceneResult& r : c.at_forces)
    EXPECT_NEAR(r.result.totals.Fy, 3e4, 0.2);
  EXPECT_EQ(*c.at_position[0].motion.lateral, *c.at_position[1].motion.lateral);
}

TEST(Comparison, APatchIsComparedAtEqualForceAlone) {
  const SceneFile scene = read_scene_file(CONFORMAL_SOURCE_DIR "/data/scenes/hertz.toml");
  const Comparison c = Sequence().compare(scene, {Model::hertz, Model::halfspace});
  EXPECT_EQ(c.models[c.reference], Model::halfspace) << "the last one, without fem";
  EXPECT_TRUE(c.at_position.empty());
  EXPECT_NEAR(c.at_forces[0].result.totals.Fz, c.at_forces[1].result.totals.Fz,
              1e-6 * c.at_forces[1].result.totals.Fz);
}

TEST(Comparison, OneModelIsNoComparison) {
  const SceneFile scene = read_scene_file(small);
  for (const std::vector<Model>& models : {std::vector{Model::fem}, std::vector{Model::fem, Model::fem}})
    EXPECT_THAT(message_of([&] { Sequence().compare(scene, models); }), HasSubstr("two different models"));
}

} // namespace
