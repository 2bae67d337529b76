#include "bem_contact/sequence/result_warnings.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/sequence/sequence.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace bem_contact {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

SceneResult on_standard_rail(const std::string& more, double dx = 1.0) {
  return Sequence().solve(parse_scene_file(
      fmt::format("rail.profile = '60E1'\nwheel.profile = 'S1002'\nsolver.model = 'halfspace'\n"
                  "grid.dx = {}\ngrid.ds = {}\n{}",
                  dx, 0.5 * dx, more)));
}

TEST(ResultWarnings, AnOrdinaryContactHasNone) {
  EXPECT_THAT(on_standard_rail("load.force = 6e4").warnings.texts(), IsEmpty());
}

TEST(ResultWarnings, PressureThatSteelDoesNotBearIsSaid) {
  const SceneResult r = on_standard_rail("load.force = 1.2e5\nposition.lateral = 6.4", 0.7);
  ASSERT_GT(r.result.totals.pmax, 1560);
  EXPECT_THAT(r.warnings.texts(), Contains(HasSubstr("three times the yield strength")));
  const SceneResult soft =
      on_standard_rail("load.force = 1.2e5\nposition.lateral = 6.4\n"
                       "rail.material.shear_modulus = 5e4\nwheel.material.shear_modulus = 5e4",
                       0.7);
  EXPECT_THAT(soft.warnings.texts(), Not(Contains(HasSubstr("yield strength")))) << "not of steel";
}

TEST(ResultWarnings, ACreepageAboveTenPercentIsSaid) {
  EXPECT_THAT(on_standard_rail("load.force = 6e4\nmotion.xi = 0.15").warnings.texts(),
              Contains(HasSubstr("the creepage is above 10 % (along x 0.1")));
  EXPECT_THAT(on_standard_rail("load.force = 6e4\nmotion.xi = 0.01").warnings.texts(), IsEmpty());
}

TEST(ResultWarnings, ElementsThatAreTooLargeAreSaidWithTheirSize) {
  EXPECT_THAT(on_standard_rail("load.force = 6e4", 4.0).warnings.texts(),
              Contains(HasSubstr("the elements are too large for this contact (patch 1")));
}

/// A rail that leans so far inwards touches the flange beside its head.
TEST(ResultWarnings, ContactBeyondTheHeadIsSaidWithItsDepth) {
  const auto at_cant = [](double cant) {
    return on_standard_rail(fmt::format("load.force = 2e4\nmotion.frictionless = true\nposition.lateral = "
                                        "6.0\nposition.rail_inclination = {}",
                                        cant));
  };
  EXPECT_THAT(
      at_cant(0.5).warnings.texts(),
      Contains(testing::ContainsRegex("beyond the rail's head .1[89].. mm below the top of the rail")));
  EXPECT_THAT(at_cant(0.025).warnings.texts(), Not(Contains(HasSubstr("beyond the rail's head"))));
}

TEST(ResultWarnings, StrictnessThrowsAllOfThem) {
  EXPECT_NO_THROW(refuse_warnings({}));
  try {
    refuse_warnings(
        {{WarningKind::yield, "one (1 mm) Do this."}, {WarningKind::grown_grid, "two (2 N) Do that."}});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::AllOf(HasSubstr("one (1 mm)"), HasSubstr("two (2 N)")));
  }
}

TEST(Strips, CheckGivesTablesForBothBodies) {
  const SceneFile scene =
      parse_scene_file("rail.profile = '60E1'\nwheel.profile = 'S1002'\nload.force = 1e5\n"
                       "position.lateral = 6.4\ngrid.dx = 1.0\ngrid.ds = 0.5\n");
  const std::vector<std::string> lines = Sequence().check(scene).lines;
  // Contact on the gauge corner: on the rail at negative arc lengths, on the wheel at positive ones.
  EXPECT_THAT(lines, Contains(HasSubstr("needs on the rail, for its body file:\n    [strip]\n    from = -")));
  EXPECT_THAT(lines, Contains(testing::ContainsRegex(
                         "on the wheel, for its body file:\n    .strip.\n    from = [0-9]")));
}

} // namespace
} // namespace bem_contact
