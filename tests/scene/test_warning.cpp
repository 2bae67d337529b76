#include "bem_contact/scene/warning.hpp"

#include "bem_contact/base/error.hpp"

#include <gmock/gmock.h>

namespace bem_contact {
namespace {

using testing::ElementsAre;

TEST(Warning, TheMostImportantIsFirst) {
  Warnings all;
  all.add(WarningKind::without_effect, "last");
  all.add(WarningKind::yield, "second");
  all.add(WarningKind::uncertified_step, "first");
  all.add(WarningKind::yield, "third");
  EXPECT_THAT(all.texts(), ElementsAre("first", "second", "third", "last"));
  EXPECT_THAT(all.kinds(), ElementsAre("uncertified_step", "yield", "yield", "without_effect"));
}

TEST(Warning, OneThatIsThereIsNotAddedAgain) {
  Warnings all{{WarningKind::yield, "at 1 MPa"}};
  all.add(Warnings{{WarningKind::yield, "at 1 MPa"}, {WarningKind::yield, "at 2 MPa"}});
  EXPECT_THAT(all.texts(), ElementsAre("at 1 MPa", "at 2 MPa"));
}

/// What is said decides nothing: the same words of two keys are two warnings, and other words of one kind
/// are one.
TEST(Warning, OneOfSeveralPlacesIsToldByItsKind) {
  const Warnings once = once_each({{"fem", {WarningKind::unlikely_value, "8 mm is 8 m", "rail.y"}},
                                   {"fem", {WarningKind::unlikely_value, "9 mm is 9 m", "wheel.y"}},
                                   {"hertz", {WarningKind::unlikely_value, "8 mm is 8 m", "rail.y"}},
                                   {"hertz", {WarningKind::large_elements, "patch 1: 4 of 9 mm along x"}},
                                   {"fem", {WarningKind::large_elements, "patch 1 has 8, 40 are needed"}}});
  EXPECT_THAT(once.texts(),
              ElementsAre("fem, hertz: 8 mm is 8 m", "fem: 9 mm is 9 m",
                          "hertz: patch 1: 4 of 9 mm along x [1 more with other figures: fem]"));
}

} // namespace
} // namespace bem_contact
