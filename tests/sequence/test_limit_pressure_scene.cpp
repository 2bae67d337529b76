#include "bem_contact/scene/steels.hpp"
#include "bem_contact/sequence/quantities.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "tests/base/message.hpp"

#include <cmath>
#include <fmt/format.h>
#include <gmock/gmock.h>

/// Scenes in which no pressure is larger than what steel bears.
namespace {

using namespace bem_contact;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

SceneFile pressed_patch(const std::string& more, double force = 2.5e5) {
  return parse_scene_file(fmt::format(
      "kind = 'patch'\nload.force = {}\nsolver.model = 'halfspace'\ngap = {{ a = 1.6e-3, b = 2.4e-3 }}\n"
      "grid = {{ dx = 0.5, ds = 0.5, mx = 40, ms = 36 }}\nmotion = {{ friction = 0.3, xi = 1e-3 }}\n{}",
      force, more));
}

TEST(LimitPressureScene, TheLowerOneActs) {
  const SceneResult elastic = Sequence().solve(pressed_patch(""));
  ASSERT_GT(elastic.result.totals.pmax, 2000);
  EXPECT_TRUE(std::isnan(quantity("indentation").value(elastic)));
  EXPECT_THAT(elastic.warnings.texts(), Contains(HasSubstr("rail.material.limit_pressure")));
  for (const char* limits : {"rail.material.limit_pressure = 1500\nwheel.material.limit_pressure = 1800",
                             "rail.material.limit_pressure = 1800\nwheel.material.limit_pressure = 1500",
                             "wheel.material.limit_pressure = 1500"}) {
    const SceneResult r = Sequence().solve(pressed_patch(limits));
    EXPECT_TRUE(certified(r)) << r.result.trust.solver_note;
    EXPECT_NEAR(r.result.totals.pmax, 1500, 1e-6) << limits;
    EXPECT_EQ(r.result.totals.pmax.error, 0) << limits;
    EXPECT_GT(r.result.totals.area, double(elastic.result.totals.area));
    EXPECT_GT(quantity("indentation").value(r), 0);
    EXPECT_NEAR(r.result.totals.Fz, 2.5e5, 1e-3);
    EXPECT_THAT(r.warnings.texts(), Not(Contains(HasSubstr("yield strength"))));
  }
}

TEST(LimitPressureScene, OfASteelIsItsHardness) {
  EXPECT_NEAR(steel_named("R260").indentation_pressure(), 2550, 1);
  const SceneResult r =
      Sequence().solve(pressed_patch("rail.material.steel = 'R200'\nwheel.material.steel = 'ER8'"));
  EXPECT_NEAR(r.problem.limit_pressure.value(), 1961, 1);
  EXPECT_THAT(message_of([] { Sequence().solve(pressed_patch("rail.material.steel = 'R620'")); }),
              HasSubstr("R260"));
  EXPECT_NEAR(Sequence()
                  .solve(pressed_patch("rail.material.steel = 'R200'\nrail.material.limit_pressure = 1700"))
                  .problem.limit_pressure.value(),
              1700, 1e-9);
}

/// Errors hold: results on elements a quarter as large lie within them.
TEST(LimitPressureScene, ErrorsHold) {
  const auto solved = [](int fine) {
    return Sequence().solve(parse_scene_file(fmt::format(
        "kind = 'patch'\nload.force = 2.5e5\nsolver.model = 'halfspace'\ngap = {{ a = 1.6e-3, b = 2.4e-3 }}\n"
        "grid = {{ dx = {0}, ds = {0}, mx = {1}, ms = {2} }}\nmotion = {{ friction = 0.3, xi = 1e-3 }}\n"
        "rail.material.limit_pressure = 1500",
        0.5 / fine, 40 * fine, 36 * fine)));
  };
  const SceneResult coarse = solved(1), fine = solved(4);
  EXPECT_NEAR(coarse.result.totals.area, fine.result.totals.area, coarse.result.totals.area.error);
  EXPECT_NEAR(coarse.result.totals.Fx, fine.result.totals.Fx, coarse.result.totals.Fx.error);
  EXPECT_NEAR(coarse.result.totals.approach, fine.result.totals.approach,
              coarse.result.totals.approach.error);
  EXPECT_EQ(fine.result.totals.pmax, 1500);
}

TEST(LimitPressureScene, OfAWheelOnARailInEveryModel) {
  for (const char* model : {"halfspace", "tangent_plane", "fem"}) {
    const auto scene = [&](const std::string& more) {
      return parse_scene_file(
          fmt::format("rail = {{ profile = '60E1', influence = '{0}/small_rail.h5'{2} }}\n"
                      "wheel = {{ profile = 'S1002', influence = '{0}/small_wheel.h5' }}\n"
                      "position.lateral = 6.6\nload.force = 1e5\nsolver.model = '{1}'\n"
                      "grid = {{ dx = 1.0, ds = 0.6 }}\nmotion = {{ eta = 1e-3, free_rolling = false }}\n",
                      CONFORMAL_SOURCE_DIR "/data/influence", model, more));
    };
    SCOPED_TRACE(model);
    const SceneResult elastic = Sequence().solve(scene("")),
                      above = Sequence().solve(scene(", material = { limit_pressure = 4000 }")),
                      limited = Sequence().solve(scene(", material = { limit_pressure = 1200 }"));
    EXPECT_NEAR(above.result.totals.approach, elastic.result.totals.approach, 1e-9);
    EXPECT_TRUE(certified(limited)) << limited.result.trust.solver_note;
    EXPECT_NEAR(limited.result.totals.pmax, 1200, 1e-6);
    EXPECT_GT(limited.result.totals.area, 1.05 * double(elastic.result.totals.area));
    EXPECT_NEAR(limited.result.totals.Fz, 1e5, 0.1);
    EXPECT_FALSE(limited.result.trust.touches_border);
  }
}

TEST(LimitPressureScene, ClosedFormsServeBelowItAlone) {
  const auto scene = [](const char* model, double limit) {
    return parse_scene_file(fmt::format(
        "kind = 'patch'\nload.force = 2.5e5\nsolver.model = '{}'\ngap = {{ a = 1.6e-3, b = 2.4e-3 }}\n"
        "grid = {{ dx = 0.5, ds = 0.5, mx = 40, ms = 36 }}\nmotion.{}\nrail.material.limit_pressure = {}",
        model, std::string(model) == "hertz" ? "frictionless = true" : "xi = 1e-3", limit));
  };
  for (const char* model : {"hertz", "simplified"}) {
    EXPECT_TRUE(certified(Sequence().solve(scene(model, 4000)))) << model;
    EXPECT_THAT(message_of([&] { Sequence().solve(scene(model, 1000)); }), Not(::testing::IsEmpty()))
        << model;
  }
}

} // namespace
