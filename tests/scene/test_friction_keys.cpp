#include "bem_contact/base/error.hpp"
#include "bem_contact/scene/friction_laws.hpp"
#include "bem_contact/sequence/quantities.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "tests/base/message.hpp"
#include "tests/base/temporary_folder.hpp"
#include "tests/scene/patch_on_grid.hpp"

#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gmock/gmock.h>

namespace {

using namespace bem_contact;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// `top`: keys before the tables; `motion`: of that table.
SceneFile patch(const std::string& motion, const std::string& top = "") {
  return parse_scene_file(
      top +
      "\nkind = 'patch'\nload.force = 1e5\nsolver.model = 'halfspace'\n[motion]\nfriction "
      "= 0.3\n" +
      motion + "\n[grid]\ndx = 0.9\nds = 1.6\nmx = 20\nms = 20\n[gap]\na = 8e-4\nb = 2.814e-4\n");
}
auto says(const std::string& words) {
  return testing::Field(&Warning::text, HasSubstr(words));
}
std::string refusal(const std::string& motion, const std::string& top = "") {
  return message_of([&] { patch(motion, top); });
}

TEST(FrictionKeys, BothLawsArrive) {
  const ContactProblem e =
      patch_on_grid(patch("falling_friction = 0.15\nhalf_slip_velocity = 800\nspeed = 2e4\nxi = 1e-3"))
          .problem;
  EXPECT_EQ(e.speed, 2e4);
  EXPECT_DOUBLE_EQ(e.falling_factor(3, 0), 1);
  EXPECT_DOUBLE_EQ(0.3 * e.falling_factor(3, 1600), 0.15 + 0.15 / 4);
  const ContactProblem p =
      patch_on_grid(patch("polach_a = 0.4\npolach_b = 0.6\nspeed = 2e4\nxi = 1e-3")).problem;
  EXPECT_DOUBLE_EQ(p.falling_factor(0, 1000), 0.6 * std::exp(-0.6) + 0.4);
}

/// The second key of a law stays where a sweep gives the first one the value 0. Every law is said by both.
TEST(FrictionKeys, EachLawIsSaidByItsFirstKey) {
  for (const AskedLaw& law : friction_laws()) {
    const auto& [first, other] = law.numbers;
    const auto given = [&](const char* value) {
      return fmt::format("{} = {}\n{} = 0.5\nspeed = 1e4\nxi = 1e-3", first.name(), value, other.name());
    };
    EXPECT_THAT(refusal(fmt::format("{} = 0.2\nspeed = 1e4", first.name())), HasSubstr(law.give_both));
    EXPECT_THAT(patch(given("0")).unused, Contains(says(other.key)));
    const SceneFile scene = patch(given("0.2"));
    EXPECT_EQ(asked_law(scene.motion), &law);
    EXPECT_THAT(scene.unused, IsEmpty());
    const ContactProblem problem = patch_on_grid(scene).problem;
    EXPECT_EQ(problem.falling_factor(0, 0), 1) << first.key;
    EXPECT_LT(problem.falling_factor(0, 1e6), 0.9) << first.key;
  }
}

TEST(FrictionKeys, ATableHasALawForEachRow) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder / "falling_rows.csv";
  const auto with_table = [&](const std::string& text, const std::string& more = "") {
    std::ofstream(file) << text;
    return patch(more + "friction_table = '" + file.string() + "'\nspeed = 1e4\nxi = 0.05");
  };
  const SceneFile scene =
      with_table("s, mu, falling_friction, half_slip_velocity\n-1, 0.2, 0.1, 100\n1, 0.4, 0.4, 300\n");
  const ContactProblem problem = patch_on_grid(scene).problem;
  EXPECT_DOUBLE_EQ(problem.falling_factor(0, 100), 0.75);
  EXPECT_DOUBLE_EQ(problem.falling_factor(19, 100), 1);
  EXPECT_THAT(message_of([&] {
                patch_on_grid(with_table("s, mu, falling_friction, half_slip_velocity\n0, .2, .3, 9\n"));
              }),
              HasSubstr("0 < falling_friction <= mu"));
  EXPECT_THAT(message_of([&] {
                patch_on_grid(with_table("s, mu, falling_friction, half_slip_velocity\n0, .2, .1, 9\n",
                                         "polach_a = 0.4\npolach_b = 0.6\n"));
              }),
              HasSubstr("There are two laws of falling friction"));
  std::filesystem::remove(file);
}

