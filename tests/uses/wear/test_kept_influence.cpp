#include "bem_contact/base/error.hpp"
#include "bem_contact/uses/wear/evolution.hpp"
#include "tests/base/message.hpp"
#include "tests/base/temporary_folder.hpp"
#include "tests/uses/wear/area_between.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

namespace {

using namespace bem_contact;
using namespace bem_contact::wear;
using ::testing::HasSubstr;

std::vector<Point2> line(double amplitude) {
  std::vector<Point2> out;
  for (int i = 0; i <= 400; ++i)
    out.push_back({0.1 * i, amplitude * std::sin(0.1 * i)});
  return out;
}

/// A wave of 0.02 mm and wavenumber 1/mm turns a plane by 0.02 rad; a turn of the whole counts as it is.
TEST(KeptInfluence, TurnIsThatOfTheSurface) {
  EXPECT_EQ(turn_between(line(0), line(0)), 0);
  EXPECT_NEAR(turn_between(line(0), line(0.02)), 0.02, 1e-4);
  std::vector<Point2> all = line(0.02);
  for (Point2& p : all)
    p = turned(p, -0.3);
  EXPECT_NEAR(turn_between(line(0.02), all), 0.3, 1e-12);
}

/// Material that goes everywhere alike turns nothing.
TEST(KeptInfluence, DepthAloneCountsNothing) {
  std::vector<Point2> deeper = line(0.02);
  for (Point2& p : deeper)
    p.z += 5;
  EXPECT_NEAR(turn_between(line(0.02), deeper), 0, 1e-12);
}

/// At the gauge corner, on the small influence files.
CollectiveCase corner(const char* model) {
  const std::string data = CONFORMAL_SOURCE_DIR "/data/influence/";
  return {
      parse_scene_file("rail = { profile = '60E1', influence = '" + data + "small_rail.h5' }\n" +
                       "wheel = { profile = 'S1002', influence = '" + data + "small_wheel.h5' }\n" +
                       "solver.model = '" + model +
                       "'\nload.force = 1e5\nposition.lateral = 6.6\n[motion]\nfree_rolling = false\n[grid]\n"
                       "dx = 0.5\nds = 0.5\n"),
      1.0};
}

std::filesystem::path shared_folder() {
  static const TemporaryFolder out;
  return out.path();
}

KeptPair unworn_files() {
  const SceneFile scene = corner("fem").scene;
  const WornPair pair = unworn(scene);
  return {{scene.rail.influence, pair.rail.points}, {scene.wheel.influence, pair.wheel.points}};
}

/// Both models wear the same place by nearly the same volume: by README.md's table friction does the same
/// work within a few percent. The second step goes on with the files of the unworn shape.
TEST(KeptInfluence, FemWearsLikeTheHalfSpace) {
  const EvolutionOptions options{.law = EnergyLaw{.mild_until = 1e9, .severe_until = 1e9}, .cap = 0.02};
  const WornPair begin = unworn(corner("fem").scene);
  const WornPair fem = wear_step(begin, {corner("fem")}, options, 1, shared_folder(), unworn_files());
  const WornPair half = wear_step(begin, {corner("halfspace")}, options, 1, shared_folder());
  EXPECT_NEAR(fem.largest(), 0.02, 1e-9);
  EXPECT_NEAR(fem.rail.area / fem.revolutions, half.rail.area / half.revolutions,
              0.15 * half.rail.area / half.revolutions);
  const auto deepest = [](const WornBody& body) {
    return std::ranges::max_element(body.depth) - body.depth.begin();
  };
  EXPECT_NEAR(deepest(fem.rail), deepest(half.rail), 8); // points, 0.25 mm apart
  const WornPair second = wear_step(fem, {corner("fem")}, options, 1, shared_folder(), unworn_files());
  EXPECT_GT(second.rail.area, fem.rail.area);
  EXPECT_NEAR(area_between(begin.rail.points, second.rail.points), second.rail.area, 1e-6 * second.rail.area);
}

std::string refusal(const WornPair& pair, const EvolutionOptions& options, const KeptPair& kept) {
  return ::message_of([&] { wear_step(pair, {corner("fem")}, options, 1, shared_folder(), kept); });
}

TEST(KeptInfluence, IsRefusedForAnOutgrownShape) {
  WornPair pair = unworn(corner("fem").scene);
  for (Point2& p : pair.rail.points)
    p = turned(p, 0.002);
  EXPECT_THAT(
      refusal(pair, {.kept_turn = 0.001}, unworn_files()),
      HasSubstr("The rail has outgrown its influence functions (its surface has turned by up to 0.0020 rad"));
  pair.wheel.points.pop_back();
  EXPECT_THAT(refusal(pair, {.kept_turn = 0.01}, unworn_files()),
              HasSubstr("The influence functions of the wheel are of another profile"));
}

TEST(KeptInfluence, FemNeedsFiles) {
  CollectiveCase without = corner("fem");
  without.scene.wheel.influence.clear();
  EXPECT_TRUE(needs_influence(corner("fem").scene));
  EXPECT_FALSE(needs_influence(corner("tangent_plane").scene));
  EXPECT_THAT(refusal(unworn(without.scene), {}, {}), HasSubstr("needs influence functions of both bodies"));
}

} // namespace
