#include "bem_contact/scene/motion.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "tests/base/message.hpp"
#include "tests/base/temporary_folder.hpp"
#include "tests/scene/patch_on_grid.hpp"

#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace bem_contact;
using ::testing::HasSubstr;

/// A rolling contact of steel cylinders or ellipsoids, with tables beside it.
class MotionTables : public ::testing::Test {
protected:
  void write(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }
  SceneFile patch(const std::string& load, const std::string& motion) {
    SceneFile scene = parse_scene_file("kind = 'patch'\n[load]\nforce = 1e4\n" + load +
                                       "\n[motion]\nfriction = 0.3\n" + motion +
                                       "\n[grid]\ndx = 0.5\nds = 0.5\nmx = 16\nms = 16\n"
                                       "[gap]\na = 1e-3\nb = 1e-3\n");
    scene.folder = folder_.path();
    return scene;
  }
  std::string refusal(const SceneFile& scene) {
    return message_of([&] { Sequence().solve(with_model(scene, Model::halfspace)); });
  }
  TemporaryFolder folder_;
};

TEST_F(MotionTables, ForcesPrescribedAreReached) {
  const SceneFile scene = patch("force_x = 1200\nforce_s = -500", "phi = 1e-4");
  const SceneResult r = Sequence().solve(with_model(scene, Model::halfspace));
  ASSERT_TRUE(r.result.certified()) << r.result.trust.solver_note;
  EXPECT_NEAR(r.result.totals.Fx, 1200, 1e-2);
  EXPECT_NEAR(r.result.totals.Fs, -500, 1e-2);
  // the creepages found, prescribed, give the same
  SceneFile again = patch("", "phi = 1e-4");
  again.motion.xi = r.result.totals.creepage_x;
  again.motion.eta = r.result.totals.creepage_s;
  const SceneResult s = Sequence().solve(with_model(again, Model::halfspace));
  EXPECT_NEAR(s.result.totals.Fx, 1200, 0.1);
  EXPECT_NEAR(s.result.totals.Fy, -500, 0.1);
}

/// Approach or force, creepage or force along x, creepage or force along s: eight ways to say one problem,
/// unlike bodies, with spin.
TEST_F(MotionTables, EveryCombinationOfLoadsIsTheSameProblem) {
  const auto scene = [this](const std::string& load, const std::string& motion) {
    SceneFile s = patch(load, motion);
    s.wheel.material = {23000, 0.31};
    return s;
  };
  const SceneResult known =
      Sequence().solve(with_model(scene("", "xi = 5e-4\neta = -3e-4\nphi = 2e-4"), Model::halfspace));
  ASSERT_TRUE(known.result.certified());
  for (int k = 0; k < 8; ++k) {
    SceneFile s = scene("", "phi = 2e-4");
    if (k & 1)
      s.load = {.approach = known.result.totals.approach};
    if (k & 2) {
      s.load.force_x = known.result.totals.Fx;
    } else
      s.motion.xi = 5e-4;
    if (k & 4) {
      s.load.force_s = known.result.totals.Fs;
    } else
      s.motion.eta = -3e-4;
    const SceneResult r = Sequence().solve(with_model(s, Model::halfspace));
    ASSERT_TRUE(r.result.certified()) << k;
    EXPECT_NEAR(r.result.totals.Fz, 1e4, 1) << k;
    EXPECT_NEAR(r.result.totals.Fx, known.result.totals.Fx, 1e-4 * known.result.totals.Fx) << k;
    EXPECT_NEAR(r.result.totals.Fy, known.result.totals.Fy, 1e-4 * known.result.totals.Fx) << k;
    EXPECT_NEAR(s.motion.xi + r.result.totals.creepage_x, 5e-4, 1e-7) << k;
    EXPECT_NEAR(s.motion.eta + r.result.totals.creepage_s, -3e-4, 1e-7) << k;
  }
}

