#include "bem_contact/c/conformal_contact.h"
#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/uses/table/table_file.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <regex>
#include <set>
#include <string>
#include <thread>
#include <unistd.h>
#include <vector>

using namespace bem_contact;
using testing::HasSubstr;

namespace {

struct CloseTable {
  void operator()(conformal_table* handle) const { conformal_table_close(handle); }
};
using TableHandle = std::unique_ptr<conformal_table, CloseTable>;

/// Two columns over two axes: f = 10 x + y, and twice that.
table::ContactTable plane() {
  table::ContactTable t{
      .axes = {{"x", "mm", "", {0, 1, 3}}, {"y", "N", "", {0, 5}}},
      .columns = {{.name = "f", .unit = "MPa", .description = "", .interpolation_error = 0.5},
                  {.name = "g", .unit = "mm", .description = "", .interpolation_error = 0.25}}};
  for (std::size_t i = 0; i < t.size(); ++i) {
    const std::vector<double> p = t.point(i);
    t.columns[0].values.push_back(10 * p[0] + p[1]);
    t.columns[1].values.push_back(2 * t.columns[0].values.back());
  }
  return t;
}

/// A creep table in full slip along x everywhere.
table::ContactTable slipping() {
  table::ContactTable t;
  for (const char* name : {"log10_a_over_b", "alpha", "beta", "t"})
    t.axes.push_back({name, "1", "", {-2, 2}});
  for (const auto& [name, value] : {std::pair("Fx", 1.0), {"Fy", 0.0}, {"Mz", 0.5}})
    t.columns.push_back({.name = name,
                         .unit = "1",
                         .description = "",
                         .interpolation_error = 0.01,
                         .values = std::vector<double>(16, value)});
  t.scale = table::CreepScale{{-2, 2}, {4, 4}, {4, 4}, 0.28};
  return t;
}

TableHandle opened(const table::ContactTable& t) {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("conformal_table_" + std::to_string(getpid()) + ".h5");
  table::write_table(file, {{"format", record::Text{table_format}}}, t);
  conformal_table* handle = nullptr;
  char message[500] = "?";
  EXPECT_EQ(conformal_table_open(file.c_str(), &handle, message, sizeof message), CONFORMAL_OK) << message;
  EXPECT_STREQ(message, "");
  std::filesystem::remove(file);
  return TableHandle(handle);
}

TEST(CTable, GivesNamesUnitsValuesAndErrors) {
  const TableHandle t = opened(plane());
  int axes = 0, columns = 0, g = -1;
  ASSERT_EQ(conformal_table_size(t.get(), &axes, &columns), CONFORMAL_OK);
  EXPECT_EQ(axes, 2);
  EXPECT_EQ(columns, 2);
  const char *name = nullptr, *unit = nullptr;
  double from = -1, to = -1, error = -1;
  ASSERT_EQ(conformal_table_axis(t.get(), 0, &name, &unit, &from, &to), CONFORMAL_OK);
  EXPECT_STREQ(name, "x");
  EXPECT_STREQ(unit, "mm");
  EXPECT_EQ(from, 0);
  EXPECT_EQ(to, 3);
  ASSERT_EQ(conformal_table_find(t.get(), "g", &g), CONFORMAL_OK);
  ASSERT_EQ(conformal_table_column(t.get(), g, &name, nullptr, &error), CONFORMAL_OK);
  EXPECT_STREQ(name, "g");
  EXPECT_EQ(error, 0.25);
  const double at[] = {2, 4};
  double values[2] = {}, errors[2] = {};
  ASSERT_EQ(conformal_table_look_up(t.get(), at, 2, values, errors, 2, nullptr, 0), CONFORMAL_OK);
  EXPECT_NEAR(values[0], 24, 1e-12);
  EXPECT_NEAR(values[g], 48, 1e-12);
  EXPECT_EQ(errors[g], 0.25);
  EXPECT_EQ(conformal_table_look_up(t.get(), at, 2, values, nullptr, 1, nullptr, 0), CONFORMAL_OK);
}

/// Values are over mu N, and Mz over mu N R, R^2 = (a^2 + b^2)/2.
TEST(CTable, CreepForcesHaveTheUnitsOfTheCaller) {
  const TableHandle t = opened(slipping());
  const double ellipse[CONFORMAL_ELLIPSE_VALUES] = {9, 4, 8e4, 3e4, -1e-3, 0, 0};
  double forces[3], errors[3];
  ASSERT_EQ(conformal_table_creep_forces(t.get(), ellipse, forces, errors, nullptr, 0), CONFORMAL_OK);
  EXPECT_NEAR(forces[0], -3e4, 1e-8);
  EXPECT_NEAR(forces[2], 0.5 * std::sqrt(48.5) * 3e4, 1e-8);
  EXPECT_NEAR(errors[0], 300, 1e-10);
  EXPECT_NEAR(errors[2], 300 * std::sqrt(48.5), 1e-9);
}

TEST(CTable, SaysWhatIsWrong) {
  char message[500];
  conformal_table* none = nullptr;
  EXPECT_EQ(conformal_table_open("no/such.h5", &none, message, sizeof message), CONFORMAL_WRONG_INPUT);
  EXPECT_EQ(none, nullptr);
  EXPECT_THAT(message, HasSubstr("no/such.h5"));
  EXPECT_EQ(conformal_table_open(nullptr, nullptr, message, sizeof message), CONFORMAL_WRONG_INPUT);
  const TableHandle t = opened(plane());
  int count = 0;
  EXPECT_EQ(conformal_table_size(nullptr, &count, &count), CONFORMAL_WRONG_INPUT);
  EXPECT_EQ(conformal_table_axis(t.get(), 2, nullptr, nullptr, nullptr, nullptr), CONFORMAL_WRONG_INPUT);
  EXPECT_EQ(conformal_table_column(t.get(), -1, nullptr, nullptr, nullptr), CONFORMAL_WRONG_INPUT);
  EXPECT_EQ(conformal_table_find(t.get(), "h", &count), CONFORMAL_WRONG_INPUT);
  const double outside[] = {3.1, 4};
  double values[2] = {7, 7};
  const auto refused = [&](int code) {
    EXPECT_EQ(code, CONFORMAL_WRONG_INPUT);
    EXPECT_EQ(values[0], 7);
    return std::string(message);
  };
  const auto look_up = [&](const double* at, int axes, int columns) {
    return conformal_table_look_up(t.get(), at, axes, values, nullptr, columns, message, sizeof message);
  };
  EXPECT_THAT(refused(look_up(outside, 2, 2)), HasSubstr("x = 3.1 is outside the table"));
  EXPECT_THAT(refused(look_up(outside, 1, 2)), HasSubstr("it has 2 axes"));
  EXPECT_THAT(refused(look_up(outside, -1, 2)), HasSubstr("it has 2 axes"));
  EXPECT_THAT(refused(look_up(outside, 2, 3)), HasSubstr("the table has 2"));
  EXPECT_THAT(refused(look_up(nullptr, 2, 2)), HasSubstr("null pointer"));
  const double ellipse[CONFORMAL_ELLIPSE_VALUES] = {9, 4, 8e4, 3e4, 1e-3, 0, 0};
  EXPECT_THAT(
      refused(conformal_table_creep_forces(t.get(), ellipse, values, nullptr, message, sizeof message)),
      HasSubstr("one of a scene"));
  const TableHandle creep = opened(slipping());
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, CONFORMAL_ELLIPSE_VALUES> wrong;
  for (const auto& [index, value, words] : {std::tuple(CONFORMAL_ELLIPSE_A, 1e4, "is outside the table"),
                                            {CONFORMAL_ELLIPSE_B, 0.0, "must be positive"},
                                            {CONFORMAL_ELLIPSE_A, infinity, "must be positive"},
                                            {CONFORMAL_ELLIPSE_MODULUS, infinity, "must be positive"},
                                            {CONFORMAL_ELLIPSE_BOUND, infinity, "must be positive"},
                                            {CONFORMAL_ELLIPSE_XI, infinity, "creepages finite"},
                                            {CONFORMAL_ELLIPSE_MODULUS, 1e308, "the largest number"},
                                            {CONFORMAL_ELLIPSE_PHI, std::nan(""), "creepages finite"}}) {
    std::ranges::copy(ellipse, wrong.begin());
    wrong[index] = value;
    EXPECT_THAT(refused(conformal_table_creep_forces(creep.get(), wrong.data(), values, nullptr, message,
                                                     sizeof message)),
                HasSubstr(words));
  }
}

TEST(CTable, ThreadsShareATable) {
  const TableHandle t = opened(plane());
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&t, i] {
      for (int k = 0; k < 1000; ++k) {
        const double at[] = {0.003 * k, 1.0 * i};
        double value = 0;
        char message[100];
        ASSERT_EQ(conformal_table_look_up(t.get(), at, 2, &value, nullptr, 1, message, sizeof message),
                  CONFORMAL_OK);
        ASSERT_NEAR(value, 10 * at[0] + at[1], 1e-12);
      }
    });
  for (std::thread& thread : threads)
    thread.join();
}

