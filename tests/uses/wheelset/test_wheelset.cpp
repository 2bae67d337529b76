#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/sequence/quantities.hpp"
#include "bem_contact/uses/wheelset/equilibrium_finder.hpp"
#include "bem_contact/uses/wheelset/quantities.hpp"
#include "tests/geometry/brute_force.hpp"
#include "tests/uses/wheelset/scenes.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace {

using namespace bem_contact;

double of_wheelset(const WheelsetResult& r, std::string_view name) {
  for (const WheelsetQuantity& q : wheelset_quantities())
    if (name == q.name)
      return q.value(r);
  ADD_FAILURE() << name;
  return 0;
}
double of_wheel(const WheelsetResult& r, WheelSide side, std::string_view name) {
  for (const WheelQuantity& q : wheel_quantities())
    if (name == q.name)
      return q.value(r.state, side);
  ADD_FAILURE() << name;
  return 0;
}

/// In the middle of the track nothing distinguishes the wheels, and each is a wheel under half of the force
/// that rolls freely.
TEST(Wheelset, CentredIsTwoSingleWheels) {
  const WheelsetResult r = solve_wheelset(standard(""));
  EXPECT_NEAR(r.state.pose.roll, 0, 1e-12);
  SceneFile one = standard("");
  one.wheelset = {};
  one.load.force = 1e5;
  one.load.force_x = 0;
  const SceneResult single = Sequence().solve(one);
  for (const WheelSide side : both_sides) {
    const SceneResult& wheel = r.state.solved(side);
    EXPECT_NEAR(wheel.result.totals.Fz, 1e5, 0.2);
    EXPECT_NEAR(wheel.result.totals.Fy, single.result.totals.Fy, 1);
    EXPECT_NEAR(wheel.result.totals.approach, single.result.totals.approach,
                1e-6 * single.result.totals.approach);
    EXPECT_NEAR(wheel.moment, single.moment, 1e-3 * std::abs(single.moment));
  }
  // The torque vanishes, not Fx itself: the pressure of a wheel without yaw has no moment about the axle.
  EXPECT_NEAR(r.state.pose.rolling_radius.value(), single.motion.free_rolling.value().rolling_radius, 1e-3);
}

/// Rails of equal sections are the rail, of both wheels or of one; and a dip of both rails changes no share.
TEST(Wheelset, OnRailsOfSections) {
  const std::string lateral = "position.lateral = 3\nposition.along = 40\n",
                    sections =
                        "rail.sections = [ { at = 0, profile = '60E1' }, { at = 90, profile = '60E1' } ]\n",
                    rest = "wheel.profile = 'S1002'\nsolver.model = 'halfspace'\nposition.rail_inclination = "
                           "0.025\nwheelset.force = 2e5\ngrid = { dx = 0.8, ds = 0.6 }\n";
  const WheelsetResult one = solve_wheelset(standard("position.lateral = 3\n")),
                       both = solve_wheelset(parse_scene_file(rest + sections + lateral)),
                       right = solve_wheelset(
                           parse_scene_file(rest + sections + lateral + "left_rail.profile = '60E1'\n")),
                       dip = solve_wheelset(standard("position.along = 40\nrail.joint = { at = 100, dip = 1, "
                                                     "dip_length = 400 }\n"));
  for (const WheelsetResult* r : {&both, &right}) {
    EXPECT_NEAR(r->state.pose.roll, one.state.pose.roll, 1e-8);
    EXPECT_NEAR(r->state.pose.rolling_radius.value(), one.state.pose.rolling_radius.value(), 1e-3);
    for (const WheelSide side : both_sides)
      for (const char* name : {"Fx", "Fy", "Fz", "pmax"})
        EXPECT_NEAR(of_wheel(*r, side, name), of_wheel(one, side, name), 2) << name;
  }
  EXPECT_NEAR(dip.state.pose.roll, 0, 1e-9);
  EXPECT_NEAR(of_wheelset(dip, "Fz"), 2e5, 1);
  EXPECT_GT(dip.state.pose.vertical, solve_wheelset(standard("")).state.pose.vertical + 0.1);
}

