#include "bem_contact/base/comma_separated.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "bem_contact/uses/fit/fit_curve.hpp"
#include "bem_contact/uses/fit/fit_record.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <fmt/core.h>
#include <random>

namespace {

using namespace bem_contact;
using fit::CurveFit;
using fit::Question;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double friction = 0.3, compliance = 4e-5, load = 4000;

/// A Hertz contact with a layer, on few elements.
SceneText scene(double guess_of_compliance = 1e-4, double guess_of_friction = 0.2) {
  return fmt::format("kind = \"patch\"\nload.force = {}\nmotion.friction = {}\nlayer.compliance = {}\n"
                     "[grid]\ndx = 0.5\nds = 0.5\nmx = 16\nms = 12\n[gap]\na = 1e-3\nb = 2e-3\n",
                     load, guess_of_friction, guess_of_compliance);
}

/// What the program itself gives, with a scatter of `noise` times mu F.
MeasuredForces made(const std::vector<double>& creepages, double noise = 0, unsigned seed = 1) {
  MeasuredForces out{
      .which = CreepKind::xi, .force = CreepForce::Fx, .creepage = creepages, .measured = {}, .scatter = {}};
  const CreepCurves curves = creep_curves(parse_scene_file(scene(compliance, friction)),
                                          std::vector<CreepRange>{{CreepKind::xi, creepages}});
  std::mt19937 random(seed);
  std::normal_distribution<double> scatter(0, noise * friction * load);
  for (const CreepPoint& p : curves.curves[0].points)
    out.measured.push_back(p.forces[0] + (noise > 0 ? scatter(random) : 0));
  return out;
}

CurveFit fitted(const fit::Measurements& measured, const std::string& keys, const SceneText& text = scene(),
                const std::string& model = "halfspace") {
  return fit::fit_curve(
      {.text = text, .changes = {}, .model = model, .measured = measured, .keys = comma_separated(keys)});
}

CurveFit fitted(const MeasuredForces& measured, const std::string& keys, const SceneText& text = scene()) {
  return fitted(fit::Measurements{{measured}, {}}, keys, text);
}

const std::vector<double> all_over{1e-4, 2e-4, 4e-4, 6e-4, 9e-4, 1.3e-3, 2e-3, 3e-3, 5e-3};

TEST(FitCurve, FindsWhatTheProgramWasGiven) {
  const CurveFit f = fitted(made(all_over), "layer.compliance,motion.friction");
  EXPECT_TRUE(certified(f));
  EXPECT_NEAR(f.keys[0].value / compliance, 1, 2e-3);
  EXPECT_NEAR(f.keys[1].value / friction, 1, 1e-4);
  EXPECT_EQ(f.keys[0].unit, "mm3/N");
  EXPECT_EQ(f.keys[0].start, 1e-4);
  EXPECT_LT(differences_of(f.measured.forces.at(0)).root_mean_square, 1e-4 * friction * load);
  EXPECT_THAT(f.undetermined, IsEmpty());
  EXPECT_EQ(f.band.size(), f.curves->curves.at(0).points.size());
  EXPECT_EQ(f.scene.layer.compliance, f.keys[0].value);
  EXPECT_LE(f.tried, 20); // 28 by differences
}

/// With scatter the intervals contain what was put in, and the band the true curve.
TEST(FitCurve, IntervalsContainWhatWasPutIn) {
  int inside = 0, count = 0;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const CurveFit f = fitted(made(all_over, 0.02, seed), "layer.compliance,motion.friction");
    for (const auto& [key, truth] : {std::pair(f.keys[0], compliance), {f.keys[1], friction}}) {
      inside += key.low <= truth && truth <= key.high;
      ++count;
      EXPECT_LT(key.high - key.low, truth) << key.key;
      EXPECT_LT(key.low, key.value);
      EXPECT_GT(key.high, key.value);
    }
    for (const auto& [low, high] : f.band)
      EXPECT_LE(low, high);
  }
  fmt::print("{} of {} intervals contain what was put in\n", inside, count);
  EXPECT_GE(inside, count - 1);
}

