#include "bem_contact/base/comma_separated.hpp"
#include "bem_contact/base/error.hpp"
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

CurveFit fitted(const MeasuredForces& measured, const std::string& keys, const SceneText& text = scene()) {
  return fit::fit_curve({.text = text,
                         .changes = {},
                         .model = "halfspace",
                         .measured = measured,
                         .keys = comma_separated(keys)});
}

const std::vector<double> all_over{1e-4, 2e-4, 4e-4, 6e-4, 9e-4, 1.3e-3, 2e-3, 3e-3, 5e-3};

TEST(FitCurve, FindsWhatTheProgramWasGiven) {
  const CurveFit f = fitted(made(all_over), "layer.compliance,motion.friction");
  EXPECT_TRUE(certified(f));
  EXPECT_NEAR(f.keys[0].value / compliance, 1, 2e-3);
  EXPECT_NEAR(f.keys[1].value / friction, 1, 1e-4);
  EXPECT_EQ(f.keys[0].unit, "mm3/N");
  EXPECT_EQ(f.keys[0].start, 1e-4);
  EXPECT_LT(f.misfit, 1e-4 * friction * load);
  EXPECT_THAT(f.undetermined, IsEmpty());
  EXPECT_EQ(f.band.size(), f.curves.curves.at(0).points.size());
  EXPECT_EQ(f.scene.layer.compliance, f.keys[0].value);
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

} // namespace