/// Number by number, b is the mirror image of a.
void expect_mirror_images(const WheelsetResult& a, const WheelsetResult& b) {
  const auto sign = [](std::string_view name) {
    for (const char* odd :
         {"lateral", "roll", "yaw", "Fy", "roll_moment", "yaw_moment", "Mx", "Mz", "y", "delta", "eta", "phi",
          "radius_difference", "curve_radius_difference", "curve_force"})
      if (name == odd)
        return -1.0;
    return 1.0;
  };
  const auto expect_same = [&](const char* name, double x, double y, double mirrored) {
    if (!std::isnan(x) || !std::isnan(y)) {
      EXPECT_NEAR(y, mirrored, 2e-6 * std::abs(x) + 1e-9) << name;
    }
  };
  for (const WheelsetQuantity& q : wheelset_quantities())
    if (std::string_view(q.name) != "residual" && std::string_view(q.name) != "lateral_residual")
      expect_same(q.name, q.value(a), q.value(b), sign(q.name) * q.value(a));
  for (const WheelQuantity& q : wheel_quantities()) {
    const double right = q.value(a.state, WheelSide::right), left = q.value(a.state, WheelSide::left);
    expect_same(q.name, right, q.value(b.state, WheelSide::left), sign(q.name) * right);
    expect_same(q.name, left, q.value(b.state, WheelSide::right), sign(q.name) * left);
  }
}

/// Displacement, yaw, force and moment of other sign: the mirror image, number by number.
TEST(Wheelset, MirrorImages) {
  const char* one = "position.lateral = 3\nposition.yaw = 2e-3\nwheelset.roll_moment = 1e7\n"
                    "wheelset.torque = 2e6\nmotion.speed = 2e4\nmotion.lateral_velocity = 10\n";
  const char* other = "position.lateral = -3\nposition.yaw = -2e-3\nwheelset.roll_moment = -1e7\n"
                      "wheelset.torque = 2e6\nmotion.speed = 2e4\nmotion.lateral_velocity = -10\n";
  expect_mirror_images(solve_wheelset(standard(one)), solve_wheelset(standard(other)));
}

/// So it is on two rollers of a rig, whose speed is given.
TEST(Wheelset, MirrorImagesOnRollers) {
  const std::string both = "rail.roller_radius = 500\nmotion.speed = 2e4\nmotion.roller_speed = 40\n";
  const WheelsetResult one = solve_wheelset(standard(
                           both + "position.lateral = 5\nposition.yaw = 6e-3\nwheelset.roll_moment = 1e7\n")),
                       other = solve_wheelset(standard(
                           both +
                           "position.lateral = -5\nposition.yaw = -6e-3\nwheelset.roll_moment = -1e7\n"));
  expect_mirror_images(one, other);
  EXPECT_NEAR(of_wheelset(one, "Fz"), 2e5, 1);
  EXPECT_NEAR(of_wheelset(one, "torque"), 0, 1e-6 * 2e5 * 460);
}

/// Large rollers are the track.
TEST(Wheelset, LargeRollersAreTheTrack) {
  const std::string both = "position.lateral = 3\nposition.yaw = 2e-3\nmotion.speed = 2e4\n";
  const WheelsetResult track = solve_wheelset(standard(both)),
                       rig = solve_wheelset(standard(both + "rail.roller_radius = 1e6\n"));
  EXPECT_NEAR(rig.state.pose.roll, track.state.pose.roll, 1e-7);
  EXPECT_NEAR(rig.state.pose.vertical, track.state.pose.vertical, 1e-3);
  for (const WheelSide side : both_sides)
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(rig.state.wrench(side).force[i], track.state.wrench(side).force[i], 5e-4 * 1e5) << i;
}

