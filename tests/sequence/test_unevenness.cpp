#include "bem_contact/sequence/quantities.hpp"
#include "bem_contact/sequence/sequence.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace bem_contact;

SceneFile scene(const std::string& more) {
  return parse_scene_file(
      {"rail.profile = '60E1'\nwheel.profile = 'S1002'\nposition.rail_inclination = 0.025\n"
       "load.force = 10000\n" +
           std::string(more.find("grid") == std::string::npos ? "grid = { dx = 0.6, ds = 0.4 }\n" : "") +
           more,
       "uneven.toml"});
}

SceneResult certified_at(const std::string& more) {
  SceneResult out = Sequence().solve(scene(more));
  EXPECT_TRUE(certified(out)) << more;
  return out;
}

double number(const SceneResult& r, const char* name) {
  return quantity(name).value(r);
}

void expect_same(const SceneResult& a, const SceneResult& b, double tolerance) {
  for (const char* name : {"pmax", "area", "Fz", "approach", "vertical"})
    EXPECT_NEAR(number(a, name), number(b, name), tolerance * (1 + std::abs(number(b, name)))) << name;
}

/// A wave that is too small to be seen is no wave: what uneven bodies go through gives the round wheel,
/// shear forces within what the iterations leave.
TEST(UnevenContact, WithoutDepthIsThatOfARoundWheel) {
  for (const char* model : {"halfspace", "tangent_plane"}) {
    const std::string rolling = fmt::format(
        "solver.model = '{}'\nmotion = {{ friction = 0.3, xi = 5e-4, rolling_radius = 460 }}\n", model);
    const SceneResult round = certified_at(rolling),
                      wave =
                          certified_at(rolling + "wheel.polygon = { orders = [2], amplitudes = [1e-14] }\n"),
                      joint = certified_at(rolling + "rail.joint = { dip = 1e-14 }\n");
    expect_same(wave, round, 1e-9);
    expect_same(joint, round, 1e-9);
    EXPECT_NEAR(number(wave, "Fx"), number(round, "Fx"), 1e-7 * number(round, "Fx"));
    EXPECT_NEAR(number(joint, "Fx"), number(round, "Fx"), 1e-7 * number(round, "Fx"));
  }
}

/// Both sides of a flat give the same, and it bears on a longer and wider area than a round wheel.
TEST(UnevenContact, OnAFlatIsSymmetricAboutItsMiddle) {
  const std::string flat = "motion.frictionless = true\nsolver.model = 'halfspace'\n"
                           "wheel.flat = { depth = 0.9, rounding = 10, angle = ";
  const SceneResult round = certified_at("motion.frictionless = true\nsolver.model = 'halfspace'\n");
  for (const double angle : {0.02, 0.05}) {
    const SceneResult before = certified_at(flat + fmt::format("{} }}\n", -angle)),
                      after = certified_at(flat + fmt::format("{} }}\n", angle));
    expect_same(before, after, 1e-6);
    EXPECT_NEAR(before.result.patches.front().x, -after.result.patches.front().x, 1e-6);
    EXPECT_GT(std::abs(after.result.patches.front().x), 1);
    EXPECT_GT(number(after, "pmax"), number(round, "pmax")); // on the rounded edge
  }
  const SceneResult middle = certified_at(flat + "0 }\n");
  EXPECT_NEAR(middle.result.patches.front().x, 0, 1e-6);
  EXPECT_LT(number(middle, "pmax"), number(round, "pmax"));
  const auto rigid = [](const SceneResult& r) { return number(r, "vertical") - number(r, "approach"); };
  // The chord is that of the tape circle, and the circle of the contact is smaller or larger by its height.
  EXPECT_NEAR(rigid(middle) - rigid(round), 0.9, 2e-3);
}

/// While the wheel rolls over the rounded edge of its flat the largest pressure changes smoothly: what is
/// ragged on large elements is gone on smaller ones, and within what those state.
TEST(UnevenContact, OverTheEdgeOfAFlatIsSmoothOnSmallElements) {
  const auto pressures = [](const char* grid) {
    std::vector<Measured> out;
    for (int along = -24; along <= -8; along += 2)
      out.push_back(certified_at(fmt::format("grid = {{ {} }}\nmotion.frictionless = true\nsolver.model = "
                                             "'halfspace'\nposition.along = {}\n"
                                             "wheel.flat = {{ depth = 0.9, rounding = 10 }}\n",
                                             grid, along))
                        .result.totals.pmax);
    return out;
  };
  const auto raggedness = [](const std::vector<Measured>& p) {
    double most = 0;
    for (std::size_t i = 1; i + 1 < p.size(); ++i)
      most = std::max(most, std::abs(p[i - 1] - 2 * p[i] + p[i + 1]));
    return most;
  };
  const std::vector<Measured> large = pressures("dx = 0.8, ds = 0.4"),
                              small = pressures("dx = 0.4, ds = 0.2"),
                              smaller = pressures("dx = 0.25, ds = 0.125");
  EXPECT_GT(raggedness(large), 3 * raggedness(small));
  EXPECT_LT(raggedness(small), 0.02 * small.front());
  for (std::size_t i = 0; i < small.size(); ++i)
    EXPECT_NEAR(small[i], smaller[i], small[i].error) << i;
}

/// The centre of a wheel on a dip lies lower by the dip, and on its slope the rail is pushed back.
TEST(UnevenContact, OnADipPushesTheRailAlongIt) {
  const std::string joint =
      "motion.frictionless = true\nrail.joint = { at = 200, dip = 3, dip_length = 800 }\n";
  const SceneResult level = certified_at("motion.frictionless = true\n"), down = certified_at(joint);
  const double slope = 4 * 3 / 800.0 * 0.5; // half of the way down
  EXPECT_NEAR(number(down, "vertical") - number(level, "vertical"), 0.75 - 0.5 * 460 * slope * slope, 1e-3);
  EXPECT_NEAR(number(down, "Fx_slope") / number(down, "Fz"), -slope, 0.03 * slope);
  EXPECT_TRUE(std::isnan(number(level, "Fx_slope")));
}

/// As a wheel comes to the gap of a joint, stands on both edges and leaves it, every place is certified.
TEST(UnevenContact, OverAGapIsCertifiedEverywhere) {
  for (const double along : {-5.0, -2.0, 0.0, 3.0})
    certified_at(fmt::format("motion.frictionless = true\nsolver.model = 'halfspace'\n"
                             "rail.joint = {{ gap = 8, rounding = 5 }}\nposition.along = {}\n",
                             along));
}

/// On both edges of a gap the wheel rolls with the radius of the places that it touches, and not with that of
/// the middle between them, where no rail is.
TEST(UnevenContact, OverAGapRollsWithTheRadiusOfBothEdges) {
  for (const double along : {96.0, 100.0, 104.0}) {
    const SceneResult r = certified_at(
        fmt::format("motion = {{ friction = 0.3, xi = 0 }}\nsolver.model = 'halfspace'\nposition.along = {}\n"
                    "rail.joint = {{ at = 100, gap = 8, step = -0.05, rounding = 5 }}\n",
                    along));
    EXPECT_NEAR(r.motion.rolling.radius, r.motion.contact_radius, 0.05) << along;
    EXPECT_NEAR(r.motion.contact_radius, 460, 0.5) << along;
  }
}

} // namespace