TEST(FrictionKeys, WhatIsMissingOrTwiceIsRefused) {
  const std::string law = "falling_friction = 0.1\nhalf_slip_velocity = 800\n";
  EXPECT_THAT(refusal("falling_friction = 0.1\nspeed = 1e4"), HasSubstr("half_slip_velocity is not given"));
  EXPECT_THAT(refusal(law), HasSubstr("motion.speed, which is not given"));
  EXPECT_THAT(refusal(law + "kinetic_friction = 0.2\nspeed = 1e4"), HasSubstr("Give one law of friction."));
  EXPECT_THAT(refusal(law + "polach_a = 0.4\npolach_b = 1\nspeed = 1e4"),
              HasSubstr("Give one law of friction."));
  EXPECT_THAT(refusal("polach_a = 0.4\nspeed = 1e4"), HasSubstr("Polach's law has both A and B"));
  EXPECT_THAT(refusal(law + "speed = 1e4\nkind = 'shift'"), HasSubstr("a shift has no slip velocity"));
  EXPECT_THAT(refusal("falling_friction = 0.4\nhalf_slip_velocity = 800\nspeed = 1e4"),
              HasSubstr("friction in adhesion is only 0.3"));
  const std::string flash = "temperature.flash = true\n";
  EXPECT_THAT(refusal("", flash), HasSubstr("heat is proportional to the speed"));
  EXPECT_THAT(refusal("speed = 1e4\nkind = 'transient'\nsteps = 3", flash), HasSubstr("of steady rolling"));
  EXPECT_THAT(refusal("", "temperature.hot_friction = 0.1"), HasSubstr("Set temperature.flash = true."));
  EXPECT_THAT(refusal("speed = 1e4", flash + "temperature.hot_friction = 0.1"),
              HasSubstr("temperature.falls_to"));
  EXPECT_THAT(refusal("speed = 1e4", flash + "temperature.hot_friction = 0.5\ntemperature.falls_to = 300"),
              HasSubstr("friction is only 0.3"));
  EXPECT_THAT(patch("half_slip_velocity = 9\nxi = 1e-3").unused, Contains(says("half_slip_velocity")));
  EXPECT_THAT(patch("polach_b = 0.6\nxi = 1e-3").unused, Contains(says("polach_a is not given")));
  EXPECT_THAT(patch("xi = 1e-3", "temperature.rail_density = 7000").unused, Contains(says("rail_density")));
  EXPECT_THAT(patch("xi = 1e-3\nspeed = 1e4", flash).unused, IsEmpty());
}

TEST(FrictionKeys, TemperaturesAreInTheResult) {
  const std::string flash = "temperature.flash = true\ntemperature.rail = 20\ntemperature.wheel = 60\n";
  const SceneResult r = Sequence().solve(patch("speed = 2e4\nxi = 0.02", flash));
  ASSERT_TRUE(r.result.certified());
  const double hottest = quantity("Tmax_rail").value(r);
  EXPECT_GT(hottest, 100);
  EXPECT_NEAR(quantity("Tmax_wheel").value(r), hottest, 1e-9) << "where they touch they are equally hot";
  EXPECT_TRUE(std::isnan(quantity("Tmax_rail").value(Sequence().solve(patch("xi = 0.02")))));
  const SceneResult hot = Sequence().solve(patch(
      "speed = 2e4\nxi = 0.02",
      flash + "temperature.hot_friction = 0.15\ntemperature.falls_from = 40\ntemperature.falls_to = 90"));
  ASSERT_TRUE(hot.result.certified()) << hot.result.trust.solver_note;
  EXPECT_LT(hot.result.totals.Fx, 0.9 * r.result.totals.Fx);
  EXPECT_GT(hot.result.totals.Fx, 0.5 * r.result.totals.Fx);
  EXPECT_LT(quantity("Tmax_rail").value(hot), hottest);
}

