#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/sequence/quantities.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "tests/base/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

namespace {

using namespace bem_contact;

/// The head of 60E1 as points, lowered by `z` and scaled along z, in a file.
void write_head(const std::filesystem::path& file, double z, double scale = 1) {
  std::ofstream out(file);
  for (const CurvePoint& p : points_along(named_profile("60E1", ProfileKind::rail), 0.25))
    out << fmt::format("{:.12f} {:.12f}\n", p.position.y, scale * (p.position.z + z));
}

SceneResult certified_on(const std::filesystem::path& folder, const std::string& rail,
                         const std::string& more) {
  SceneFile scene = parse_scene_file(
      {"wheel.profile = 'S1002'\nrail.profile_z = 'down'\nrail.unit = 'mm'\nrail.place = 'absolute'\n"
       "rail.y = 753\ngrid = { dx = 0.6, ds = 0.4 }\n" +
           more + rail,
       "sections.toml"});
  scene.folder = folder;
  SceneResult out = Sequence().solve(scene);
  EXPECT_TRUE(certified(out)) << rail << more;
  return out;
}

double number(const SceneResult& r, const char* name) {
  return quantity(name).value(r);
}

const char* const nose =
    "position.along = 300\n"
    "rail.sections = [ { at = 0, profile = 'a.txt' }, { at = 1000, profile = 'b.txt' } ]\n";

/// Sections that are all equal are the profile, yawed and with friction too: then within what the iterations
/// leave.
TEST(ContactOnSections, ThatAreEqualIsThatOfTheProfile) {
  for (const char* model : {"halfspace", "tangent_plane"}) {
    const auto solved = [&](const char* along, const char* rail, const char* motion) {
      return Sequence().solve(parse_scene_file(
          {fmt::format("wheel.profile = 'S1002'\nload.force = 80000\ngrid = {{ dx = 0.9, ds = 0.6 }}\n"
                       "position = {{ rail_inclination = 0.025, lateral = 2, yaw = 0.003{} }}\n"
                       "solver.model = '{}'\nmotion = {{ {} }}\n{}",
                       along, model, motion, rail),
           "equal.toml"}));
    };
    for (const auto& [motion, tolerance] : {std::pair{"frictionless = true", 1e-9},
                                            {"friction = 0.3, xi = 5e-4, rolling_radius = 460", 1e-7}}) {
      const SceneResult one = solved("", "rail.profile = '60E1'\n", motion),
                        three = solved(", along = 30",
                                       "rail.sections = [ { at = 0, profile = '60E1' }, { at = 70, profile = "
                                       "'60E1' }, { at = 100, profile = '60E1' } ]\n",
                                       motion);
      ASSERT_TRUE(certified(one) && certified(three));
      for (const char* name : {"pmax", "area", "Fx", "Fy", "Fz", "approach", "vertical"})
        EXPECT_NEAR(number(three, name), number(one, name), tolerance * (1 + std::abs(number(one, name))))
            << name;
      EXPECT_NEAR(number(three, "Fx_slope"), 0, 1e-4);
    }
  }
}

/// The same of a wheel, yawed too: where it is nearest, how sharply it curves there and how its centre moves
/// are those of a round wheel and what unevenness adds to them.
TEST(ContactOnSections, OfAWheelThatAreEqualIsThatOfTheWheel) {
  const auto solved = [](const char* wheel, const char* motion, double lateral, double yaw) {
    return Sequence().solve(parse_scene_file(
        {fmt::format("rail.profile = '60E1'\nload.force = 80000\ngrid = {{ dx = 0.9, ds = 0.6 }}\n"
                     "position = {{ lateral = {}, yaw = {} }}\nsolver.model = 'halfspace'\n"
                     "motion = {{ {} }}\n{}",
                     lateral, yaw, motion, wheel),
         "round.toml"}));
  };
  for (const char* motion : {"frictionless = true", "friction = 0.3, xi = 5e-4, rolling_radius = 460"})
    for (const double lateral : {0.0, 3.0, 6.0})
      for (const double yaw : {0.0, 0.003, 0.02}) {
        const SceneResult one = solved("wheel.profile = 'S1002'\n", motion, lateral, yaw),
                          three = solved("wheel.sections = [ { at = 0, profile = 'S1002' }, { at = 2, "
                                         "profile = 'S1002' }, { at = 4, profile = 'S1002' } ]\n",
                                         motion, lateral, yaw);
        for (const char* name : {"vertical", "approach", "pmax", "area", "Fx", "Fy", "Fz"})
          EXPECT_NEAR(number(three, name), number(one, name), 1e-8 * (1 + std::abs(number(one, name))))
              << name << " " << motion << " " << lateral << " " << yaw;
      }
}

/// A rail that leads to the side is the same rail under a wheelset that is turned the other way: across the
/// rail its section is narrower by the cosine.
TEST(ContactOnSections, ThatLeadToTheSideAreTheYawedProfile) {
  const TemporaryFolder folder;
  constexpr double slope = 0.02, at = 753;
  const double angle = std::atan(slope), cosine = std::cos(angle);
  const auto write = [&](const char* name, double scale, double aside) {
    std::ofstream out(folder.path() / name);
    for (const CurvePoint& p : points_along(named_profile("60E1", ProfileKind::rail), 0.25))
      out << fmt::format("{:.12f} {:.12f}\n", scale * p.position.y + aside, p.position.z);
  };
  write("a.txt", 1, -300 * slope);
  write("b.txt", 1, 0);
  write("c.txt", 1, 500 * slope);
  write("across.txt", cosine, 0);
  for (const double lateral : {0.0, 4.0}) {
    const std::string load = "load.force = 80000\nmotion.frictionless = true\nsolver.model = 'halfspace'\n";
    const SceneResult aside = certified_on(
        folder.path(),
        fmt::format("position.lateral = {}\n"
                    "rail.sections = [ {{ at = -300, profile = 'a.txt' }}, {{ at = 0, profile = 'b.txt' }}, "
                    "{{ at = 500, profile = 'c.txt' }} ]\n",
                    lateral),
        load);
    SceneFile turned = parse_scene_file(
        {load +
             fmt::format("wheel.profile = 'S1002'\nrail.profile_z = 'down'\nrail.unit = 'mm'\n"
                         "rail.place = 'absolute'\nrail.y = {:.12f}\ngrid = {{ dx = 0.6, ds = 0.4 }}\n"
                         "position = {{ lateral = {:.12f}, yaw = {:.15f} }}\nrail.profile = 'across.txt'\n",
                         cosine * at, cosine * lateral, -angle),
         "turned.toml"});
    turned.folder = folder.path();
    const SceneResult yawed = Sequence().solve(turned);
    // Elements lie along the rail both times, but their rows and columns begin elsewhere.
    EXPECT_NEAR(number(aside, "vertical"), number(yawed, "vertical"), 1e-4) << lateral;
    EXPECT_NEAR(number(aside, "approach"), number(yawed, "approach"), 1e-4) << lateral;
    EXPECT_NEAR(number(aside, "pmax"), number(yawed, "pmax"), 0.01 * number(yawed, "pmax")) << lateral;
    EXPECT_NEAR(number(aside, "area"), number(yawed, "area"), 0.02 * number(yawed, "area")) << lateral;
  }
}

/// Without friction the wheel presses a nose that rises 1:10 along the normal of its surface, and the same
/// nose turned to the horizontal has the same pressures.
TEST(ContactOnSections, OfARisingNoseIsThatOfTheNoseTurnedLevel) {
  const TemporaryFolder folder;
  const double cosine = 1 / std::sqrt(1.01);
  write_head(folder.path() / "a.txt", 0);
  write_head(folder.path() / "b.txt", -100);
  write_head(folder.path() / "level.txt", 0, cosine);
  const std::string free = "motion.frictionless = true\nsolver.model = 'halfspace'\n";
  const SceneResult rising = certified_on(folder.path(), nose, free + "load.force = 10000\n"),
                    level = certified_on(folder.path(), "rail.profile = 'level.txt'\n",
                                         free + fmt::format("load.force = {:.12f}\n", 10000 / cosine));
  EXPECT_NEAR(number(rising, "Fz"), 10000, 1e-4);
  EXPECT_NEAR(number(rising, "Fx_slope") / number(rising, "Fz"), 0.1, 1e-6);
  EXPECT_NEAR(number(rising, "pmax"), number(level, "pmax"), 1e-5 * number(level, "pmax"));
  // Elements lie along the rail, turned by 0.1 degrees against those on the level: one more is at the edge.
  EXPECT_NEAR(number(rising, "area"), number(level, "area"), 1.01 * 0.6 * 0.4);
  // The centre of the axle stands above the ramp by the radius over the cosine.
  EXPECT_NEAR(number(rising, "vertical") - number(level, "vertical"), -30 - 460 * (1 / cosine - 1), 0.1);
}

/// The same wherever the wheel touches it and however it is yawed: seen along the ramp the nose is a prism.
TEST(ContactOnSections, OfARisingNoseIsAlongItsNormalOnTheGaugeCornerToo) {
  const TemporaryFolder folder;
  write_head(folder.path() / "a.txt", 0);
  for (const double rise : {0.1, 0.2, 0.3}) {
    write_head(folder.path() / "b.txt", -1000 * rise);
    for (const double lateral : {3.0, 5.0, 6.0})
      for (const double yaw : {0.0, 0.01, -0.02}) {
        const SceneResult r = certified_on(
            folder.path(), nose,
            fmt::format("motion.frictionless = true\nsolver.model = 'tangent_plane'\nload.force = 80000\n"
                        "position.lateral = {}\nposition.yaw = {}\n",
                        lateral, yaw));
        EXPECT_NEAR(number(r, "Fx_slope") / number(r, "Fz"), rise, 1e-12) << lateral << " " << yaw;
      }
  }
}

/// An error about a section's profile names the section.
TEST(ContactOnSections, NameTheSectionThatIsWrong) {
  try {
    Sequence().solve(parse_scene_file({"wheel.profile = 'S1002'\nload.force = 80000\nrail.sections = [ { at "
                                       "= 0, profile = '60E1' }, { at = "
                                       "50, profile = 'S1002' } ]\n",
                                       "wrong.toml"}));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(
        std::string(error.what()).find("Section 2 of the rail, at 50 mm: S1002 is the profile of a wheel"),
        0u)
        << error.what();
  }
}

/// On the other side of the track all is mirrored: what is along x and z stays, y counts to the side.
TEST(ContactOnSections, MirrorsFromRightToLeft) {
  const TemporaryFolder folder;
  write_head(folder.path() / "a.txt", 0);
  write_head(folder.path() / "b.txt", -100);
  const std::string rolling = "motion = { friction = 0.3, xi = 1e-3 }\nload.force = 10000\n"
                              "solver.model = 'halfspace'\n";
  const SceneResult right = certified_on(folder.path(), nose,
                                         rolling + "position.lateral = 1\nposition.yaw = 0.002\n"),
                    left = certified_on(
                        folder.path(), nose,
                        rolling + "position.side = 'left'\nposition.lateral = -1\nposition.yaw = -0.002\n");
  for (const char* name : {"pmax", "area", "Fx", "Fy", "Fz", "vertical", "Fx_slope"})
    EXPECT_NEAR(number(right, name), number(left, name), 1e-7 * (1 + std::abs(number(right, name)))) << name;
}

/// With friction the vertical force is made of pressure and of shear tractions along the ramp; a wheel that
/// turns as on the level brakes there.
TEST(ContactOnSections, BearsTheLoadWithFrictionToo) {
  const TemporaryFolder folder;
  write_head(folder.path() / "a.txt", 0);
  write_head(folder.path() / "b.txt", -100);
  const double cosine = 1 / std::sqrt(1.01);
  write_head(folder.path() / "level.txt", 0, cosine);
  const std::string friction = "load.force = 10000\nsolver.model = 'halfspace'\nmotion.friction = 0.3\n";
  const SceneResult free = certified_on(folder.path(), nose, friction),
                    turned = certified_on(folder.path(), "rail.profile = 'level.txt'\n",
                                          fmt::format("load.force = {:.12f}\nsolver.model = 'halfspace'\n"
                                                      "motion.friction = 0.3\n",
                                                      10000 / cosine)),
                    level = certified_on(folder.path(), nose, friction + "motion.rolling_radius = 460\n");
  for (const SceneResult* r : {&free, &level})
    EXPECT_NEAR(number(*r, "Fz"), 10000, 0.01);
  // Creep forces of the spin, on few elements that are turned by 0.1 degrees: within 1 % of friction.
  for (const char* name : {"Fx", "Fy"})
    EXPECT_NEAR(number(free, name), number(turned, name), 0.01 * 0.3 * 10000) << name;
  EXPECT_GT(number(level, "Fx"), 1000);
  const double along_normal = std::hypot(number(free, "Fz"), number(free, "Fx_slope"));
  EXPECT_NEAR(along_normal, 10000 * std::sqrt(1.01), 20);
}

/// A rail that is bent to a circle by its sections is a roller: to first order in the size of the contact.
TEST(ContactOnSections, OfACircleAlongXIsThatOfARoller) {
  const TemporaryFolder folder;
  std::string rail = "rail.sections = [";
  for (int i = -4; i <= 4; ++i) {
    const double u = 15.0 * i, lower = 500 - std::sqrt(500 * 500 - u * u);
    write_head(folder.path() / fmt::format("{}.txt", i), lower);
    rail += fmt::format("{{ at = {}, profile = '{}.txt' }}, ", u, i);
  }
  write_head(folder.path() / "roller.txt", 0);
  const std::string free = "motion.frictionless = true\nsolver.model = 'halfspace'\nload.force = 10000\n";
  const SceneResult sections = certified_on(folder.path(), rail + "]\n", free),
                    roller = certified_on(folder.path(),
                                          "rail.profile = 'roller.txt'\nrail.roller_radius = 500\n", free),
                    straight = certified_on(folder.path(), "rail.profile = 'roller.txt'\n", free);
  EXPECT_NEAR(number(sections, "pmax"), number(roller, "pmax"), 1e-3 * number(roller, "pmax"));
  EXPECT_GT(number(roller, "pmax"), 1.05 * number(straight, "pmax"));
}

} // namespace
