#include "bem_contact/h5/table.hpp"
#include "tests/app/run_program.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <numbers>

namespace {

using namespace bem_contact;
using ::testing::AllOf;
using ::testing::Each;
using ::testing::HasSubstr;

const std::string patch_scene =
    "kind = \"patch\"\nmotion.friction = 0.3\n[grid]\ndx = 0.5\nds = 0.5\nmx = 16\nms = 16\n"
    "[gap]\na = 1e-3\nb = 1e-3\n";
const std::string columns = "[replay.columns]\ntime = \"t\"\nload.force = { column = \"Q\", unit = \"kN\" }\n"
                            "motion.xi = { column = \"nu\", unit = \"%\", factor = -1 }\n"
                            "[replay.compare]\nFx = { column = \"T\", unit = \"kN\" }\n";
/// A wheel on a rail, whose numbers have stated errors.
const std::string rail_scene =
    "rail.profile = \"60E1\"\nwheel.profile = \"S1002\"\nposition.rail_inclination = 0.025\n"
    "load.force = 75000\nmotion.friction = 0.3\nsolver.model = \"halfspace\"\ngrid.accuracy = 0.05\n";
/// Numbers whose errors are stated there.
constexpr const char* stated[] = {"Fx", "Fz", "pmax", "area", "T_gamma", "adhesion_share"};

struct Step {
  double load = 5, creepage = -0.1, force = 1; ///< kN, %, kN
};

class Replay : public ProgramTest {
protected:
  std::filesystem::path run_of(const std::vector<Step>& steps) const {
    std::string text = "t,Q,nu,T,remark\n";
    for (std::size_t i = 0; i < steps.size(); ++i)
      text += fmt::format("{},{},{},{},of no matter\n", 0.01 * double(i), steps[i].load, steps[i].creepage,
                          steps[i].force);
    return write("run.csv", text);
  }
  std::filesystem::path out(const std::string& name = "r.h5") const { return folder_ / name; }
  Outcome replay(const std::vector<Step>& steps, const std::string& more = "",
                 const std::string& scene = patch_scene + columns, const std::string& name = "r.h5") const {
    return run(fmt::format("replay '{}' '{}' -o '{}' {}", run_of(steps).string(),
                           write("s.toml", scene).string(), out(name).string(), more));
  }
  std::vector<double> column(const std::string& name, const std::string& file = "r.h5") const {
    return read_h5(out(file)).datasets.at(name).values;
  }
};

std::vector<Step> swaying(std::size_t count) {
  std::vector<Step> out(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double phase = 2 * std::numbers::pi * double(i) / double(count);
    out[i] = {75 + 5 * std::sin(phase), -0.1 + 0.03 * std::cos(phase), 0};
  }
  return out;
}

TEST_F(Replay, StepsThatStandStillAreSolvedOnce) {
  const Outcome found = replay(std::vector<Step>(100));
  EXPECT_EQ(found.code, 0) << found.err;
  EXPECT_THAT(found.out, HasSubstr("1 of 100 steps was solved"));
  const std::vector<double> force = column("Fx");
  EXPECT_THAT(force, Each(force.front()));
  EXPECT_GT(force.front(), 0); // the factor turns the sign of the creepage
  EXPECT_NEAR(column("Fz").front(), 5e3, 1e-3);
  EXPECT_NEAR(column("note.time").back(), 0.99, 1e-12);
}

TEST_F(Replay, HasNoDerivatives) {
  const Outcome found =
      replay(std::vector<Step>(5), "", "derivatives = [\"load\"]\n" + patch_scene + columns);
  EXPECT_EQ(found.code, 2);
  EXPECT_THAT(found.err, HasSubstr("replay does not solve every step"));
}

/// Nothing that was not solved is farther from its solution than both stated errors and the tolerance say.
TEST_F(Replay, WhatLiesBetweenIsWithinItsStatedErrors) {
  const std::vector<Step> steps = swaying(80);
  EXPECT_EQ(replay(steps, "", rail_scene + columns).code, 0);
  EXPECT_EQ(replay(steps, "--tolerance 0", rail_scene + columns, "all.h5").code, 0);
  const std::vector<double> solved = column("solved"), all = column("solved", "all.h5");
  EXPECT_EQ(std::ranges::count(all, 1.0), 80);
  EXPECT_LT(std::ranges::count(solved, 1.0), 60);
  for (const char* name : stated) {
    const std::vector<double> few = column(name), error = column(std::string(name) + "_error"),
                              every = column(name, "all.h5");
    for (std::size_t i = 0; i < few.size(); ++i)
      if (!std::isnan(error[i])) { // where it is not known, it says so
        EXPECT_LE(std::abs(few[i] - every[i]), std::max(error[i], 1e-3 * std::abs(every[i])))
            << name << " at " << i;
      }
  }
}

/// Also where no errors are stated: these elements are too large for that.
TEST_F(Replay, OneStepThatJumpsIsSolved) {
  std::vector<Step> steps(64);
  steps[23].load = 9;
  EXPECT_EQ(replay(steps).code, 0);
  EXPECT_EQ(column("solved")[23], 1);
  EXPECT_NEAR(column("Fz")[23], 9e3, 1e-3);
  EXPECT_NEAR(column("Fz")[22], 5e3, 1e-3);
  EXPECT_NEAR(column("Fz")[24], 5e3, 1e-3);
}

TEST_F(Replay, SaysWhereTheRunIsMostWrong) {
  std::vector<Step> steps(20);
  steps[7].force = -3;
  const Outcome found = replay(steps);
  EXPECT_THAT(found.out, HasSubstr("The run's own Fx differs most at 0.07 s (case 7): it is -3000 N, "));
  EXPECT_THAT(found.out, HasSubstr("N less than ours."));
  EXPECT_NEAR(column("Fx_difference")[7], -3e3 - column("Fx")[7], 1e-9);
  EXPECT_NEAR(column("Fx_of_run")[8], 1e3, 1e-9);
}

TEST_F(Replay, AWheelThatLiftsEndsNothing) {
  std::vector<Step> steps(40);
  steps[10].load = steps[11].load = 0;
  const Outcome found = replay(steps);
  EXPECT_EQ(found.code, 3);
  EXPECT_THAT(found.out, HasSubstr("38 of 40 cases are certified; refused: 2."));
  EXPECT_TRUE(std::isnan(column("Fx")[10]));
  EXPECT_FALSE(std::isnan(column("Fx")[12]));
}

/// The right wheel's mirror image: the same creepage to the right is one to the left for a left wheel.
TEST_F(Replay, LeftWheelsCountToTheLeft) {
  const std::string scene =
      "rail.profile = \"60E1\"\nwheel.profile = \"S1002\"\nposition.rail_inclination = 0.025\n"
      "load.force = 80000\nmotion = { friction = 0.3 }\nsolver.model = \"simplified\"\ngrid.dx = 1\ngrid.ds "
      "= 1\n"
      "[replay.columns]\nposition.lateral = \"y{wheel}\"\nmotion.eta = \"nu\"\n"
      "[replay.compare]\nFy = { column = \"T\", unit = \"kN\" }\n"
      "[replay.wheels]\nR = \"right\"\nL = \"left\"\n";
  write("run.csv", "yR,yL,nu,T\n1,-1,2e-3,5\n1,-1,-2e-3,5\n");
  write("s.toml", scene);
  const auto of = [&](const std::string& wheel) {
    return run(fmt::format("replay '{0}/run.csv' '{0}/s.toml' -o '{0}/{1}.h5' --wheel {1}", folder_.string(),
                           wheel));
  };
  EXPECT_EQ(of("R").code, 0) << of("R").err;
  EXPECT_EQ(of("L").code, 0);
  // the first step of the right wheel is the second one of the left wheel in the mirror
  EXPECT_NEAR(column("Fy", "R.h5")[0], column("Fy", "L.h5")[1], 1e-6);
  EXPECT_NEAR(column("Fx", "R.h5")[1], column("Fx", "L.h5")[0], 1e-6);
  EXPECT_NEAR(column("Fy_of_run", "L.h5")[0], -5e3, 1e-9);
  EXPECT_THAT(of("X").err, HasSubstr("There is no wheel 'X'"));
  const Outcome none = run(fmt::format("replay '{0}/run.csv' '{0}/s.toml' -o '{0}/n.h5'", folder_.string()));
  EXPECT_EQ(none.code, 2);
  EXPECT_THAT(none.err, HasSubstr("--wheel NAME"));
}

TEST_F(Replay, RefusesWhatTheRunDoesNotSay) {
  const std::string keys = patch_scene + "[replay.columns]\n";
  const auto said = [&](const std::string& more) {
    const Outcome found = replay(std::vector<Step>(3), "", keys + more);
    EXPECT_EQ(found.code, 2) << more;
    return found.err;
  };
  EXPECT_THAT(said("motion.xi = \"nuu\"\n"), AllOf(HasSubstr("has no column 'nuu'"), HasSubstr("mean nu")));
  EXPECT_THAT(said("motion.xii = \"nu\"\n"),
              AllOf(HasSubstr("'motion.xii'"), HasSubstr("Did you mean motion.xi ")));
  EXPECT_THAT(said("load.force = { column = \"Q\", unit = \"kg\" }\n"), HasSubstr("Give one of N, kN"));
  EXPECT_THAT(said("load.force = { column = \"Q\", unti = \"kN\" }\n"), HasSubstr("unknown key 'unti'"));
  EXPECT_THAT(said("motion.xi = \"remark\"\n"), HasSubstr("'of no matter' in its column remark"));
  EXPECT_THAT(said("time = \"t\"\n"), HasSubstr("does not say what is in the columns"));
  EXPECT_THAT(said("motion.xi = \"nu\"\n[replay.compare]\nFX = \"T\"\n"), HasSubstr("unknown quantity 'FX'"));
  EXPECT_THAT(said("motion.xi = \"nu\"\n[replay]\ntolerence = 1\n"), HasSubstr("replay.tolerance"));
}

TEST_F(Replay, AnotherRunIsNotTakenForTheSame) {
  EXPECT_EQ(replay(std::vector<Step>(5)).code, 0);
  const Outcome again = replay(std::vector<Step>(5));
  EXPECT_THAT(again.out, HasSubstr("is complete: nothing was solved"));
  const Outcome other = replay(std::vector<Step>(6));
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.err, HasSubstr("run.csv' has changed"));
}

} // namespace