TEST_F(MotionTables, RigidSlipByElement) {
  const SceneResult known =
      Sequence().solve(with_model(patch("", "xi = 5e-4\nphi = 2e-4"), Model::halfspace));
  std::string table = "ix, is, wx, ws\n";
  for (int i = 0; i < 256; ++i) {
    const double x = (i % 16 - 7.5) * 0.5, s = (i / 16 - 7.5) * 0.5;
    table += std::to_string(i % 16) + "," + std::to_string(i / 16) + "," + std::to_string(5e-4 - 2e-4 * s) +
             "," + std::to_string(2e-4 * x) + "\n";
  }
  write("slip.csv", table);
  const SceneResult r = Sequence().solve(with_model(patch("", "slip_table = 'slip.csv'"), Model::halfspace));
  EXPECT_NEAR(r.result.totals.Fx, known.result.totals.Fx, 1e-2 * known.result.totals.Fx)
      << "six digits in the table";
  EXPECT_NEAR(r.result.totals.Fy, known.result.totals.Fy, 1e-2 * known.result.totals.Fx);
}

TEST_F(MotionTables, TransientRollingTendsToSteadyRolling) {
  const SceneResult steady =
      Sequence().solve(with_model(patch("", "xi = 6e-4\neta = 2e-4"), Model::halfspace));
  const SceneResult r = Sequence().solve(
      with_model(patch("", "kind = 'transient'\nsteps = 60\nxi = 6e-4\neta = 2e-4"), Model::halfspace));
  ASSERT_EQ(r.history.size(), 60u);
  EXPECT_LT(r.history[0].totals.Fx, 0.6 * steady.result.totals.Fx);
  EXPECT_NEAR(r.result.totals.Fx, steady.result.totals.Fx, 0.01 * steady.result.totals.Fx);
  EXPECT_NEAR(r.result.totals.Fy, steady.result.totals.Fy, 0.01 * steady.result.totals.Fx);
}

/// Bodies that shift by 20 elements' worth of slip, and then roll: the first step is Cattaneo's shift.
TEST_F(MotionTables, AShiftBeforeRolling) {
  const SceneResult rolls = Sequence().solve(with_model(
      patch("", "kind = 'transient'\nxi = 5e-5\neta = 2e-5\nsteps = 2\nfirst_shift = 20"), Model::halfspace));
  const SceneResult shift = Sequence().solve(
      with_model(patch("", "kind = 'shift'\nxi = 5e-4\neta = 2e-4"), Model::halfspace)); // dx = 0.5 mm
  ASSERT_EQ(rolls.history.size(), 2u);
  EXPECT_NEAR(rolls.history[0].totals.Fx, shift.result.totals.Fx, 1e-5 * shift.result.totals.Fx);
  EXPECT_NEAR(rolls.history[0].totals.Fy, shift.result.totals.Fy, 1e-5 * shift.result.totals.Fx);
  std::string table = "ix, is, px, ps, pn\n";
  for (int i = 0; i < 256; ++i)
    table += std::to_string(i % 16) + "," + std::to_string(i / 16) + "," +
             std::to_string(shift.result.px[i]) + "," + std::to_string(shift.result.ps[i]) + "," +
             std::to_string(shift.result.pn[i]) + "\n";
  write("start.csv", table);
  const SceneResult then = Sequence().solve(with_model(
      patch("", "kind = 'transient'\nxi = 5e-5\neta = 2e-5\nstart_table = 'start.csv'"), Model::halfspace));
  EXPECT_NEAR(rolls.result.totals.Fx, then.result.totals.Fx, 1e-4 * then.result.totals.Fx);
  EXPECT_THROW(patch("", "kind = 'shift'\nxi = 5e-4\nfirst_shift = 20"), InputError);
  EXPECT_THROW(patch("", "kind = 'transient'\nstart_table = 'start.csv'\nfirst_shift = 20"), InputError);
}

