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
    EXPECT_NEAR(quantity("layer_slope").value(r), share, 0.05 * share);
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

TEST(LayerScene, ThatYieldsBearsItsLimitInEveryModel) {
  for (const char* model : {"halfspace", "tangent_plane", "fem", "simplified"}) {
    const auto scene = [&](const std::string& more) {
      return parse_scene_file(
          fmt::format("rail = {{ profile = '60E1', influence = '{0}/small_rail.h5' }}\n"
                      "wheel = {{ profile = 'S1002', influence = '{0}/small_wheel.h5' }}\n"
                      "position.lateral = 6.6\nload.force = 1e5\nsolver.model = '{1}'\n"
                      "grid = {{ dx = 1.0, ds = 0.6 }}\nmotion = {{ xi = 2e-2, free_rolling = false }}\n"
                      "layer.compliance = 3e-5\n{2}",
                      CONFORMAL_SOURCE_DIR "/data/influence", model, more));
    };
    SCOPED_TRACE(model);
    const SceneResult never = solved_with_layer(scene("layer.yield_shear = 1e5\n")),
                      without = solved_with_layer(scene("")),
                      soft = solved_with_layer(scene("layer.yield_shear = 20\n")),
                      hard = solved_with_layer(scene("layer.yield_shear = 20\nlayer.hardening = 500\n")),
                      softens = solved_with_layer(scene("layer.yield_shear = 20\nlayer.hardening = -20\n"));
    EXPECT_NEAR(never.result.totals.Fx, without.result.totals.Fx, 1e-9 * without.result.totals.Fx);
    EXPECT_EQ(quantity("largest_plastic_slip").value(never), 0);
    EXPECT_TRUE(std::isnan(quantity("largest_plastic_slip").value(without)));
    const double limit = 20 * double(soft.result.totals.area);
    EXPECT_LT(soft.result.totals.Fx, limit);
    EXPECT_GT(soft.result.totals.Fx, 0.85 * limit);
    EXPECT_GT(hard.result.totals.Fx, 1.05 * double(soft.result.totals.Fx));
    EXPECT_LT(softens.result.totals.Fx, soft.result.totals.Fx);
    for (const SceneResult* r : {&soft, &hard, &softens}) {
      const double largest = quantity("largest_plastic_slip").value(*r);
      for (std::size_t i = 0; i < r->result.px.size(); ++i)
        EXPECT_LE(std::hypot(r->result.px[i], r->result.ps[i]), 20 + (r == &hard ? 500 * largest : 0) + 1e-4);
      if (std::string(model) != "simplified") {
        EXPECT_TRUE(r->result.trust.discretisation);
      }
    }
  }
}

/// Stated errors of a layer that yields: forces on elements half as large lie within them.
TEST(LayerScene, ThatYieldsHasErrorsThatHold) {
  for (const char* layer :
       {"yield_shear = 60", "yield_shear = 60\nhardening = 800", "yield_shear = 100\nhardening = -100"})
    for (const char* xi : {"xi = 1e-3", "xi = 5e-3\neta = 2e-3"}) {
      const std::string all = std::string("compliance = 5e-5\n") + layer;
      const SceneResult coarse = solved_with_layer(layer_patch(all, xi)),
                        fine = solved_with_layer(
                            layer_patch(all, xi, "dx = 0.125\nds = 0.125\nmx = 112\nms = 88"));
      EXPECT_NEAR(coarse.result.totals.Fx, fine.result.totals.Fx, coarse.result.totals.Fx.error)
          << layer << xi;
      EXPECT_NEAR(coarse.result.totals.T_gamma, fine.result.totals.T_gamma,
                  coarse.result.totals.T_gamma.error)
          << layer << xi;
    }
}

