#include "bem_contact/record/error_text.hpp"
#include "bem_contact/record/found.hpp"
#include "bem_contact/record/json.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace {

using namespace bem_contact::record;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

/// One wheel on its rail: patches with these normal forces, at these inclinations.
Record contact(const std::vector<double>& forces, const std::vector<double>& inclinations) {
  Table patches{"patch",
                {{"Fn", "N", "", forces},
                 {"delta", "rad", "", inclinations},
                 {"wheel_y", "mm", "", std::vector<double>(forces.size(), 1)}},
                Layout::rows};
  return {{"certified", true},
          {"friction", Number{0.3, "1", ""}},
          {"quantities", Record{{"pmax", Number{2627.6, "MPa", "", 32.1}},
                                {"area", Number{55.893, "mm2", "", 3.14}},
                                {"T_gamma", Number{182.44, "N", "", 1.83}},
                                {"adhesion_share", Number{0.341, "1", "", 0.021}},
                                {"Fx", Number{-15898, "N", "", 141}},
                                {"Fy", Number{34793, "N", "", 221}},
                                {"Fz", Number{89419, "N", "", 0}},
                                {"lateral", Number{6.4381, "mm", "", not_known}}}},
          {"patches", patches}};
}

TEST(Rounded, ValueAndErrorHaveTwoDigitsOfTheError) {
  EXPECT_EQ(rounded(2627.6, 32.1), "2628 +- 32");
  EXPECT_EQ(rounded(34793, 221), "34790 +- 220");
  EXPECT_EQ(rounded(12790572, 19723973), "13000000 +- 20000000");
  EXPECT_EQ(rounded(-9.0614e-4, 1.21e-5), "-0.000906 +- 0.000012");
  EXPECT_EQ(rounded(0.00001, 0.034), "0.000 +- 0.034");
  EXPECT_EQ(rounded(462.5123, not_known), "462.5");
  EXPECT_EQ(rounded(89419, 0), "89419"); // prescribed
}

TEST(Found, ContactsSayWhereHowHardAndWhatIsDissipated) {
  const Found found = found_in(contact({8e4}, {-0.54}), "result");
  EXPECT_THAT(
      found.sentences,
      ElementsAre("The wheel touches the rail at the gauge corner (31 degrees steep).",
                  "The largest pressure is 2628 +- 32 MPa, and 55.9 +- 3.1 mm2 are in contact.",
                  "Friction dissipates 182.4 +- 1.8 N (T-gamma), and 34.1 +- 2.1 % of the area in contact "
                  "adheres.",
                  "On the rail act Fx -15900 +- 140 N, Fy 34790 +- 220 N and Fz 89419 N, where the wheelset "
                  "stands 6.438 mm to the right."));
  EXPECT_THAT(found.next,
              Contains(testing::Property(&NextQuestion::text,
                                         "Does the steel below yield? bem_contact shakedown SCENE.toml")));
  // The same inclination upwards is the field side; each of two patches has its share of the force.
  EXPECT_THAT(
      found_in(contact({6e4, 2e4}, {0.02, -1.2}), "result").sentences.front(),
      "The wheel touches the rail in 2 places: 75 % of the normal force at the top of the rail (1 degree "
      "steep), 25 % of the normal force at the flank of the flange (69 degrees steep).");
  EXPECT_THAT(found_in(contact({8e4}, {0.54}), "result").sentences.front(), HasSubstr("the field side"));
  EXPECT_THAT(found_in(contact({}, {}), "result").sentences,
              ElementsAre("Nothing is in contact: all forces are zero."));
}

TEST(Found, WhatIsNoSolutionIsSaidFirst) {
  Record broken{{"why_not_certified", Text{"friction is exceeded"}}, {"certified", false}};
  const Record solved = contact({8e4}, {0.02});
  for (const Entry& entry : solved.entries())
    if (entry.name != "certified")
      broken.append(Record{entry});
  const Found found = found_in(broken, "result");
  EXPECT_EQ(found.sentences.front(), "This is no solution: friction is exceeded. Do not use its numbers.");
  EXPECT_THAT(found_in(solved, "result").sentences, Not(Contains(HasSubstr("no solution"))));
}