/// The same history by the table, on the moving grid and on one that lies still, along which the contact
/// moves.
TEST_F(MotionTables, MovingAndStillGridRollAlike) {
  write("moving.csv", "xi, load\n6e-4, 1e4\n6e-4, 1e4\n5e-4, 9e3\n");
  const SceneResult moving = Sequence().solve(
      with_model(patch("", "kind = 'transient'\nstep_table = 'moving.csv'"), Model::halfspace));
  write("still.csv", "xi, load, x\n3e-4, 1e4, -0.5\n3e-4, 1e4, 0\n2.5e-4, 9e3, 0.5\n");
  const SceneResult still =
      Sequence().solve(with_model(patch("", "kind = 'shift'\nstep_table = 'still.csv'"), Model::halfspace));
  ASSERT_EQ(moving.history.size(), 3u);
  ASSERT_EQ(still.history.size(), 3u);
  EXPECT_NEAR(still.history[0].totals.Fx, moving.history[0].totals.Fx, 1e-5 * moving.history[0].totals.Fx);
  EXPECT_NEAR(still.history[1].totals.Fx, moving.history[1].totals.Fx, 1e-5 * moving.history[1].totals.Fx);
  EXPECT_NEAR(still.result.totals.Fz, 9e3, 1e-2);
  // two steps back in rolling, one in shifts: the same but for what one element of step costs
  EXPECT_NEAR(still.result.totals.Fx, moving.result.totals.Fx, 0.05 * moving.result.totals.Fx);
}

TEST_F(MotionTables, StartsFromTractionsGiven) {
  const SceneResult first =
      Sequence().solve(with_model(patch("", "kind = 'shift'\nxi = 1e-3"), Model::halfspace));
  std::string table = "ix, is, px, ps, pn\n";
  for (int i = 0; i < 256; ++i)
    table += std::to_string(i % 16) + "," + std::to_string(i / 16) + "," +
             std::to_string(first.result.px[i]) + "," + std::to_string(first.result.ps[i]) + "," +
             std::to_string(first.result.pn[i]) + "\n";
  write("start.csv", table);
  const SceneResult second = Sequence().solve(
      with_model(patch("", "kind = 'shift'\nxi = 5e-4\nstart_table = 'start.csv'"), Model::halfspace));
  const SceneResult both =
      Sequence().solve(with_model(patch("", "kind = 'shift'\nxi = 15e-4"), Model::halfspace));
  ASSERT_TRUE(second.result.certified());
  // on a monotone path it does not matter how many steps lead along it
  EXPECT_NEAR(second.result.totals.Fx, both.result.totals.Fx, 1e-3 * both.result.totals.Fx);
  EXPECT_GT(second.result.totals.Fx, 1.1 * first.result.totals.Fx);
}

TEST_F(MotionTables, FrictionByATable) {
  write("mu.csv", "s, mu\n-1, 0.1\n1, 0.5\n");
  const SceneFile scene = patch("", "friction_table = 'mu.csv'\nxi = 0.05");
  const ContactOnGrid contact = patch_on_grid(scene);
  EXPECT_DOUBLE_EQ(contact.problem.friction_of(0), 0.1);
  EXPECT_DOUBLE_EQ(contact.problem.friction_of(15), 0.5);
  EXPECT_NEAR(contact.problem.friction_of(8), 0.35, 1e-12); // s = 0.25
  const SceneResult r = Sequence().solve(with_model(scene, Model::halfspace));
  EXPECT_NEAR(r.result.totals.Fx, 0.3 * 1e4, 1) << "symmetric about mu = .3";
}

TEST_F(MotionTables, KineticFrictionIsARatioOfTheLargest) {
  write("mu.csv", "s, mu\n-1, 0.1\n1, 0.4\n");
  EXPECT_DOUBLE_EQ(patch_on_grid(patch("", "kinetic_friction = 0.2\nxi = 1")).problem.kinetic, 2.0 / 3);
  EXPECT_DOUBLE_EQ(
      patch_on_grid(patch("", "friction_table = 'mu.csv'\nkinetic_friction = 0.2\nxi = 1")).problem.kinetic,
      0.5);
}