TEST(LayerScene, YieldIsReadAndRefused) {
  EXPECT_THAT(layer_refusal("hardening = 10"), HasSubstr("layer.yield_shear is not given"));
  EXPECT_THAT(layer_refusal("yield_shear = 100", "xi = 1e-3\nkinetic_friction = 0.2"),
              HasSubstr("layer.yield_shear"));
  EXPECT_THAT(layer_refusal("yield_shear = 100\nhardening = 10",
                            "xi = 1e-3\nspeed = 1e4\nfalling_friction = 0.2\nhalf_slip_velocity = 1000"),
              HasSubstr("layer.hardening"));
  EXPECT_THAT(layer_refusal("yield_shear = 100\nhardening = -1e7"), HasSubstr("more than one solution"));
  EXPECT_THAT(layer_patch("yield_shear = 100", "frictionless = true").unused,
              Contains(testing::Field(&Warning::text, HasSubstr("layer.yield_shear"))));
  EXPECT_TRUE(
      std::isnan(quantity("largest_plastic_slip").value(solved_with_layer(layer_patch("yield_shear = 0")))));
}

/// Hotter rails bear less, in each model with elements, on curved surfaces and of unlike materials; one value
/// at all temperatures is that limit.
TEST(LayerScene, ThatSoftensByHeatBearsLessOnHotRails) {
  for (const char* model : {"halfspace", "tangent_plane", "fem"}) {
    SCOPED_TRACE(model);
    const auto force = [&](const std::string& limit, double rail) {
      const SceneResult r = solved_with_layer(parse_scene_file(fmt::format(
          "rail = {{ profile = '60E1', influence = '{0}/small_rail.h5' }}\n"
          "wheel = {{ profile = 'S1002', influence = '{0}/small_wheel.h5' }}\n"
          "position.lateral = 6.6\nload.force = 1e5\nsolver.model = '{1}'\n"
          "grid = {{ dx = 1.0, ds = 0.6 }}\nmotion = {{ xi = 2e-2, free_rolling = false, speed = 2e4 }}\n"
          "temperature = {{ flash = true, rail = {2} }}\nlayer.compliance = 3e-5\n{3}",
          CONFORMAL_SOURCE_DIR "/data/influence", model, rail, limit)));
      EXPECT_TRUE(std::isfinite(r.result.totals.Fx.error));
      return r.result.totals.Fx.value;
    };
    const std::string table =
                          "layer.yield_temperatures = [20, 100, 300]\nlayer.yield_shears = [120, 80, 20]\n",
                      constant = "layer.yield_temperatures = [20, 100]\nlayer.yield_shears = [120, 120]\n";
    const double cold = force(table, 20), hot = force(table, 200),
                 plain = force("layer.yield_shear = 120\n", 20);
    EXPECT_LT(cold, 0.99 * plain);
    EXPECT_LT(hot, 0.8 * cold);
    EXPECT_NEAR(force(constant, 200), plain, 1e-9 * plain);
  }
}

TEST(LayerScene, YieldByHeatIsReadAndRefused) {
  const std::string table = "yield_temperatures = [20, 200]\nyield_shears = [100, 50]\n";
  const std::string heat = "xi = 1e-2\nspeed = 1e4\n[temperature]\nflash = true";
  const auto refusal = [&](const std::string& layer, const std::string& motion) {
    return message_of([&] { solved_with_layer(layer_patch(layer, motion)); });
  };
  EXPECT_THAT(refusal(table, "xi = 1e-2\nspeed = 1e4"), HasSubstr("temperatures are not asked for"));
  EXPECT_THAT(refusal(table + "yield_shear = 100", heat), HasSubstr("layer.yield_shear is given too"));
  EXPECT_THAT(refusal("yield_temperatures = [20, 200]\nyield_shears = [100]", heat),
              HasSubstr("2 temperatures"));
  EXPECT_THAT(refusal("yield_temperatures = [20, 200]\nyield_shears = [50, 100]", heat),
              HasSubstr("more than one solution"));
  EXPECT_THAT(refusal("yield_temperatures = [200, 20]\nyield_shears = [100, 50]", heat),
              HasSubstr("do not rise"));
  EXPECT_THAT(refusal(table, "xi = 1e-2\nspeed = 1e4\nkind = 'transient'\n[temperature]\nflash = true"),
              HasSubstr("those of steady rolling"));
  EXPECT_THAT(message_of([&] {
                SceneFile scene = layer_patch(table, heat);
                scene.solver.model = Model::simplified;
                solved_with_layer(scene);
              }),
              HasSubstr("it knows no temperatures"));
  EXPECT_EQ(layer_patch("state = 'clay'\n" + table, heat).layer.hardening, 435);
  EXPECT_FALSE(layer_patch("state = 'clay'\n" + table, heat).layer.yield_shear);
  const SceneResult clay = solved_with_layer(layer_patch("state = 'clay'\n" + table, heat));
  EXPECT_GT(quantity("largest_plastic_slip").value(clay), 0);
}