/// A yawed wheelset touches its rollers before and behind their tops. Each wheel stands where a search over
/// both angles of the wheel above the circles of its roller lets it stand. Without friction the pressure has
/// no moment about the axle and none about the axis of the rollers, because both are bodies of revolution.
TEST(Wheelset, YawedOnRollersItStandsAsBodiesOfRevolutionDo) {
  const TabulatedProfile rail(named_profile("60E1", ProfileKind::rail)),
      wheel(named_profile("S1002", ProfileKind::wheel));
  BruteForce brute(rail, wheel, 0.1);
  SceneFile scene = standard("motion.frictionless = true\nposition.lateral = 5.5\nposition.yaw = 0.02\n"
                             "rail.roller_radius = 400\n");
  const WheelsetResult r = solve_wheelset(scene);
  const WheelsetPose& pose = r.state.pose;
  WheelPair wheels(scene);
  for (const WheelSide side : both_sides) {
    WheelsetPosition position = one_wheel(scene, side).position;
    position.lateral = pose.lateral, position.roll = pose.roll;
    const double found = brute.search(position, place(position, rail, wheel), 0.5).front().distance;
    EXPECT_NEAR(wheels.lowered(side, pose.lateral, pose.roll), found, 2e-6);
    EXPECT_NEAR(r.state.solved(side).result.totals.approach, pose.vertical - found, 2e-6);
    EXPECT_GT(std::abs(r.state.solved(side).motion.reference.x), 0.5) << "yaw moves them";
    const Wrench& w = r.state.wrench(side);
    // The axis of the rollers: parallel to y through x = 0, so far below the axle.
    const double below = 400 - (pose.vertical - 460);
    EXPECT_NEAR(r.state.torque(w), 0, 0.02 * 460 * std::abs(w.force[0])) << "but for the elements";
    EXPECT_NEAR(w.moment[1] - below * w.force[0], 0, 2e-5 * 400 * 1e5);
    EXPECT_GT(std::abs(w.force[0]), 100) << "the normal leans";
  }
  EXPECT_NEAR(r.state.sum().force[2], 2e5, 1);
}

/// A curve to the left is the mirror image of one to the right.
TEST(Wheelset, CurvesToBothSidesAreMirrorImages) {
  const std::string both = "motion.speed = 2e4\ntrack.superelevation = 60\n";
  const WheelsetResult right = solve_wheelset(
      standard(both + "track.curve_radius = 5e5\nposition.lateral = -5.5\nposition.yaw = -1e-3\n"));
  const WheelsetResult left = solve_wheelset(
      standard(both + "track.curve_radius = -5e5\nposition.lateral = 5.5\nposition.yaw = 1e-3\n"));
  EXPECT_LT(of_wheelset(right, "curve_force"), -1e3) << "outwards";
  expect_mirror_images(right, left);
}

/// The outer wheel has the longer way. Cones displaced outwards by Redtenbacher's y = r0 b / (slope R), b
/// half of track.base, roll through the curve as a cone on a table: no longitudinal force is left. With the
/// roll of cones on round heads (as above) that is less by the factor (b - h slope) / b. Displaced inwards,
/// both wheels creep twice as much as in the middle.
TEST(Wheelset, ConesRollThroughACurveOutwardsAsRedtenbacherSays) {
  const double slope = 1.0 / 40, radius = 1.5e6, h = 460 + 300 * std::hypot(1, slope),
               y = 460 * (750 - h * slope) / (slope * radius);
  const auto fx_of_left = [&](double lateral, const char* curve) {
    const WheelsetResult r = solve_wheelset(
        cones(fmt::format("position.lateral = {}\nmotion.friction = 0.4\n{}", lateral, curve)));
    EXPECT_NEAR(of_wheelset(r, "torque"), 0, 1e-5 * 460 * 1e5);
    return of_wheel(r, WheelSide::left, "Fx");
  };
  const char* to_the_right = "motion.speed = 1e4\ntrack.curve_radius = 1.5e6\n";
  const double straight = fx_of_left(-y, ""), outwards = fx_of_left(-y, to_the_right),
               middle = fx_of_left(0, to_the_right), inwards = fx_of_left(y, to_the_right);
  fmt::print(
      "Fx of the outer wheel: {:.0f} N outwards, {:.0f} in the middle, {:.0f} inwards; straight {:.0f}\n",
      outwards, middle, inwards, straight);
  EXPECT_GT(std::abs(straight), 4e3);
  EXPECT_LT(std::abs(outwards), 0.02 * std::abs(straight));
  EXPECT_NEAR(middle, -straight, 0.05 * std::abs(straight)); // what the displacement cancels
  EXPECT_GT(inwards, 1.3 * middle);                          // not twice: friction is being used up
}