TEST_F(MotionTables, AShiftOfAWheelDoesNotRoll) {
  SceneFile scene = parse_scene_file("kind = 'wheel_rail'\nrail.profile = '60E1'\nwheel.profile = 'S1002'\n"
                                     "position.lateral = 6.4\nload.force = 2e4\n"
                                     "[motion]\nkind = 'shift'\nxi = 0.01\neta = 0.02\n"
                                     "[grid]\ndx = 1.0\nds = 0.5\n");
  const SceneResult r = Sequence().solve(with_model(scene, Model::halfspace));
  ASSERT_TRUE(r.result.certified()) << r.result.trust.solver_note;
  for (int i = 0; i < r.problem.grid.size(); ++i) {
    EXPECT_DOUBLE_EQ(r.problem.slip_x[i], 0.01) << "no spin of the geometry";
    EXPECT_DOUBLE_EQ(r.problem.slip_s[i],
                     0.02 * std::cos(r.problem.rows[i / r.problem.grid.mx].delta - r.motion.reference.delta));
  }
  EXPECT_GT(r.result.totals.Fx, 0);
}

/// The contact of an early step may be the largest: the grid has to hold it too.
TEST_F(MotionTables, TheGridGrowsForEveryStep) {
  write("steps.csv", "load\n1e5\n1e4\n");
  SceneFile scene =
      parse_scene_file("kind = 'wheel_rail'\nrail.profile = '60E1'\nwheel.profile = 'S1002'\n"
                       "load.force = 1e4\n[motion]\nkind = 'transient'\nstep_table = 'steps.csv'\n"
                       "[grid]\ndx = 1.0\nds = 1.0\n");
  scene.folder = folder_.path();
  const SceneResult r = Sequence().solve(with_model(scene, Model::halfspace));
  ASSERT_EQ(r.history.size(), 2u);
  EXPECT_NEAR(r.history[0].totals.Fz, 1e5, 1);
  EXPECT_FALSE(r.history[0].trust.touches_border);
}

TEST_F(MotionTables, TablesThatDoNotFitAreRefused) {
  write("t.csv", "xi, spin\n0, 0\n");
  EXPECT_THAT(refusal(patch("", "kind = 'shift'\nstep_table = 't.csv'")), HasSubstr("'spin' is not known"));
  write("t.csv", "xi, xi\n0, 0\n");
  EXPECT_THAT(refusal(patch("", "kind = 'shift'\nstep_table = 't.csv'")), HasSubstr("there twice"));
  write("t.csv", "force_x\n10\n");
  EXPECT_THAT(refusal(patch("", "kind = 'shift'\nstep_table = 't.csv'")),
              HasSubstr("load.force_x is not given"));
  write("t.csv", "eta\n1e-3\n");
  EXPECT_THAT(refusal(patch("", "kind = 'shift'\neta = 2e-3\nstep_table = 't.csv'")),
              HasSubstr("has the creepage eta (motion.eta is given too) Leave out one of the two."));
  write("t.csv", "x\n1\n");
  EXPECT_THAT(refusal(patch("", "kind = 'transient'\nstep_table = 't.csv'")), HasSubstr("cannot be moved"));
  write("t.csv", "xi\n");
  EXPECT_THAT(refusal(patch("", "kind = 'shift'\nstep_table = 't.csv'")), HasSubstr("is empty"));
  write("t.csv", "load\n-1\n");
  EXPECT_THAT(refusal(patch("", "kind = 'shift'\nstep_table = 't.csv'")), HasSubstr("force"));
  write("t.csv", "s, mu\n1, 0.3\n0, 0.3\n");
  EXPECT_THAT(refusal(patch("", "xi = 1e-3\nfriction_table = 't.csv'")), HasSubstr("ascending"));
  write("t.csv", "s, mu\n0, -0.3\n");
  EXPECT_THAT(refusal(patch("", "xi = 1e-3\nfriction_table = 't.csv'")), HasSubstr("mu >= 0"));
  write("t.csv", "s, mu\n0, 0.1\n");
  EXPECT_THAT(refusal(patch("", "xi = 1e-3\nkinetic_friction = 0.2\nfriction_table = 't.csv'")),
              HasSubstr("in adhesion is at most 0.1"));
  EXPECT_THAT(refusal(patch("force_x = 4000", "")), HasSubstr("cannot be carried"));
}