/// A prescribed force that sliding as a whole carries too: 30 kN x 0.9 at 0.3 [0.5 + 0.5 2^(-w/1000)].
TEST(FrictionKeys, ASecondCreepageIsSaid) {
  const std::string law = "falling_friction = 0.15\nhalf_slip_velocity = 1000\nspeed = 1e4\n";
  const SceneResult r = Sequence().solve(patch(law, "load.force_x = 27000"));
  ASSERT_TRUE(r.result.certified()) << r.result.trust.solver_note;
  const double velocity = -1000 * std::log2((0.9 - 0.5) / 0.5);
  EXPECT_THAT(r.warnings.texts(), Contains(HasSubstr(fmt::format("at some {:.3g} (slip velocity {:.3g} mm/s)",
                                                                 velocity / 1e4, velocity))));
  const SceneResult there = Sequence().solve(patch(law + fmt::format("xi = {}", velocity / 1e4)));
  EXPECT_NEAR(there.result.totals.Fx, 27000, 100);
  EXPECT_THAT(Sequence().solve(patch(law, "load.force_x = 14000")).warnings.texts(), IsEmpty());
}

/// The slip velocity that a warning of a second creepage names, mm/s; 0: no warning does.
double velocity_said(const SceneResult& r) {
  for (const std::string& warning : r.warnings.texts())
    if (warning.find("two creepages") != std::string::npos)
      return std::stod(warning.substr(warning.find("(slip velocity ") + 15));
  return 0;
}

/// Where each row has a law of its own, and where friction falls with temperature alone or besides, the
/// second creepage is said, too. Solved with it, the contact has the prescribed force.
TEST(FrictionKeys, ASecondCreepageIsSaidOfRowsAndHeat) {
  const TemporaryFolder folder;
  const std::string rows = folder / "rows.csv";
  std::ofstream(rows)
      << "s, mu, falling_friction, half_slip_velocity\n-2, .25, .15, 500\n2, .35, .15, 2000\n";
  const std::string hot = "temperature.flash = true\ntemperature.hot_friction = 0.1\n"
                          "temperature.falls_from = 20\ntemperature.falls_to = 400\n",
                    of_rows = fmt::format("friction_table = '{}'\nspeed = 1e4\n", rows),
                    of_all = "falling_friction = 0.15\nhalf_slip_velocity = 1000\nspeed = 1e4\n";
  for (const auto& [motion, heat] : {std::pair{of_rows, std::string()}, std::pair{of_rows, hot},
                                     std::pair{std::string("speed = 1e4\n"), hot}, std::pair{of_all, hot}}) {
    const SceneResult r = Sequence().solve(patch(motion, "load.force_x = 26000\n" + heat));
    ASSERT_TRUE(r.result.certified()) << r.result.trust.solver_note;
    const double velocity = velocity_said(r);
    ASSERT_GT(velocity, 2e4 * r.result.totals.creepage_x) << motion << heat;
    const SceneResult there = Sequence().solve(patch(motion + fmt::format("xi = {}", velocity / 1e4), heat));
    ASSERT_TRUE(there.result.certified()) << there.result.trust.solver_note;
    EXPECT_NEAR(there.result.totals.Fx, 26000, 0.005 * 26000) << motion << heat;
  }
}

/// Friction that drops within 0.3 mm/s is nearly a jump.
TEST(FrictionKeys, ASecondSolutionIsSaid) {
  const SceneResult r =
      Sequence().solve(patch("falling_friction = 0.127\nhalf_slip_velocity = 0.3\nspeed = 1e4\nxi = 8e-4"));
  ASSERT_TRUE(r.result.certified()) << r.result.trust.solver_note;
  EXPECT_THAT(r.warnings.texts(),
              Contains(HasSubstr("this contact has two solutions: taken is the one that comes from "
                                 "adhesion (Fx")));
}

TEST(FrictionKeys, ASpeedInMetresIsSaid) {
  EXPECT_THAT(Sequence().solve(patch("speed = 30\nxi = 1e-3", "temperature.flash = true")).warnings.texts(),
              Contains(HasSubstr("motion.speed = 30 mm/s is below walking pace")));
  const SceneDescription d = Sequence().check(
      patch("speed = 3e4\nxi = 1e-3\npolach_a = 0.4\npolach_b = 0.6", "temperature.flash = true"));
  EXPECT_THAT(d.lines, Contains(HasSubstr("friction: 0.3, falls with the slip velocity, steady rolling")));
}

TEST(FrictionKeys, KineticFrictionDependsOnTheElements) {
  EXPECT_THAT(Sequence().solve(patch("kinetic_friction = 0.2\nxi = 2e-3")).warnings.texts(),
              Contains(HasSubstr("motion.kinetic_friction: friction that drops at once")));
}

} // namespace
