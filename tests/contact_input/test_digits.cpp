#include "tests/contact_input/contact_text.hpp"

namespace {

using namespace bem_contact::contact_input;
using ::testing::HasSubstr;

TEST(ContactDigits, EachHasItsPlace) {
  const Digits d = cases_of(case_of("3", {"203100", "022020"}, ball))[0].digits;
  const std::pair<char, int> values[] = {{'P', 2}, {'B', 0}, {'T', 3}, {'N', 1}, {'F', 0}, {'S', 0},
                                         {'V', 0}, {'L', 0}, {'D', 2}, {'C', 2}, {'M', 0}, {'Z', 2},
                                         {'E', 0}, {'m', 1}, {'X', 0}, {'H', 0}, {'G', 1}, {'I', 0},
                                         {'A', 1}, {'O', 1}, {'W', 1}, {'R', 1}};
  for (const auto& [letter, value] : values)
    EXPECT_EQ(d[letter], value) << letter;
}

TEST(ContactDigits, XReadsALine) {
  const auto cases = cases_of(case_of("3", {"203100", "022020", "10101111"}, " 1010200 4 PSFLCIN\n" + ball));
  EXPECT_EQ(cases[0].digits['X'], 1);
  EXPECT_EQ(cases[0][Data::kinematics]["FN"], 5000);
}

/// The second number of the second line is M2, with the weight of the gap in front.
TEST(ContactDigits, M2StandsBehindTheSecondLine) {
  const auto cases = cases_of(case_of("3", {"203100", "022020 12 V"},
                                      " 5000. 0 0 0\n 0.3 0.3\n 0 0.2 3000.\n 0.28 0.28 1. 1.\n"
                                      " 1 2 3 4 CDAMPN\n -1\n 4 4 1 1 1.2\n"));
  EXPECT_EQ(cases[0].digits['m'], 2);
  EXPECT_EQ(cases[0].digits['g'], 1);
  EXPECT_EQ(cases[0][Data::damping]["DFTMAX"], 4);
}

/// What CONTACT does not accept is an error with the line, the digit and what is accepted.
TEST(ContactDigits, WhatCONTACTDoesNotAccept) {
  EXPECT_THAT(
      error_of(case_of("3", {"203100", "022028"}, ball)),
      HasSubstr("x.inp:3: The digit E (extra rigid slip) is 8 (CONTACT takes 0, 1, 2, 3, 9 in module 3)"));
  EXPECT_THAT(error_of(case_of("1", {"1203120", "0022033"}, wheel)),
              HasSubstr("x.inp:2: The digit F (tangential forces) is 2"));
  EXPECT_THAT(error_of(case_of("3", {"203100", "1022020"}, ball)),
              HasSubstr("The digit V (variation of friction) is 1"));
  EXPECT_THAT(error_of(case_of("3", {"203100", "522020"}, ball)),
              HasSubstr("The digit L (law of friction) is 5"));
  EXPECT_THAT(error_of(case_of("3", {"203100123", "022020"}, ball)), HasSubstr("does not have the 7 digits"));
  EXPECT_THAT(error_of(case_of("3", {"-203100", "022020"}, ball)), HasSubstr("does not have the 7 digits"));
  EXPECT_THAT(error_of(case_of("2", {"203100", "022020"}, ball)), HasSubstr("x.inp:1: MODULE is 2"));
}

} // namespace
