#include "bem_contact/base/error.hpp"

#include "bem_contact/base/said_by.hpp"

#include <gmock/gmock.h>

#include <cstring>
#include <new>

namespace bem_contact {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

TEST(Error, reads_problem_why_what_to_do) {
  const Error error("no rail", "the file is empty", "Give a rail.");
  EXPECT_STREQ(error.what(), "no rail (the file is empty) Give a rail.");
}

TEST(Error, kinds_are_errors) {
  EXPECT_THROW(throw InputError("a", "b", "c"), Error);
  EXPECT_THROW(throw ConvergenceError("a", "b", "c"), Error);
}

/// In quotes, in brackets, as words; twice; and values that hold quotes themselves.
TEST(Error, values_of_any_length_leave_a_message_short) {
  const std::string word(1'000'000, 'a'), words = [] {
    std::string text;
    for (int i = 0; i < 300'000; ++i)
      text += "nan, ";
    return text;
  }();
  for (const std::string& value : {"'" + word + "'", "\"" + words + "\"", "[" + words + "]", word,
                                   "\"a\\\"" + word + "\"", "'" + words + "' and '" + words + "'"}) {
    const std::string message =
        Error("rail.profile = " + value + " is wrong", "no file " + value, "Give one.").what();
    EXPECT_LT(message.size(), 1000u);
    EXPECT_THAT(message, AllOf(StartsWith("rail.profile = "), HasSubstr(" ... "), EndsWith(" Give one.")));
    EXPECT_THAT(message, HasSubstr(" is wrong (no file "));
  }
  std::string quotes;
  for (int i = 0; i < 100'000; ++i)
    quotes += "b' c ";
  EXPECT_LT(std::string(Error("key = '" + quotes + "'", "why", "Do.").what()).size(), 5000u);
}

TEST(Error, what_people_write_stays_as_it_is) {
  const std::string path = "/home/somebody/" + std::string(120, 'p') + "/profiles/worn wheel's profile.txt";
  for (const std::string& text :
       {"The wheel's profile '" + path + "'", std::string("the bodies' [shape] \"x\""),
        std::string("[1, 2) is half open")})
    EXPECT_EQ(Error(text, "a reason", "Do it.").what(), text + " (a reason) Do it.");
}

/// Python and JSON take nothing but UTF-8: no half character, none that is longer than it must be, no
/// surrogate.
TEST(Error, is_UTF_8) {
  const auto said = [](const std::string& text) { return std::string(Error(text, "b", "c").what()); };
  EXPECT_EQ(said("Größe \u2264 \U0001F682"), "Größe \u2264 \U0001F682 (b) c");
  for (const char* wrong : {"\xff", "\x80", "\xc3", "\xc0\xaf", "\xe2\x89", "\xed\xb3\xbf",
                            "\xf0\x80\x80\x80", "\xf5\x80\x80\x80"})
    EXPECT_EQ(said(wrong), std::string(std::strlen(wrong), '?') + " (b) c") << wrong;
  std::string accents;
  while (accents.size() < 1000)
    accents += "é";
  for (const char* before : {"", "x"}) // whichever byte the cut falls on
    EXPECT_THAT(said(before + accents), testing::Not(HasSubstr("?")));
}

TEST(SaidBy, memory_that_ran_out_has_a_remedy) {
  EXPECT_THAT(said_by(std::bad_alloc()), AllOf(StartsWith("Memory ran out ("), HasSubstr("fewer elements")));
  EXPECT_EQ(said_by(std::runtime_error("else")), "else");
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

/// At once: the distance of two such words takes hours.
TEST(NearestNames, a_word_of_thousands_of_letters_is_like_none) {
  EXPECT_THAT(nearest_names(std::string(1'000'000, 'a'), names), IsEmpty());
  EXPECT_THAT(nearest_names("station_width" + std::string(100, 'a'), names), IsEmpty());
}

TEST(NearestNames, best_first_and_no_more_than_asked) {
  const std::vector<std::string> alike{"gauges", "gauge", "gouge"};
  EXPECT_THAT(nearest_names("gauge", alike), ElementsAre("gauge", "gauges", "gouge"));
  EXPECT_THAT(nearest_names("gauge", alike, 1), ElementsAre("gauge"));
}

} // namespace
} // namespace bem_contact