/// Wheels of unequal radius: the cones roll without longitudinal force where their rolling radii are equal,
/// away from the larger wheel by half the difference over the slope. The axle leans by the difference over
/// the distance of the lever arms.
TEST(Wheelset, UnequalConesRunOffTheMiddle) {
  const double slope = 1.0 / 40, larger = 0.2, h = 460 + 300 * std::hypot(1, slope), arm = 750 - h * slope,
               y = larger / (2 * slope); // the right wheel must gain what the left has
  const auto at = [&](double lateral) {
    return solve_wheelset(cones(fmt::format("position.lateral = {}\nmotion.friction = 0.4\n"
                                            "wheelset.left_wheel_radius = {}\n",
                                            lateral, 460 + larger)));
  };
  const WheelsetResult middle = at(0), there = at(y);
  EXPECT_NEAR(of_wheelset(middle, "radius_difference"), -larger * 750 / arm, 5e-3 * larger);
  EXPECT_NEAR(of_wheelset(middle, "roll"), larger / (2 * arm), 5e-3 * larger / (2 * arm)); // right side down
  EXPECT_NEAR(of_wheelset(there, "radius_difference"), 0, 0.04 * larger);
  EXPECT_GT(std::abs(of_wheel(middle, WheelSide::left, "Fx")), 1.5e3);
  EXPECT_LT(std::abs(of_wheel(there, WheelSide::left, "Fx")),
            0.05 * std::abs(of_wheel(middle, WheelSide::left, "Fx")));
  EXPECT_NEAR(of_wheelset(there, "Fz"), 1e5, 0.2);
}

/// Superelevation balances the centrifugal force where v^2 / (g R) = superelevation / base; without it the
/// whole of it presses the axle outwards, beside force_y.
TEST(Wheelset, ACurvePressesTheAxleOutwards) {
  const double force = 2e5, radius = 4e5, speed = 15e3, g = 9806.65;
  const std::string curve = fmt::format("motion.speed = {}\ntrack.curve_radius = {}\n", speed, radius);
  const double balance = 1500 * speed * speed / (g * radius);
  const WheelsetResult balanced = solve_wheelset(
      standard(curve + fmt::format("position.lateral = 2\ntrack.superelevation = {}\n", balance)));
  EXPECT_NEAR(of_wheelset(balanced, "curve_force"), 0, 1e-9 * force);
  EXPECT_NEAR(of_wheelset(balanced, "curve_radius_difference"), -460.0 * 1500 / radius, 1e-12);
  const WheelsetResult pressed =
      solve_wheelset(standard(curve + "wheelset.force_y = 3e3\nposition.lateral = -5\n"));
  const double outwards = force * speed * speed / (g * radius);
  EXPECT_NEAR(of_wheelset(pressed, "curve_force"), -outwards, 1e-12 * force);
  EXPECT_NEAR(of_wheelset(pressed, "Fy"), 3e3 - outwards, 2e-6 * force);
  EXPECT_LT(of_wheelset(pressed, "lateral"), 0);
}

/// A cone on a circle stands as a cone that is larger by the circle's radius stands on its centre. With the
/// centres b from the middle and the axle h above them the roll is y tan gamma / (b - h tan gamma), right
/// side up, to first order in y (Wickens 2003, section 2.2: knife edges have h = r).
///
/// Without friction the forces are normal. Their vertical sum is the weight, and their moment about the
/// axle's centre vanishes: from these two follow the shares and the lateral force.
TEST(Wheelset, ConesRollAsTheTextbookSays) {
  const double slope = 1.0 / 40, b = 750, h = 460 + 300 * std::hypot(1, slope), y = 2, weight = 1e5;
  SceneFile scene = cones("position.lateral = 2\nmotion.frictionless = true\n");
  scene.grid.dx = scene.grid.ds = 0.4;
  const WheelsetResult r = solve_wheelset(scene);
  const double rigid = -y * slope / (b - h * slope), roll = r.state.pose.roll;
  // Unequal loads press one wheel deeper: half the difference of the approaches over b.
  const double elastic =
      (r.state.right.result.totals.approach - r.state.left.result.totals.approach) / (2 * b);
  EXPECT_NEAR(roll, rigid + elastic, 1e-3 * std::abs(rigid));
  EXPECT_NEAR(of_wheel(r, WheelSide::right, "radius") - of_wheel(r, WheelSide::left, "radius"),
              2 * slope * (y - h * roll), 1e-3 * slope * y);
  const double gamma = std::atan(slope), right_tan = std::tan(gamma - roll),
               left_tan = std::tan(gamma + roll);
  const double right_arm = b - y - h * right_tan, left_arm = b + y - h * left_tan;
  const double right = weight * left_arm / (right_arm + left_arm), left = weight - right;
  EXPECT_NEAR(of_wheel(r, WheelSide::right, "Fz"), right, 1e-5 * weight);
  EXPECT_NEAR(of_wheel(r, WheelSide::left, "Fz"), left, 1e-5 * weight);
  const double stiffness = (right * right_tan - left * left_tan) / y; // gravitational, N/mm
  fmt::print("gravitational stiffness {:.4f} N/mm, {:.4f} by statics; {:.1e} of the shares\n",
             of_wheelset(r, "Fy") / y, stiffness, of_wheel(r, WheelSide::right, "Fz") / right - 1);
  // Off by 1.6 % with elements of 0.8 mm, 0.2 % with these, 0.02 % with 0.1 mm.
  EXPECT_NEAR(of_wheelset(r, "Fy") / y, stiffness, 4e-3 * stiffness);
}