Record fatigue(double surface, double below, double damage) {
  return {{"format", Text{"bem_contact fatigue 2"}},
          {"beyond_surface_limit", Number{surface, "1", ""}},
          {"beyond_limit_below", Number{below, "1", ""}},
          {"damage", Number{damage, "1", ""}},
          {"yield_shear", Number{300, "MPa", ""}},
          {"patches", Table{"patch",
                            {{"p0_over_k", "1", "", {8.8, 3}},
                             {"FI_surf", "1", "", {0.158, -0.1}},
                             {"T_gamma", "N", "", {182, 5}}}}}};
}

TEST(Found, CracksSayYesOrNoAndWhy) {
  EXPECT_THAT(
      found_in(fatigue(1, 0, 0)).sentences,
      ElementsAre("Cracks: yes. 1 of 2 patches is beyond the shakedown limit of the surface (mu used "
                  "less k/p0 is 0.158 at most, 0 is the limit): the steel flows there with every passage.",
                  HasSubstr("182 N at most) cracks do not grow")));
  EXPECT_THAT(found_in(fatigue(0, 0, 2e-6)).sentences,
              ElementsAre("Cracks: none by shakedown. All 2 patches are below both limits.",
                          HasSubstr("a crack begins after 500000 passages")));
  EXPECT_THAT(found_in(fatigue(0, 2, 0)).sentences.front(),
              HasSubstr("yes. 2 patches are beyond the limit below it"));
}

TEST(Found, SweepsSayWhereTheLargestIs) {
  const Record sweep{{"format", Text{"bem_contact sweep 4"}},
                     {"certified_count", Number{2, "1", ""}},
                     {"refused_count", Number{1, "1", ""}},
                     {"position.lateral", field({0, 2.5, 5}, "mm", "swept over")},
                     {"pmax", field({900, 1400, not_known}, "MPa", "")},
                     {"pmax_error", field({9, 14, not_known}, "MPa", "")},
                     {"status", field({1, 1, 3}, "1", "")}};
  EXPECT_THAT(found_in(sweep).sentences, ElementsAre("2 of 3 cases are certified; refused: 1.",
                                                     "The largest pressure goes from 900.0 +- 9.0 MPa to "
                                                     "1400 +- 14 MPa; it is largest at position.lateral 2.5 "
                                                     "mm (case 1)."));
}

/// Not its index; and figures that look the same are said once.
TEST(Found, SweepsOverTextsNameThem) {
  Field wheels = field({0, 1}, "1", "swept over");
  wheels.choices = {"S1002", "worn.txt"};
  const auto said = [&](double second) {
    const Record sweep{{"format", Text{"bem_contact sweep 4"}},
                       {"certified_count", Number{2, "1", ""}},
                       {"wheel.profile", wheels},
                       {"pmax", field({900, second}, "MPa", "")},
                       {"status", field({1, 1}, "1", "")}};
    return found_in(sweep).sentences.back();
  };
  EXPECT_THAT(said(1400), HasSubstr("it is largest at wheel.profile 'worn.txt' (case 1)."));
  EXPECT_THAT(said(900.0000001), HasSubstr("is 900 MPa in all cases."));
}

TEST(Found, StudiesTakeTheFirstSentencesOfTheirPartsAndBeginWithWhatFailed) {
  Record solve = contact({8e4}, {-0.54});
  solve.add("format", "bem_contact result 4");
  Record refused{
      {"study_title", Text{"Wear"}}, {"study_status", Text{"refused"}}, {"study_code", Number{2, "1", ""}}};
  const Record study{{"format", Text{"bem_contact study 1"}},
                     {"parts", Record{{"fatigue", fatigue(1, 0, 0)}, {"solve", solve}, {"wear", refused}}}};
  EXPECT_THAT(found_in(study).sentences,
              ElementsAre("Wear is refused: its part below says why.", HasSubstr("at the gauge corner"),
                          HasSubstr("2628 +- 32 MPa"), HasSubstr("Cracks: yes")));
}

TEST(Found, JsonBeginsWithIt) {
  const auto json = nlohmann::ordered_json::parse(to_json(fatigue(1, 0, 0)));
  EXPECT_EQ(json.begin().key(), "found");
  EXPECT_THAT(json["found"], SizeIs(2));
  EXPECT_THAT(found_text(fatigue(1, 0, 0)), HasSubstr(json["found"][0].get<std::string>()));
  EXPECT_FALSE(nlohmann::ordered_json::parse(to_json({{"model", Text{"fem"}}})).contains("found"));
}

} // namespace