/// The build writes the constants of the header into Fortran's module, with their values.
TEST(CTable, FortranHasEveryConstant) {
  const auto constants_of = [](const std::string& file, const char* pattern) {
    std::ifstream in(file);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    const std::regex constant(pattern, std::regex::icase);
    std::map<std::string, std::string> out;
    for (std::sregex_iterator i(text.begin(), text.end(), constant), end; i != end; ++i) {
      std::string name = (*i)[1];
      std::ranges::transform(name, name.begin(),
                             [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
      out[name] = (*i)[2];
    }
    return out;
  };
  auto in_c = constants_of(CONFORMAL_SOURCE_DIR "/bem_contact/c/conformal_contact.h",
                           "#define (CONFORMAL_\\w+)[ \\\\\n]+(\\d+)");
  EXPECT_EQ(in_c.extract("conformal_totals").mapped(), "13"); // the name of a function
  auto in_fortran = constants_of(CONFORMAL_BINARY_DIR "/bem_contact/c/conformal_contact.f90",
                                 "parameter :: (conformal_\\w+) = (\\d+)");
  EXPECT_EQ(in_fortran.extract("conformal_totals_count").mapped(), "13");
  EXPECT_GT(in_c.size(), 70u);
  EXPECT_EQ(in_fortran, in_c);
}

/// The module for Fortran declares the functions of the header, all of them.
TEST(CTable, FortranHasEveryFunction) {
  const auto functions_of = [](const char* file, const char* pattern) {
    std::ifstream in(std::string(CONFORMAL_SOURCE_DIR "/bem_contact/c/") + file);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    const std::regex declaration(pattern);
    std::set<std::string> out;
    for (std::sregex_iterator i(text.begin(), text.end(), declaration), end; i != end; ++i)
      out.insert((*i)[1]);
    return out;
  };
  const auto in_c = functions_of("conformal_contact.h", "\n(?:int|void|const char\\*) (conformal_\\w+)\\(");
  EXPECT_GT(in_c.size(), 20u);
  EXPECT_EQ(functions_of("conformal_contact.f90.in", "(?:function|subroutine) (conformal_\\w+)\\("), in_c);
}

} // namespace