/// A history goes on from its plastic slip: a start table with it repeats the last step of a longer history.
TEST(LayerScene, AStartTableHasThePlasticSlip) {
  const TemporaryFolder folder;
  const std::string layer = "compliance = 5e-5\nyield_shear = 60\nhardening = 1e3",
                    grid = "dx = 1\nds = 1\nmx = 14\nms = 11", shift = "kind = 'shift'\nxi = 0.02\n";
  const SceneResult one = solved_with_layer(layer_patch(layer, shift, grid)),
                    two = solved_with_layer(layer_patch(layer, shift + "steps = 2", grid));
  std::ofstream table(folder / "start.csv");
  table << "ix,is,px,ps,pn,plastic_slip\n";
  for (std::size_t i = 0; i < one.result.px.size(); ++i)
    table << fmt::format("{},{},{:.17g},{:.17g},{:.17g},{:.17g}\n", i % 14, i / 14, one.result.px[i],
                         one.result.ps[i], one.result.pn[i], one.result.plastic[i]);
  table.close();
  const SceneResult gone_on = solved_with_layer(
      layer_patch(layer, shift + "start_table = '" + (folder / "start.csv").string() + "'", grid));
  EXPECT_GT(quantity("largest_plastic_slip").value(two), 1.5 * quantity("largest_plastic_slip").value(one));
  EXPECT_NEAR(quantity("largest_plastic_slip").value(gone_on), quantity("largest_plastic_slip").value(two),
              1e-9);
  EXPECT_NEAR(gone_on.result.totals.Fx, two.result.totals.Fx, 1e-7 * two.result.totals.Fx);
}

TEST(LayerScene, AStateIsItsRowUnlessKeysSayOtherwise) {
  const auto read = [](const std::string& layer, const std::string& motion = "speed = 1e4") {
    return parse_scene_file("kind = 'patch'\nload.force = 5e4\ngrid = { mx = 20, ms = 20 }\nmotion = { " +
                            motion + " }\n[layer]\n" + layer);
  };
  const SceneFile clay = read("state = 'clay'");
  EXPECT_EQ(clay.layer.compliance, 1.88e-4);
  EXPECT_EQ(clay.layer.yield_shear, 200);
  EXPECT_EQ(clay.layer.hardening, 435);
  EXPECT_EQ(clay.motion.friction, SceneFile().motion.friction);
  const SceneFile locomotive = read("state = 'locomotive'");
  EXPECT_EQ(locomotive.motion.friction, 0.33);
  EXPECT_EQ(locomotive.motion.falling_friction, 0.14);
  EXPECT_FALSE(read("state = 'locomotive'", "xi = 1e-3").motion.falling_friction) << "it needs a speed";
  EXPECT_EQ(read("state = 'locomotive'", "friction = 0.2").motion.friction, 0.2);
  EXPECT_EQ(read("state = 'clay'\ncompliance = 1e-5\nhardening = 0").layer.compliance, 1e-5);
  EXPECT_EQ(read("state = 'clay'\ncompliance = 1e-5\nhardening = 0").layer.hardening, 0);
  EXPECT_FALSE(read("state = 'clay'\nslope = 0.6").layer.compliance);
  EXPECT_FALSE(read("state = 'clean'").layer.compliance);
  EXPECT_THAT(message_of([&] { read("state = 'mud'"); }), HasSubstr("clay"));
  // Each is certified, and softer the softer its layer is.
  double before = 1e9;
  for (const char* state : {"clean", "rig", "sand", "clay", "MoS2"}) {
    const SceneResult r = solved_with_layer(layer_patch(std::string("state = '") + state + "'"));
    EXPECT_LT(r.result.totals.Fx, before) << state;
    before = r.result.totals.Fx;
  }
}

} // namespace