TEST_F(MotionTables, ComparingStepsNeedsAForce) {
  SceneFile scene = patch("", "kind = 'shift'\nxi = 1e-3");
  scene.load = {};
  scene.load.approach = 0.02;
  EXPECT_THROW(Sequence().compare(scene), InputError);
}

/// A lubricated gauge face: friction by inclination is that of a table by arc length at the same rows.
TEST_F(MotionTables, FrictionByInclinationIsThatOfTheRowsInclination) {
  write("inclination.csv", "inclination,mu\n-0.8,0.1\n-0.4,0.1\n-0.3,0.4\n");
  SceneFile scene =
      parse_scene_file("rail.profile = '60E1'\nwheel.profile = 'S1002'\nload.force = 8e4\n"
                       "position = { lateral = 6.6, rail_inclination = 0.025 }\nmotion.free_rolling = false\n"
                       "solver.model = 'halfspace'\ngrid = { dx = 1, ds = 0.5, s_from = -40, s_to = -5 }\n"
                       "motion.friction_table = 'inclination.csv'\n");
  scene.folder = folder_.path();
  const SceneResult r = Sequence().solve(scene);
  ASSERT_TRUE(r.result.certified());
  std::string by_s = "s,mu\n";
  int lubricated = 0, dry = 0;
  for (std::size_t is = 0; is < r.problem.rows.size(); ++is) {
    const double delta = r.problem.rows[is].delta;
    const double mu = delta < -0.4 ? 0.1 : delta > -0.3 ? 0.4 : 0.1 + 0.3 * (delta + 0.4) / 0.1;
    EXPECT_NEAR(r.problem.friction_rows[is], mu, 1e-12);
    by_s += fmt::format("{:.17g},{:.17g}\n", r.problem.rows[is].s, mu);
    lubricated += mu < 0.11;
    dry += mu > 0.39;
  }
  EXPECT_GT(lubricated, 3);
  EXPECT_GT(dry, 3);
  write("s.csv", by_s);
  scene.motion.friction_table = "s.csv";
  const SceneResult same = Sequence().solve(scene);
  EXPECT_NEAR(same.result.totals.Fx, r.result.totals.Fx, 1e-6 * 8e4);
  EXPECT_NEAR(same.result.totals.Fy, r.result.totals.Fy, 1e-6 * 8e4);
  write("wrong.csv", "inclination,mu\n-0.3,0.1\n-0.8,0.1\n");
  scene.motion.friction_table = "wrong.csv";
  EXPECT_THAT(message_of([&] { read_motion(scene); }), HasSubstr("ascending inclination"));
}

/// The wheelset turns with the track, and motion.yaw_rate counts from there.
TEST(Motion, ACurveIsAYawRate) {
  for (const char* side : {"left", "right"}) {
    const std::string one = fmt::format("rail.profile = '60E1'\nwheel.profile = 'S1002'\nload.force = 1e5\n"
                                        "motion.speed = 2e4\nposition.side = '{}'\n",
                                        side);
    const auto yaw = [&](const char* more) { return read_motion(parse_scene_file(one + more)).creepage.yaw; };
    EXPECT_NEAR(yaw("track.curve_radius = -5e5\n"), yaw("motion.yaw_rate = -0.04\n"), 1e-20) << side;
    EXPECT_NEAR(yaw("track.curve_radius = 4e5\nmotion.yaw_rate = -0.05\n"), 0, 1e-20) << side;
  }
}

} // namespace
