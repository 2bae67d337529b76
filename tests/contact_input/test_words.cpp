#include "bem_contact/contact_input/words.hpp"

#include <gmock/gmock.h>
#include <numbers>

namespace {

using namespace bem_contact::contact_input;
using ::testing::ElementsAre;

TEST(ContactWords, ARealIsReadAsFortranDoes) {
  const std::pair<const char*, double> numbers[] = {
      {"1", 1},     {"-2.5", -2.5},   {"+.3", 0.3}, {"4.", 4},        {"1.5d-3", 1.5e-3},     {"1E5", 1e5},
      {"2q2", 200}, {"0.1-07", 1e-8}, {"3+2", 300}, {"-1.2D+1", -12}, {"0001203100", 1203100}};
  for (const auto& [word, value] : numbers)
    EXPECT_DOUBLE_EQ(fortran_real(word).value(), value) << word;
  for (const char* word :
       {"", "-", ".", "e5", "1e", "1d+", "1.2.3", "1e5x", "0x10", "nan", "inf", "1e999", "1--2", "FSTAT"})
    EXPECT_FALSE(fortran_real(word)) << word;
}

TEST(ContactWords, AnAngleEndsWithItsUnit) {
  EXPECT_DOUBLE_EQ(fortran_angle("90d").value(), std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(fortran_angle("-0.30r").value(), -0.3);
  EXPECT_DOUBLE_EQ(fortran_angle("0.025").value(), 0.025);
  EXPECT_DOUBLE_EQ(fortran_angle("90d0").value(), 90) << "the d of an exponent: radians";
  EXPECT_FALSE(fortran_angle("d"));
}

TEST(ContactWords, AWholeNumber) {
  EXPECT_EQ(fortran_integer("-1"), -1);
  EXPECT_EQ(fortran_integer("+12"), 12);
  EXPECT_EQ(fortran_integer("1.0"), 1);
  for (const char* word : {"1.5", "1e3", "x", "", "99999999999999999999"})
    EXPECT_FALSE(fortran_integer(word)) << word;
}

TEST(ContactWords, ALineIsSplitAtBlanksTabsCommasAndEqualSigns) {
  EXPECT_THAT(words_of(" 0.3,\t0.4 =5  % remark 6"), ElementsAre("0.3", "0.4", "5"));
  EXPECT_THAT(words_of("'a b.prr' 0 1."), ElementsAre("'a b.prr'", "0", "1."));
  EXPECT_THAT(words_of("0.3 ! 4"), ElementsAre("0.3", "!", "4"))
      << "CONTACT has no other sign of a remark than %";
  EXPECT_THAT(words_of("1 2\r"), ElementsAre("1", "2"));
  EXPECT_TRUE(words_of("% all of it").empty());
  EXPECT_EQ(quoted("'x'"), "x");
  for (const char* word : {"x", "'x", "\"x\"", "'"})
    EXPECT_FALSE(quoted(word)) << word;
}

} // namespace