/// A moment on the axle shifts the load: by M over the distance of the lever arms, for small angles.
TEST(Wheelset, AMomentShiftsTheLoad) {
  const double moment = 1.5e7, slope = 1.0 / 40, h = 460 + 300 * std::hypot(1, slope);
  const WheelsetResult r =
      solve_wheelset(cones("wheelset.roll_moment = 1.5e7\nmotion.frictionless = true\n"));
  const double arm = 750 - h * slope; // of normals through the circles' centres
  EXPECT_NEAR(of_wheel(r, WheelSide::right, "Fz") - of_wheel(r, WheelSide::left, "Fz"), moment / arm,
              1e-3 * moment / arm);
  EXPECT_NEAR(of_wheelset(r, "roll_moment"), moment, 1e-6 * 750 * 1e5);
  EXPECT_GT(r.state.pose.roll, 0);
}

/// Without friction the contacts store all work: z dW + roll dM - Fy dy is the differential of a function,
/// and its mixed derivatives are equal.
TEST(Wheelset, MixedDerivativesOfTheEnergyAreEqual) {
  const auto solved = [](double weight, double moment, double y) {
    SceneFile scene = standard("motion.frictionless = true\n");
    scene.wheelset.force = weight;
    scene.wheelset.roll_moment = moment;
    scene.position.lateral = y;
    return solve_wheelset(scene);
  };
  const double W = 2e5, M = 1e7, y = 4.2, dW = 2e3, dM = 1e6, dy = 0.02;
  const WheelsetResult w1 = solved(W - dW, M, y), w2 = solved(W + dW, M, y), m1 = solved(W, M - dM, y),
                       m2 = solved(W, M + dM, y), y1 = solved(W, M, y - dy), y2 = solved(W, M, y + dy);
  const auto height = [](const WheelsetResult& r) { return r.state.pose.vertical; };
  const auto roll = [](const WheelsetResult& r) { return r.state.pose.roll; };
  const auto Fy = [](const WheelsetResult& r) { return r.state.sum().force[1]; };
  const double roll_by_W = (roll(w2) - roll(w1)) / dW, height_by_M = (height(m2) - height(m1)) / dM;
  const double height_by_y = (height(y2) - height(y1)) / dy, Fy_by_W = (Fy(w2) - Fy(w1)) / dW;
  const double roll_by_y = (roll(y2) - roll(y1)) / dy, Fy_by_M = (Fy(m2) - Fy(m1)) / dM;
  fmt::print("roll by W {:.4e}, height by M {:.4e}; height by y {:.4e}, Fy by W {:.4e}; roll by y {:.4e}, "
             "Fy by M {:.4e}\n",
             roll_by_W, height_by_M, height_by_y, Fy_by_W, roll_by_y, Fy_by_M);
  EXPECT_NEAR(roll_by_W / height_by_M, 1, 0.02);
  EXPECT_NEAR(-height_by_y / Fy_by_W, 1, 0.05);
  EXPECT_NEAR(-roll_by_y / Fy_by_M, 1, 0.02);
}