/// Where everything slips, no point knows the layer; where nothing does, none knows friction.
TEST(FitCurve, TellsWhatThePointsDoNotSay) {
  const CurveFit slips = fitted(made({0.02, 0.03, 0.04, 0.05}, 0.01), "layer.compliance,motion.friction");
  EXPECT_FALSE(slips.keys[0].determined && slips.keys[0].high < 2 * slips.keys[0].value);
  EXPECT_TRUE(slips.keys[1].determined);
  EXPECT_THAT(slips.undetermined, testing::Contains(HasSubstr("layer.compliance")));
  EXPECT_THAT(slips.undetermined, testing::Contains(HasSubstr("do not measure that slope")));
  EXPECT_NEAR(slips.keys[1].value / friction, 1, 0.03);
  const record::Record said = record_of(slips);
  EXPECT_EQ(record::text_at(said, "measured/force"), "Fx");
  const auto* open = std::get_if<record::Texts>(record::find(said, "not_determined"));
  EXPECT_EQ(open->lines, slips.undetermined);
}

/// Points as stiff as elastic bodies leave nothing of a layer: it ends at none, and is bounded from above.
TEST(FitCurve, EndsAtABound) {
  MeasuredForces stiff = made(all_over);
  const CreepCurves elastic = creep_curves(parse_scene_file(scene(1e-12, friction)),
                                           std::vector<CreepRange>{{CreepKind::xi, all_over}});
  for (std::size_t i = 0; i < all_over.size(); ++i)
    stiff.measured[i] = 1.02 * elastic.curves[0].points[i].forces[0] + (i % 2 ? 5 : -5);
  const CurveFit f = fitted(stiff, "layer.compliance", scene(1e-4, friction));
  EXPECT_EQ(f.keys[0].bound, fit::Bound::lower);
  EXPECT_LT(f.keys[0].value, 1e-8);
  EXPECT_THAT(f.undetermined, testing::Contains(HasSubstr("ended at the lower end")));
}

TEST(FitCurve, RefusesWhatCannotBeFitted) {
  const MeasuredForces points = made({1e-3, 2e-3});
  const auto refused = [&](const std::string& keys, const char* word, const MeasuredForces& measured) {
    try {
      fitted(measured, keys);
      ADD_FAILURE() << keys;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(word)) << keys;
    }
  };
  refused("layer.complaince", "Did you mean layer.compliance", points);
  refused("layer.compliance,motion.friction", "2 points are too few", points);
  refused("", "nothing to fit", points);
  refused("layer.state", "layer.state", points);
  refused("grid.mx", "no number that may grow", points);
  refused("layer.hardening", "cannot be fitted", points);
  refused("motion.falling_friction", "cannot be fitted", points);
  refused("motion.xi", "what the points vary", points);
  const MeasuredForces more = made({1e-3, 2e-3, 3e-3});
  refused("motion.friction,motion.friction", "named twice", more);
  MeasuredForces sure = more;
  sure.scatter = {1, 0, 1};
  refused("motion.friction", "scatter of 0", sure);
  try {
    fitted(points, "load.force",
           SceneText("kind = \"patch\"\nload.force = 1\nmotion.frictionless = true\ngrid = { dx = 1, ds = 1, "
                     "mx = 4, ms = 4 }\n"
                     "gap = { a = 1e-3, b = 1e-3 }\n"));
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("no friction"));
  }
}

/// Lines of pressures that the program itself gives.
fit::MeasuredPressures made_pressures(const SceneText& text, const std::vector<std::string>& columns,
                                      const std::vector<std::vector<double>>& places) {
  std::vector<std::vector<double>> rows = places;
  for (std::vector<double>& row : rows)
    row.push_back(1);
  fit::MeasuredPressures out = fit::measured_pressures("line", columns, rows);
  out.measured = fit::pressures_at(out, Sequence().solve(parse_scene_file(text)));
  return out;
}

/// A line of pressures over s knows load and stiffness of a Hertz contact: its width is that of (F/G)^(1/3),
/// its height that of (F G2)^(1/3). Lines over x and single places say the same.
TEST(FitPressures, FindLoadAndStiffness) {
  const auto hertz = [](double force, double modulus) {
    return SceneText(fmt::format(
        "kind = 'patch'\nload.force = {}\nmotion.frictionless = true\nsolver.model = 'halfspace'\n"
        "rail.material.shear_modulus = {}\n[grid]\ndx = 0.25\nds = 0.25\nmx = 44\nms = 40\n"
        "[gap]\na = 1e-3\nb = 2e-3\n",
        force, modulus));
  };
  const SceneText right = hertz(8000, 60000), guess = hertz(5000, 80000);
  std::vector<std::vector<double>> line, places;
  for (double at = -3.2; at < 3.3; at += 0.4) {
    line.push_back({at});
    places.push_back({0.5 * at, at});
  }
  const auto over_s = made_pressures(right, {"s", "pn"}, line),
             over_x = made_pressures(right, {"x", "pn"}, line),
             spots = made_pressures(right, {"x", "s", "pn"}, places);
  EXPECT_EQ(over_s.measured.front(), 0); // beside the contact
  EXPECT_GT(over_s.measured[8], 400);
  for (const auto& all : {std::vector{over_s}, {over_x}, {spots}, {over_s, over_x}}) {
    const CurveFit f = fitted({{}, all}, "load.force,rail.material.shear_modulus", guess);
    EXPECT_TRUE(certified(f));
    EXPECT_NEAR(f.keys[0].value, 8000, 0.005 * 8000);
    EXPECT_NEAR(f.keys[1].value, 60000, 0.02 * 60000);
    EXPECT_FALSE(f.curves);
    const record::Record said = record_of(f);
    EXPECT_EQ(record::text_at(said, "pressures/over"), all[0].line == fit::PressureLine::over_x ? "x" : "s");
    EXPECT_LT(std::get<record::Number>(*record::find(said, "pressures/misfit")).value, 0.01 * 500);
    EXPECT_EQ(record::find(said, "pressures_2") != nullptr, all.size() == 2);
  }
}

