#include "tests/contact_input/contact_text.hpp"

namespace {

using namespace bem_contact::contact_input;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string next_load = " 6000. -0.02 0. 0.\n";

/// L = 1, C = 1, D = 0, Z = 0: all of it stays; N, F and the load are read in every case.
TEST(ContactCases, WhatACaseKeeps) {
  const auto cases = cases_of(ball_case + case_of("3", {"203100", "100000"}, next_load));
  ASSERT_EQ(cases.size(), 2U);
  EXPECT_EQ(cases[1].number, 2);
  EXPECT_EQ(cases[1].line, 11);
  EXPECT_EQ(cases[1][Data::kinematics]["FN"], 6000);
  for (const Data data : {Data::friction, Data::rolling, Data::material, Data::potential, Data::distance})
    EXPECT_EQ(cases[1][data].line, cases[0][data].line) << name_of(data);
  EXPECT_EQ(cases[1].effective['C'], 2);
  EXPECT_EQ(cases[1].effective['L'], 0);
  EXPECT_TRUE(cases[0].first);
  EXPECT_FALSE(cases[1].first);
}

/// Layer and sheet stay in storage, and the digit says whether they hold.
TEST(ContactCases, WhatADigitSwitchesOff) {
  const std::string layered =
      ball.substr(0, ball.find(" -1")) + " 8200. 1.25 0 0 GG3\n" + ball.substr(ball.find(" -1"));
  const auto cases =
      cases_of(case_of("3", {"203100", "022420"}, layered) + case_of("3", {"203100", "100000"}, next_load) +
               case_of("3", {"203100", "100400"}, next_load));
  EXPECT_EQ(cases[1].digits['M'], 0);
  EXPECT_EQ(cases[2].digits['M'], 4);
  EXPECT_EQ(cases[2][Data::layer]["LAYTHK"], 1.25);
}

/// Modules, result elements and contact patches have data of their own.
TEST(ContactCases, ResultElements) {
  const std::string other =
      case_of("3 2", {"203100", "022020"}, " 1. 0 0 0\n 0.5 0.5\n" + ball.substr(ball.find(" 0d")));
  const auto cases = cases_of(
      case_of("3 1", {"203100", "022020"}, ball) + other + case_of("3 1", {"203100", "100000"}, next_load) +
      case_of("3 2", {"203100", "100000"}, next_load) + case_of("3 2 3", {"203100", "022020"}, ball));
  EXPECT_EQ(cases[2][Data::friction].at(0, 0), 0.3);
  EXPECT_EQ(cases[3][Data::friction].at(0, 0), 0.5);
  EXPECT_EQ(cases[4].patch, 3);
  EXPECT_TRUE(cases[4].first);
  EXPECT_THAT(error_of(wheel_case + case_of("3", {"203100", "100000"}, next_load)),
              HasSubstr("L = 1 keeps the law of friction"));
}

/// R = 0 and 2 stay in the module: the next case has no line MODULE.
TEST(ContactCases, RStaysInTheModule) {
  const std::string next = " 203100\n 100000\n 0101111\n 6000. -0.02 0. 0.\n";
  for (const char* third : {"0101110", "0101112"}) {
    const auto cases = cases_of(case_of("3", {"203100", "022020", third}, ball) + next);
    ASSERT_EQ(cases.size(), 2U) << third;
    EXPECT_EQ(cases[1][Data::kinematics]["FN"], 6000);
  }
}

/// A number behind the last value that is read would be lost: it is noted.
TEST(ContactCases, NumbersBehindTheLastValue) {
  std::string lines = ball;
  lines.replace(lines.find("0.3 0.3 FSTAT"), 13, "0.3 0.3 0.2 FSTAT");
  EXPECT_THAT(
      cases_of(case_of("3", {"203100", "022020"}, lines))[0].remarks,
      ElementsAre(HasSubstr("line 6: '0.2' stands behind FSTAT, FKIN, where CONTACT reads a remark")));
  EXPECT_THAT(cases_of(ball_case)[0].remarks, IsEmpty());
}

TEST(ContactCases, AByteOrderMarkAndOtherLineEnds) {
  std::string text = "\xEF\xBB\xBF" + ball_case;
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2)
    text.replace(at, 1, "\r\n");
  EXPECT_EQ(cases_of(text)[0][Data::kinematics]["FN"], 5000);
}

/// The cases before a broken one stand; the message has line, name, word, and what CONTACT would take.
TEST(ContactCases, ABrokenFile) {
  const CasesRead read = read_cases(ball_case + case_of("3", {"203100", "022020"}, " 1 2 x 4\n"), "x.inp");
  EXPECT_EQ(read.cases.size(), 1U);
  ASSERT_TRUE(read.broken);
  EXPECT_STREQ(read.broken->what(), "x.inp:15: CETA cannot be read ('x' is not a number) CONTACT takes a "
                                    "number here, of the values FN, CKSI, CETA, "
                                    "CPHI, SPINXO (may be missing), SPINYO (may be missing).");
  EXPECT_THAT(read_cases("", "x.inp").broken->what(),
              HasSubstr("MODULE cannot be read (the file ends here)"));
  EXPECT_THAT(read_cases(" 0 MODULE\n", "x.inp").broken->what(), HasSubstr("has no case"));
  EXPECT_THAT(error_of(wheel_case.substr(0, wheel_case.find("'wheel.prw'")) + " \"wheel.prw\" 0 1 0\n"),
              HasSubstr("FNAME cannot be read ('\"wheel.prw\"' is not a text in single quotes)"));
}

} // namespace