/// The torque is what Fx does at the radii; braking drags the rails along.
TEST(Wheelset, ATorqueDrivesOrBrakes) {
  for (const double torque : {-5e6, 5e6}) {
    const WheelsetResult r = solve_wheelset(cones(fmt::format("wheelset.torque = {}\n", torque)));
    EXPECT_NEAR(of_wheelset(r, "torque"), torque, 1e-6 * 1e5 * 460);
    EXPECT_NEAR(of_wheelset(r, "Fx"), -torque / 460, 1e-3 * 5e6 / 460);
    EXPECT_LT(of_wheel(r, WheelSide::right, "xi") * torque, 0);
  }
}

/// A displacement that was found for a force gives that force, and the sums are what was given.
TEST(Wheelset, FindsTheDisplacementOfALateralForce) {
  SceneFile scene = standard("wheelset.force_y = 3e4\nposition.yaw = 1e-3\n");
  const WheelsetResult found = solve_wheelset(scene);
  EXPECT_LE(found.residual, 1e-6);
  EXPECT_LE(found.lateral_residual, 2e-6);
  EXPECT_NEAR(of_wheelset(found, "Fy"), 3e4, 0.4);
  EXPECT_NEAR(of_wheelset(found, "Fz"), 2e5, 0.2);
  // The moment about the axle's centre by hand, patch by patch (their own moments included). About the
  // forward axis: with a yaw of 1 mrad that is the x axis where no torque drives the axle.
  double moment = 0, largest = 0;
  for (const WheelSide side : both_sides) {
    const double sign = side == WheelSide::right ? 1 : -1;
    for (const PatchSummary& p : found.state.solved(side).result.patches) {
      const double arm = sign * p.position.y - found.state.pose.lateral,
                   depth = p.position.z - (found.state.pose.vertical - 460);
      moment += arm * p.fz - depth * sign * p.fy + sign * p.moment_x;
      largest = std::max(largest, std::abs(depth * p.fy));
    }
  }
  EXPECT_GT(largest, 5e6);
  EXPECT_NEAR(moment, 0, 1e3);
  scene.wheelset.force_y.reset();
  scene.position.lateral = found.state.pose.lateral;
  const WheelsetResult there = solve_wheelset(scene);
  EXPECT_NEAR(of_wheelset(there, "Fy"), 3e4, 10);
  EXPECT_NEAR(there.state.pose.roll, found.state.pose.roll, 1e-8);
  fmt::print("lateral force: {} contact problems, {:.2f} s; at its displacement {} and {:.2f} s\n",
             found.contact_problems, found.seconds, there.contact_problems, there.seconds);
}

/// On the flange, from beside it and from the tread: there a wheel's height bends sharply over the roll, and
/// far from a known equilibrium none is found.
TEST(Wheelset, FindsTheDisplacementOfAForceOnTheFlange) {
  for (const auto& [force, from] : {std::pair{1.2e5, 6.3}, {2e5, 0.0}, {2.8e5, 0.0}}) {
    const WheelsetResult r =
        solve_wheelset(standard(fmt::format("wheelset.force_y = {}\nposition.lateral = {}\n", force, from)));
    EXPECT_NEAR(of_wheelset(r, "Fy"), force, 0.4);
    EXPECT_LT(r.state.pose.lateral, 6.5) << "before the wheelset climbs";
  }
}

/// Without a lateral force nothing moves a wheelset whose sides are alike out of the middle, where the search
/// begins, whatever elements an accuracy leads to.
TEST(Wheelset, StaysInTheMiddleUnderNoLateralForce) {
  for (const char* wheel : {"S1002", CONFORMAL_SOURCE_DIR "/data/bodies/hollow_wheel.txt"}) {
    SceneFile scene = standard("wheelset.force_y = 0\n");
    scene.grid.accuracy = 0.05;
    scene.wheel.profile = wheel;
    const WheelsetResult r = solve_wheelset(scene);
    EXPECT_EQ(r.state.pose.lateral, 0) << wheel;
    EXPECT_NEAR(r.state.pose.roll, 0, 1e-12) << wheel;
    EXPECT_GT(r.lateral_error, 0) << wheel;
    EXPECT_EQ(named(wheelset_quantities(), "lateral").error(r), r.lateral_error);
  }
}

