#include "bem_contact/sequence/quantities.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "tests/base/message.hpp"
#include "tests/base/temporary_folder.hpp"
#include "tests/sanitized.hpp"

#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gmock/gmock.h>
#include <numbers>

/// Scenes with a layer between the surfaces: keys, the slope, and everything that follows from a solution.
namespace {

using namespace bem_contact;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

SceneFile layer_patch(const std::string& layer, const std::string& motion = "xi = 1e-3",
                      const std::string& grid = "dx = 0.5\nds = 0.5\nmx = 28\nms = 22") {
  return parse_scene_file("kind = 'patch'\nload.force = 5e4\nsolver.model = 'halfspace'\n[layer]\n" + layer +
                          "\n[motion]\nfriction = 0.3\n" + motion + "\n[grid]\n" + grid +
                          "\n[gap]\na = 8e-4\nb = 1.2e-3\n");
}
SceneResult solved_with_layer(const SceneFile& scene) {
  SceneResult r = Sequence().solve(scene);
  EXPECT_TRUE(certified(r)) << r.result.trust.solver_note;
  return r;
}
std::string layer_refusal(const std::string& layer, const std::string& motion = "xi = 1e-3") {
  return message_of([&] { solved_with_layer(layer_patch(layer, motion)); });
}

TEST(LayerScene, OneComplianceIsWrittenInThreeWays) {
  const TemporaryFolder folder;
  std::ofstream(folder / "layer.csv") << "s, compliance\n-3, 2e-5\n3, 2e-5\n";
  const SceneResult given = solved_with_layer(layer_patch("compliance = 2e-5"));
  EXPECT_EQ(quantity("layer_compliance").value(given), 2e-5);
  for (const std::string& other : {std::string("shear_modulus = 500\nthickness = 0.01"),
                                   "table = '" + (folder / "layer.csv").string() + "'"}) {
    const SceneResult r = solved_with_layer(layer_patch(other));
    EXPECT_NEAR(r.result.totals.Fx, given.result.totals.Fx, 1e-9 * given.result.totals.Fx) << other;
    EXPECT_NEAR(quantity("layer_compliance").value(r), 2e-5, 1e-20);
  }
  const SceneResult none = solved_with_layer(layer_patch("compliance = 0"));
  EXPECT_TRUE(std::isnan(quantity("layer_compliance").value(none)));
  EXPECT_EQ(none.result.totals.Fx, solved_with_layer(layer_patch("")).result.totals.Fx);
  EXPECT_LT(given.result.totals.Fx, 0.97 * none.result.totals.Fx);
  EXPECT_EQ(given.result.pn, none.result.pn);
}

TEST(LayerScene, ATableIsLinearAlongS) {
  const TemporaryFolder folder;
  const auto with = [&](const std::string& rows) {
    std::ofstream(folder / "layer.csv") << "s, compliance\n" << rows;
    return layer_patch("table = '" + (folder / "layer.csv").string() + "'");
  };
  const SceneResult r = solved_with_layer(with("-2, 0\n2, 4e-5\n"));
  EXPECT_DOUBLE_EQ(r.layer.shear.front(), 0);
  EXPECT_DOUBLE_EQ(r.layer.shear.back(), 4e-5);
  EXPECT_NEAR(r.layer.shear[11], 4e-5 * (0.25 + 2) / 4, 1e-12);
  EXPECT_TRUE(std::isnan(quantity("layer_compliance").value(r)));
  // Half of it lies between none and all of it.
  EXPECT_LT(r.result.totals.Fx, solved_with_layer(layer_patch("")).result.totals.Fx);
  EXPECT_GT(r.result.totals.Fx, solved_with_layer(layer_patch("compliance = 4e-5")).result.totals.Fx);
  EXPECT_THAT(message_of([&] { solved_with_layer(with("0, 1e-5\n0, 1e-5\n")); }), HasSubstr("ascending s"));
  EXPECT_THAT(message_of([&] { solved_with_layer(with("0, -1e-5\n")); }), HasSubstr("compliance >= 0"));
}

TEST(LayerScene, TwoOfThemAreRefused) {
  EXPECT_THAT(layer_refusal("compliance = 1e-5\nslope = 0.6"), HasSubstr("layer.compliance is given too"));
  EXPECT_THAT(layer_refusal("compliance = 1e-5\nshear_modulus = 500\nthickness = 0.01"),
              HasSubstr("given too"));
  EXPECT_THAT(layer_refusal("slope = 0.6\ntable = 'a.csv'"), HasSubstr("given too"));
  EXPECT_THAT(layer_refusal("shear_modulus = 500"), HasSubstr("layer.thickness is not given"));
  EXPECT_THAT(layer_refusal("thickness = 0.01"), HasSubstr("layer.shear_modulus is not given"));
  EXPECT_THAT(layer_refusal("compliance = -1e-5"), HasSubstr("layer.compliance"));
  EXPECT_THAT(layer_refusal("slope = 1.5"), HasSubstr("layer.slope"));
  EXPECT_THAT(layer_refusal("slope = 0.6", "frictionless = true"), HasSubstr("there is no shear force"));
  EXPECT_THAT(layer_refusal("slope = 0.6", "kind = 'transient'\nsteps = 3"),
              HasSubstr("slope of steady rolling"));
  EXPECT_THAT(layer_refusal("slope = 0.6", "kind = 'shift'"), HasSubstr("slope of steady rolling"));
  SceneFile scene = layer_patch("compliance = 1e-5", "frictionless = true");
  EXPECT_THAT(scene.unused, Contains(testing::Field(&Warning::text, HasSubstr("layer.compliance"))));
  EXPECT_THAT(layer_patch("compliance = 1e-5").unused, IsEmpty());
  EXPECT_THAT(message_of([] {
                parse_scene_file(
                    "kind = 'patch'\nload.force = 1e4\nsolver.model = 'hertz'\nmotion.frictionless = "
                    "true\nlayer.normal_compliance = 1e-5\ngrid.mx = 20\ngrid.ms = 20\n");
              }),
              HasSubstr("layer.normal_compliance"));
}

/// dFx/dxi of so small a creepage that nothing slips.
double slope_with(const std::string& layer, const std::string& grid) {
  return solved_with_layer(layer_patch(layer, "xi = 1e-9", grid)).result.totals.Fx / 1e-9;
}

TEST(LayerScene, TheSlopeIsMet) {
  const std::string grid = "dx = 0.25\nds = 0.25\nmx = 56\nms = 44", motion = "xi = 1e-3";
  const double clean = slope_with("", grid);
  for (const double share : {0.9, 0.6, 0.2}) {
    const SceneResult r = solved_with_layer(layer_patch(fmt::format("slope = {}", share), motion, grid));
    const double found = quantity("layer_compliance").value(r);
    const std::string so_much = fmt::format("compliance = {:.17g}", found);
    EXPECT_NEAR(solved_with_layer(layer_patch(so_much, motion, grid)).result.totals.Fx, r.result.totals.Fx,
                1e-9 * r.result.totals.Fx);
    EXPECT_NEAR(slope_with(so_much, grid) / clean, share, 1e-3) << found;
    // 1 / (1/C + 1/C_layer) with the layer's own slope between rigid bodies, 8 a^2 b / (3 L). A check: it is
    // exact nowhere in rolling.
    const PatchSummary& p = r.result.patches.front();
    const double layer = 8 * p.semi_axis_a * p.semi_axis_a * p.semi_axis_b / (3 * found);
    EXPECT_NEAR(1 / (1 / clean + 1 / layer) / (share * clean), 1, 0.04) << share;
  }
  EXPECT_EQ(solved_with_layer(layer_patch("slope = 1")).result.totals.Fx,
            solved_with_layer(layer_patch("")).result.totals.Fx);
}

/// Pressure on a layer alone, between bodies that are stiff beside it, is that of an elastic foundation
/// (Winkler): p = (q - h) / L, F = pi q^2 / (2 L sqrt(A B)), and the contact is where the bodies would
/// overlap.
TEST(LayerScene, PressureOnASoftLayerIsThatOfAFoundation) {
  const double compliance = 1e-2, a = 8e-4, b = 1.2e-3, force = 2000;
  const SceneResult r = solved_with_layer(parse_scene_file(
      fmt::format("kind = 'patch'\nload.force = {}\nsolver.model = 'halfspace'\nmotion.frictionless = true\n"
                  "layer.normal_compliance = {}\ngrid = {{ dx = 0.4, ds = 0.4, mx = 60, ms = 60 }}\ngap = {{ "
                  "a = {}, b = {} }}\n"
                  "rail.material.young = 2e8\nwheel.material.young = 2e8\n",
                  force, compliance, a, b)));
  const double q = std::sqrt(2 * force * compliance * std::sqrt(a * b) / std::numbers::pi);
  EXPECT_NEAR(r.result.totals.approach, q, 2e-3 * q);
  EXPECT_NEAR(r.result.totals.pmax, q / compliance, 5e-3 * q / compliance);
  EXPECT_NEAR(r.result.totals.area, std::numbers::pi * q / std::sqrt(a * b),
              0.02 * std::numbers::pi * q / std::sqrt(a * b));
  EXPECT_EQ(quantity("layer_normal_compliance").value(r), compliance);
}

/// The estimate of a wheel on a rail, by which the grid is planned, knows the layer: nothing has to grow far.
TEST(LayerScene, TheEstimateKnowsALayerUnderPressure) {
  for (const double compliance : {1e-6, 1e-5, 1e-4}) {
    const SceneResult r = solved_with_layer(parse_scene_file(fmt::format(
        "rail.profile = '60E1'\nwheel.profile = 'S1002'\nload.force = 5e4\nmotion.frictionless = true\n"
        "grid.elements = 400\nlayer.normal_compliance = {}\n",
        compliance)));
    EXPECT_EQ(r.choice.model, Model::halfspace);
    EXPECT_FALSE(r.result.trust.touches_border);
    const int contact = count_elements(r.result).contact;
    EXPECT_GT(contact, 250) << compliance;
    EXPECT_LT(contact, 800) << compliance;
  }
}

TEST(LayerScene, OfAWheelOnARailInEveryModel) {
  for (const char* model : {"halfspace", "tangent_plane", "fem"})
    for (const char* lateral : {"0", "6.6"}) {
      if (std::string(model) == "fem" && std::string(lateral) == "0")
        continue; // beyond the strips
      const auto scene = [&](const std::string& more) {
        return parse_scene_file(
            fmt::format("rail = {{ profile = '60E1', influence = '{0}/small_rail.h5' }}\n"
                        "wheel = {{ profile = 'S1002', influence = '{0}/small_wheel.h5' }}\n"
                        "position.lateral = {1}\nload.force = 1e5\nsolver.model = '{2}'\n"
                        "grid = {{ dx = 1.0, ds = 0.6 }}\nmotion.eta = 1e-3\n{3}",
                        CONFORMAL_SOURCE_DIR "/data/influence", lateral, model, more));
      };
      const SceneResult clean = solved_with_layer(scene("")),
                        layer = solved_with_layer(scene("layer.compliance = 3e-5\n")),
                        slope = solved_with_layer(scene("layer.slope = 0.6\n"));
      SCOPED_TRACE(std::string(model) + " " + lateral);
      ASSERT_TRUE(layer.motion.free_rolling && slope.motion.free_rolling);
      EXPECT_GT(quantity("layer_compliance").value(slope), 0);
      EXPECT_TRUE(layer.result.trust.discretisation && slope.result.trust.discretisation);
      EXPECT_NE(layer.result.totals.Fs, clean.result.totals.Fs);
      // A sequence, which keeps influence numbers, gives them back without the layer.
      Sequence one;
      EXPECT_NEAR(one.solve(scene("layer.compliance = 3e-5\n")).result.totals.Fs, layer.result.totals.Fs,
                  1e-5 * std::abs(layer.result.totals.Fs));
      EXPECT_NEAR(one.solve(scene("")).result.totals.Fs, clean.result.totals.Fs,
                  1e-5 * std::abs(clean.result.totals.Fs));
      EXPECT_NEAR(one.solve(scene("layer.slope = 0.6\n")).result.totals.Fs, slope.result.totals.Fs,
                  1e-5 * std::abs(slope.result.totals.Fs));
    }
}

/// Free rolling with a layer is the creepage of no longitudinal force with it.
TEST(LayerScene, FreeRollingHasTheLayerToo) {
  const std::string scene =
      "rail.profile = '60E1'\nwheel.profile = 'S1002'\nposition.lateral = 6.6\nload.force = 1e5\n"
      "solver.model = 'halfspace'\ngrid = { dx = 1.0, ds = 0.6 }\nlayer.compliance = 1e-4\n";
  const SceneResult asked = solved_with_layer(parse_scene_file(scene)),
                    prescribed = solved_with_layer(parse_scene_file(scene + "load.force_x = 0\n"));
  EXPECT_NEAR(asked.motion.free_rolling->xi, prescribed.motion.xi, 0.1 * asked.motion.free_rolling->xi.error);
}

TEST(LayerScene, HistoriesTendToSteadyRolling) {
  const std::string grid = "dx = 1\nds = 1\nmx = 14\nms = 11", shift = "xi = 2e-3\nkind = 'shift'\nsteps = 2";
  const double steady =
      solved_with_layer(layer_patch("compliance = 5e-5", "xi = 1e-3", grid)).result.totals.Fx;
  const SceneResult rolled =
      solved_with_layer(layer_patch("compliance = 5e-5", "xi = 1e-3\nkind = 'transient'\nsteps = 80", grid));
  EXPECT_NEAR(rolled.result.totals.Fx, steady, 1e-5 * steady);
  EXPECT_LT(solved_with_layer(layer_patch("compliance = 5e-5", shift, grid)).result.totals.Fx,
            solved_with_layer(layer_patch("", shift, grid)).result.totals.Fx);
}

/// A table makes each row's numbers its own, which another path of the solver serves: with one value in every
/// row it says the same, of a history too, and with influence files whose structures move.
TEST(LayerScene, ATableOfOneValueIsThatComplianceInEveryMotion) {
  const TemporaryFolder folder;
  std::ofstream(folder / "layer.csv") << "s, compliance\n-3, 3e-5\n3, 3e-5\n";
  const std::string table = "table = '" + (folder / "layer.csv").string() + "'\n",
                    one = "compliance = 3e-5\n";
  const std::string grid = "dx = 1\nds = 1\nmx = 14\nms = 11";
  for (const char* motion :
       {"xi = 1e-3\nkind = 'transient'\nsteps = 6", "xi = 2e-3\nkind = 'shift'\nsteps = 2"}) {
    const SceneResult given = solved_with_layer(layer_patch(one, motion, grid)),
                      by_row = solved_with_layer(layer_patch(table, motion, grid));
    EXPECT_NEAR(by_row.result.totals.Fx, given.result.totals.Fx, 1e-7 * std::abs(given.result.totals.Fx))
        << motion;
  }
  const auto gauge_corner = [&](const std::string& layer, const std::string& structural) {
    return solved_with_layer(parse_scene_file(
        fmt::format("rail = {{ profile = '60E1', influence = '{0}/small_rail.h5', structural = '{1}' }}\n"
                    "wheel = {{ profile = 'S1002', influence = '{0}/small_wheel.h5', structural = '{1}' }}\n"
                    "position.lateral = 6.6\nload.force = 1e5\nsolver.model = 'fem'\n"
                    "grid = {{ dx = 1.0, ds = 0.6 }}\nmotion.eta = 1e-3\nlayer.{2}",
                    CONFORMAL_SOURCE_DIR "/data/influence", structural, layer)));
  };
  for (const char* structural : {"included", "removed"}) {
    const SceneResult given = gauge_corner(one, structural), by_row = gauge_corner(table, structural);
    for (const char* name : {"Fx", "Fs", "Mz"}) {
      const double scale = quantity(name).value(given);
      EXPECT_NEAR(quantity(name).value(by_row), scale, 1e-5 * std::abs(scale)) << structural << " " << name;
    }
  }
}

TEST(LayerScene, CheckSaysWhatTheLayerIs) {
  const auto lines = [](const std::string& layer) {
    std::string all;
    for (const std::string& line : Sequence().check(layer_patch(layer)).lines)
      all += line + "\n";
    return all;
  };
  EXPECT_THAT(lines("compliance = 2e-5"), HasSubstr("layer between the surfaces: compliance 2e-05 mm3/N"));
  EXPECT_THAT(lines("slope = 0.6"), HasSubstr("0.6 of the slope"));
  EXPECT_THAT(lines(""), ::testing::Not(HasSubstr("layer")));
}

} // namespace
