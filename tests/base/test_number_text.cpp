#include "bem_contact/base/number_text.hpp"

#include <cmath>
#include <gtest/gtest.h>

using bem_contact::number_of_text;

TEST(NumberText, IsANumberOrNone) {
  for (const auto& [text, value] : {std::pair<const char*, double>{"0", 0},
                                    {"-12.5", -12.5},
                                    {".25", 0.25},
                                    {"7.", 7},
                                    {"1e-3", 1e-3},
                                    {"2E+5", 2e5},
                                    {"0.1", 0.1},
                                    {"6.3000000000000007", 6.3000000000000007}})
    EXPECT_EQ(number_of_text(text), value) << text;
  EXPECT_TRUE(std::isinf(number_of_text("inf").value_or(0)));
  EXPECT_TRUE(std::isnan(number_of_text("nan").value_or(0)));
  for (const char* text :
       {"", " ", " 1", "1 ", "+1", "-", ".", "1e", "1e400", "0x10", "1,5", "1.5.2", "abc", "--1", "-+1"})
    EXPECT_EQ(number_of_text(text), std::nullopt) << text;
  EXPECT_EQ(number_of_text(std::string_view("123456").substr(0, 3)), 123);
}
