#include "bem_contact/profile/standard_profiles.hpp"
#include "bem_contact/sequence/sequence.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace bem_contact;

/// Every standard is placed on the usual one of the other kind and solved, coarsely.
TEST(StandardPairs, AreSolvedAndCertified) {
  Sequence sequence;
  int solved = 0;
  for (const StandardEntry& entry : standard_entries()) {
    const bool rail = entry.kind == ProfileKind::rail;
    const SceneResult r = sequence.solve(parse_scene_file(fmt::format(
        "rail.profile = \"{}\"\nwheel.profile = \"{}\"\nsolver.model = \"halfspace\"\nload.force = 8e4\n"
        "grid.dx = 1\ngrid.ds = 1\nposition.rail_inclination = {}\n",
        rail ? entry.name : "60E1", rail ? "S1002" : entry.name,
        entry.part == StandardEntry::Part::curve && rail ? 0 : 0.025)));
    EXPECT_TRUE(r.result.certified()) << entry.name;
    EXPECT_FALSE(r.result.patches.empty()) << entry.name;
    solved += r.result.certified();
  }
  EXPECT_EQ(solved, static_cast<int>(standard_entries().size()));
}

} // namespace