/// From beside the middle the search ends at a displacement that differs from it by no more than its stated
/// error, which is always known. (Between two displacements forces are uneven: each is met at some places
/// beside the middle, too.)
TEST(Wheelset, EndsInTheMiddleWithinItsStatedError) {
  struct Case {
    const char *rail, *wheel;
    double inclination, force, from;
    const char* more;
  };
  const char* hollow = CONFORMAL_SOURCE_DIR "/data/bodies/hollow_wheel.txt";
  for (const Case& c : {Case{"60E1", "S1002", 0.025, 2e5, 0.3, "grid.accuracy = 0.05\n"},
                        {"60E1", "S1002", 0.025, 2e5, -0.3, "grid.accuracy = 0.05\n"},
                        {"54E1", "S1002", 0, 9e4, -0.5, "grid = { dx = 1.0, ds = 0.55 }\n"},
                        {"60E2", "S1002", 0.05, 1.4e5, -0.7, "grid.accuracy = 0.1\n"},
                        {"54E1", hollow, 0.05, 1.55e5, 1.2, "grid.accuracy = 0.05\n"},
                        {"60E1", hollow, 0.025, 1.5e5, -1.6, "grid = { dx = 1.3, ds = 0.7 }\n"}}) {
    const WheelsetResult r = solve_wheelset(parse_scene_file(fmt::format(
        "rail.profile = '{}'\nwheel.profile = '{}'\nposition = {{ rail_inclination = {}, lateral = {} }}\n"
        "wheelset = {{ force = {}, force_y = 0 }}\nsolver.model = 'halfspace'\n{}",
        c.rail, c.wheel, c.inclination, c.from, c.force, c.more)));
    SCOPED_TRACE(fmt::format("{} on {} from {}: {} +- {}", c.wheel, c.rail, c.from, r.state.pose.lateral,
                             r.lateral_error));
    EXPECT_LE(r.lateral_residual, 2e-6);
    EXPECT_TRUE(std::isfinite(r.lateral_error));
    EXPECT_LE(std::abs(r.state.pose.lateral), r.lateral_error);
  }
}

/// Where the start already bears the force it is the answer, on the flange too.
TEST(Wheelset, AStartThatIsASolutionIsKept) {
  SceneFile scene = standard("wheelset.force_y = 1e4\nposition.lateral = 5.5\n");
  const WheelsetResult found = solve_wheelset(scene);
  scene.position.lateral = found.state.pose.lateral;
  const WheelsetResult again = solve_wheelset(scene);
  EXPECT_NEAR(again.state.pose.lateral, found.state.pose.lateral, 1e-4);
}

/// The stated error of a displacement is what the errors of the forces make of it: on a cone on circles the
/// force grows by the gravitational stiffness.
TEST(Wheelset, StatesTheErrorOfTheDisplacementItFinds) {
  const auto solved = [](const std::string& more) {
    SceneFile scene = cones(more + "motion.frictionless = true\n");
    scene.grid.dx = scene.grid.ds = 0.4;
    return solve_wheelset(scene);
  };
  const auto at = [&](double y) { return solved(fmt::format("position.lateral = {}\n", y)); };
  const double slope = (of_wheelset(at(1.2), "Fy") - of_wheelset(at(0.8), "Fy")) / 0.4;
  const WheelsetResult there = at(1);
  const WheelsetResult found =
      solved(fmt::format("position.lateral = 0.5\nwheelset.force_y = {}\n", of_wheelset(there, "Fy")));
  const auto error = [&](WheelSide side) { return quantity("Fy").error(found.state.solved(side)); };
  const double expected = std::hypot(error(WheelSide::right), error(WheelSide::left)) / slope;
  EXPECT_NEAR(found.lateral_error, expected, 0.2 * expected);
  EXPECT_LT(std::abs(found.state.pose.lateral - 1), found.lateral_error);
  EXPECT_TRUE(std::isnan(there.lateral_error));
}

