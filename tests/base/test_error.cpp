#include "bem_contact/base/error.hpp"

#include <gmock/gmock.h>

namespace bem_contact {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Error, reads_problem_why_what_to_do) {
  const Error error("no rail", "the file is empty", "Give a rail.");
  EXPECT_STREQ(error.what(), "no rail (the file is empty) Give a rail.");
}

TEST(Error, kinds_are_errors) {
  EXPECT_THROW(throw InputError("a", "b", "c"), Error);
  EXPECT_THROW(throw ConvergenceError("a", "b", "c"), Error);
}

const std::vector<std::string> names{"station_width", "from", "to", "poisson", "shear_modulus"};

TEST(NearestNames, finds_a_slip_of_the_finger) {
  EXPECT_THAT(nearest_names("poison", names), ElementsAre("poisson"));
  EXPECT_THAT(nearest_names("form", names), ElementsAre("from"));
  EXPECT_THAT(nearest_names("Shear_Modulus", names), ElementsAre("shear_modulus"));
}

TEST(NearestNames, finds_a_part) {
  EXPECT_THAT(nearest_names("width", names), ElementsAre("station_width"));
}

TEST(NearestNames, says_nothing_where_nothing_is_like_it) {
  EXPECT_THAT(nearest_names("qqqqqqqq", names), IsEmpty());
  EXPECT_THAT(nearest_names("", names), IsEmpty());
  EXPECT_THAT(nearest_names("from", {}), IsEmpty());
}

TEST(NearestNames, best_first_and_no_more_than_asked) {
  const std::vector<std::string> alike{"gauges", "gauge", "gouge"};
  EXPECT_THAT(nearest_names("gauge", alike), ElementsAre("gauge", "gauges", "gouge"));
  EXPECT_THAT(nearest_names("gauge", alike, 1), ElementsAre("gauge"));
}

} // namespace
} // namespace bem_contact