/// Where a wheel stands on a rail, by its line of pressures on the rail's surface.
TEST(FitPressures, FindThePosition) {
  const auto wheel = [](double lateral) {
    return SceneText(fmt::format("rail.profile = '60E1'\nwheel.profile = 'S1002'\nload.force = 6e4\n"
                                 "solver.model = 'halfspace'\nmotion.frictionless = true\n"
                                 "position.lateral = {}\n[grid]\ndx = 0.5\nds = 0.5\n",
                                 lateral));
  };
  std::vector<std::vector<double>> line;
  for (double s = -22; s < 2; s += 1)
    line.push_back({s});
  const CurveFit f =
      fitted({{}, {made_pressures(wheel(-1.5), {"s", "pn"}, line)}}, "position.lateral", wheel(-1.2));
  EXPECT_TRUE(certified(f));
  EXPECT_NEAR(f.keys[0].value, -1.5, 0.03);
}

/// Several tables at once: forces along x say friction, the moment of spin and the pressure the rest. A twin
/// disc's forces over slip are those of a roller.
TEST(FitCurve, TakesSeveralTablesAndATwinDisc) {
  const auto discs = [](double mu, double force) {
    return SceneText(
        fmt::format("kind = 'patch'\nload.force = {}\nmotion.friction = {}\nsolver.model = 'halfspace'\n"
                    "[grid]\ndx = 0.15\nds = 0.15\nmx = 16\nms = 20\n"
                    "[gap]\na = 0.0213\nb = 0.01\n", // radii of 47 mm, one of them crowned
                    force, mu));
  };
  const std::vector<double> slips{5e-4, 1e-3, 2e-3, 4e-3, 1e-2, 3e-2};
  MeasuredForces fx{
      .which = CreepKind::xi, .force = CreepForce::Fx, .creepage = slips, .measured = {}, .scatter = {}};
  const CreepCurves right =
      creep_curves(parse_scene_file(discs(0.25, 900)), std::vector<CreepRange>{{CreepKind::xi, slips}});
  for (const CreepPoint& p : right.curves[0].points)
    fx.measured.push_back(p.forces[0]);
  MeasuredForces again = fx;
  again.creepage.resize(3);
  again.measured.resize(3);
  const auto line = made_pressures(discs(0.25, 900), {"s", "pn"}, {{-0.8}, {-0.4}, {0}, {0.4}, {0.8}});
  const CurveFit f = fitted({{fx, again}, {line}}, "motion.friction,load.force", discs(0.4, 1500));
  EXPECT_TRUE(certified(f));
  EXPECT_NEAR(f.keys[0].value, 0.25, 0.25 * 5e-3);
  EXPECT_NEAR(f.keys[1].value, 900, 5);
  const record::Record said = record_of(f);
  for (const char* path : {"measured/misfit", "measured_2/misfit", "pressures/misfit", "band", "curves/xi"})
    EXPECT_TRUE(record::find(said, path)) << path;
  const auto refused = [&](const fit::Measurements& all, const char* word) {
    try {
      fitted(all, "motion.friction", discs(0.4, 900));
      ADD_FAILURE() << word;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(word));
    }
  };
  MeasuredForces sure = again;
  sure.scatter = {1, 1, 1};
  refused({{fx, sure}, {}}, "another has not");
  fit::MeasuredPressures nothing = line;
  nothing.measured.assign(5, 0.0);
  refused({{fx}, {nothing}}, "0 everywhere");
  try {
    fit::measured_pressures("line", {"y", "pn"}, {});
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("its columns are y, pn"));
  }
}

} // namespace