/// A model that was chosen says why, as for one wheel, and costs few solutions more than half-spaces: these
/// find where the wheelset stands, and the model takes the last steps.
TEST(Wheelset, AChosenModelSaysWhyAndIsSolvedFewTimes) {
  const SceneFile scene =
      parse_scene_file("rail.profile = '54E1'\nwheel.profile = 'S1002'\nposition.lateral = 3\n"
                       "wheelset.force = 8e4\nmotion.friction = 0.3\n");
  const WheelsetResult r = solve_wheelset(scene);
  EXPECT_EQ(r.state.right.choice.model, Model::tangent_plane);
  EXPECT_THAT(r.state.right.choice.why_this_model, testing::HasSubstr("the normal turns by"));
  EXPECT_THAT(r.state.left.choice.why_this_model, testing::HasSubstr("the normal turns by"));
  EXPECT_LE(r.residual, 1e-6);

  WheelPair others(scene);
  const EquilibriumStart start{0.07, 0.07, 0, 460};
  others.choose_elements(stand(others, 3, start));
  const Equilibrium slow = find_equilibrium(others, 3, start, 1e-6);
  EquilibriumFinder finder(scene, nullptr, nullptr);
  const Equilibrium quick = finder.at(3, finder.begin(3), 1e-6);
  EXPECT_LE(finder.model_problems(), 2 * 4);
  EXPECT_LT(finder.model_problems(), others.contact_problems());
  EXPECT_GT(finder.contact_problems(), finder.model_problems());
  EXPECT_NEAR(quick.state.pose.roll, slow.state.pose.roll, 1e-8);
  EXPECT_NEAR(quick.state.pose.vertical, slow.state.pose.vertical, 1e-6);
}

/// Naming the left side's profiles changes nothing if they are the right side's; its friction is its own.
TEST(Wheelset, TheLeftSideMayDiffer) {
  const std::string yawed = "position.yaw = 6e-3\n"; // both wheels slip
  const WheelsetResult same = solve_wheelset(standard(yawed));
  const WheelsetResult named =
      solve_wheelset(standard(yawed + "left_wheel.profile = 'S1002'\nleft_rail.profile = '60E1'\n"));
  EXPECT_EQ(named.state.pose.roll, same.state.pose.roll);
  const WheelsetResult oiled = solve_wheelset(standard(yawed + "wheelset.left_friction = 0.05\n"));
  const auto used = [&](WheelSide side) {
    const PatchSummary& p = oiled.state.solved(side).result.patches.front();
    return std::hypot(p.fx, p.fs) / p.fn;
  };
  EXPECT_NEAR(used(WheelSide::left), 0.05, 1e-3);
  EXPECT_GT(used(WheelSide::right), 0.25);
  const WheelsetResult other = solve_wheelset(
      standard("left_wheel.profile = '" CONFORMAL_SOURCE_DIR "/data/bodies/hollow_wheel.txt'\n"));
  EXPECT_NE(other.state.left.bodies.wheel_geometry, other.state.right.bodies.wheel_geometry);
  EXPECT_NE(other.state.pose.roll, 0);
}

/// With influence files, on a gauge so narrow that both flange roots lie in the gauge corners: under a moment
/// the wheels share the load by the lever arms of their normals, which are those of the model's own contacts.
TEST(Wheelset, FiniteElementsServeBothWheels) {
  const std::string folder = CONFORMAL_SOURCE_DIR "/data/influence/";
  const WheelsetResult r = solve_wheelset(parse_scene_file(
      fmt::format("rail = {{ profile = '60E1', influence = '{0}small_rail.h5' }}\n"
                  "wheel = {{ profile = 'S1002', influence = '{0}small_wheel.h5' }}\nsolver.model = 'fem'\n"
                  "motion.frictionless = true\nposition.gauge = 1421.8\ngrid = {{ dx = 0.5, ds = 0.5 }}\n"
                  "wheelset = {{ force = 2e5, roll_moment = 1e7 }}\n",
                  folder)));
  EXPECT_TRUE(certified(r.state));
  EXPECT_EQ(r.state.right.choice.model, Model::fem);
  EXPECT_EQ(r.state.left.choice.model, Model::fem);
  EXPECT_NEAR(of_wheelset(r, "Fz"), 2e5, 0.2);
  EXPECT_NEAR(of_wheelset(r, "roll_moment"), 1e7, 2e2);
  double moment = 0;
  for (const WheelSide side : both_sides) {
    const double arm = std::abs(of_wheel(r, side, "y")) -
                       (460 + of_wheel(r, side, "z")) * std::abs(of_wheel(r, side, "Y_over_Q"));
    moment += (side == WheelSide::right ? 1 : -1) * arm * of_wheel(r, side, "Fz");
  }
  EXPECT_NEAR(moment, 1e7, 2e4);
}

} // namespace
