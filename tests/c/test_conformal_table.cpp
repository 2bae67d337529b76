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
#include <random>
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
      .columns = {
          {.name = "f", .unit = "MPa", .description = "", .interpolation_error = 0.4, .element_error = 0.1},
          {.name = "g", .unit = "mm", .description = "", .interpolation_error = 0.2, .element_error = 0.05}}};
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
                         .interpolation_error = 0.006,
                         .element_error = 0.004,
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

/// Forces that saturate, over a lateral displacement, a creepage and a load: axes with unequal points.
table::ContactTable saturating() {
  table::ContactTable t{
      .axes = {{"y", "mm", "", {-3, -2.5, -1, 0, 0.5, 2, 3}},
               {"xi", "1", "", {-4e-3, -2e-3, -1e-3, 0, 5e-4, 2e-3, 4e-3}},
               {"load", "N", "", {4e4, 6e4, 9e4}},
               {"yaw", "rad", "", {0, 1e-2}}},
      .columns = {{.name = "Fx", .unit = "N", .description = "", .interpolation_error = 100},
                  {.name = "Fy", .unit = "N", .description = "", .interpolation_error = 200}}};
  t.columns[0].element_error = 20;
  for (std::size_t i = 0; i < t.size(); ++i) {
    const std::vector<double> p = t.point(i);
    t.columns[0].values.push_back(0.3 * p[2] * std::tanh(1e3 * p[1]) * (1 + 0.1 * std::sin(p[0])) +
                                  1e5 * p[3]);
    t.columns[1].values.push_back(p[2] * std::exp(0.5 * p[0]) * (1 + p[3]));
  }
  return t;
}

/// One look-up of both columns of saturating().
struct Looked {
  int code = -1, beyond = 99;
  std::array<double, 2> values{}, errors{};
  std::array<double, 8> slopes{}; ///< [column][axis]
};
Looked looked(const conformal_table* t, const std::array<double, 4>& at) {
  Looked out;
  out.code = conformal_table_force(t, at.data(), 2, out.values.data(), out.slopes.data(), out.errors.data(),
                                   &out.beyond);
  return out;
}

/// The same numbers as the other way to look up, and derivatives that are those of the values.
TEST(CTable, ForcesComeWithTheirDerivatives) {
  const table::ContactTable own = saturating();
  const TableHandle t = opened(own);
  std::mt19937 random(3);
  for (int i = 0; i < 500; ++i) {
    std::array<double, 4> at{};
    for (std::size_t a = 0; a < 4; ++a)
      at[a] = std::uniform_real_distribution<>(own.axes[a].from(), own.axes[a].to())(random);
    const Looked found = looked(t.get(), at);
    ASSERT_EQ(found.code, CONFORMAL_OK);
    EXPECT_EQ(found.beyond, 0);
    EXPECT_EQ(found.errors[0], 120);
    EXPECT_EQ(found.errors[1], 200); // that of its elements is not known
    const std::vector<double> other = table::look_up(own, at);
    for (std::size_t c = 0; c < 2; ++c) {
      EXPECT_NEAR(found.values[c], other[c], 1e-9 * 1e5);
      for (std::size_t a = 0; a < 4; ++a) {
        const double h = 1e-6 * (own.axes[a].to() - own.axes[a].from());
        std::array<double, 4> more = at, less = at;
        more[a] = std::min(at[a] + h, own.axes[a].to());
        less[a] = std::max(at[a] - h, own.axes[a].from());
        const double slope =
            (looked(t.get(), more).values[c] - looked(t.get(), less).values[c]) / (more[a] - less[a]);
        EXPECT_NEAR(found.slopes[4 * c + a] * h, slope * h, 1e-4) << "column " << c << ", axis " << a;
      }
    }
  }
}

/// At the points of the table the derivatives from both sides are one, and small steps across all cells never
/// have a second difference near the stated error.
TEST(CTable, ForcesAreSmoothAcrossCells) {
  const table::ContactTable own = saturating();
  const TableHandle t = opened(own);
  for (std::size_t a = 0; a < 3; ++a) // the last axis has one cell
    for (std::size_t k = 1; k + 1 < own.axes[a].points.size(); ++k) {
      std::array<double, 4> at{0.3, 7e-4, 5.3e4, 4e-3}, below{}, above{};
      at[a] = own.axes[a].points[k];
      below = above = at;
      const double length = own.axes[a].to() - own.axes[a].from();
      below[a] -= 1e-9 * length;
      above[a] += 1e-9 * length;
      const Looked before = looked(t.get(), below), after = looked(t.get(), above);
      for (std::size_t c = 0; c < 2; ++c) {
        EXPECT_NEAR(before.values[c], after.values[c], 1e-2);
        for (std::size_t b = 0; b < 4; ++b)
          EXPECT_NEAR(before.slopes[4 * c + b], after.slopes[4 * c + b],
                      1e-5 * std::abs(after.slopes[4 * c + b]) + 1e-6 * 1e5 / length)
              << "column " << c << ", axis " << b << " at point " << k << " of axis " << a;
      }
    }
  for (double y = -2.999; y < 2.998; y += 1e-3)
    for (std::size_t c = 0; c < 2; ++c) {
      const auto at = [&](double here) { return looked(t.get(), {here, 7e-4, 5.3e4, 4e-3}).values[c]; };
      EXPECT_LT(std::abs(at(y + 1e-3) - 2 * at(y) + at(y - 1e-3)), 1) << y; // N; 100 are stated
    }
}

/// Beyond the table there is a code and a flag, and no number. A million calls of any kind end.
TEST(CTable, NoPlaceGivesAWrongNumber) {
  const table::ContactTable own = saturating();
  const TableHandle t = opened(own);
  std::mt19937 random(5);
  const std::array odd{std::nan(""), 1e308, -1e308, std::numeric_limits<double>::infinity(), 0.0, -0.0};
  int inside = 0;
  for (int i = 0; i < 1000000; ++i) {
    std::array<double, 4> at{};
    bool within = true;
    for (std::size_t a = 0; a < 4; ++a) {
      const double from = own.axes[a].from(), to = own.axes[a].to(), margin = 0.05 * (to - from);
      at[a] = random() % 40 == 0 ? odd[random() % odd.size()]
                                 : std::uniform_real_distribution<>(from - margin, to + margin)(random);
      within = within && at[a] >= from && at[a] <= to;
    }
    std::array<double, 2> values{-7, -7};
    int beyond = 99;
    const int code = conformal_table_force(t.get(), at.data(), 2, values.data(), nullptr, nullptr, &beyond);
    ASSERT_EQ(code, within ? CONFORMAL_OK : CONFORMAL_BEYOND_TABLE);
    ASSERT_EQ(beyond == 0, within);
    ASSERT_TRUE(within ? std::isfinite(values[0]) && std::isfinite(values[1])
                       : values == (std::array<double, 2>{-7, -7}));
    inside += within;
  }
  EXPECT_GT(inside, 300000);
  EXPECT_EQ(looked(t.get(), {-3.1, 0, 5e4, 0}).beyond, -1);
  EXPECT_EQ(looked(t.get(), {0, 0, 1e5, 0}).beyond, 3);
  double value = 0;
  const std::array<double, 4> middle{0, 0, 5e4, 0};
  EXPECT_EQ(conformal_table_force(t.get(), middle.data(), 3, &value, nullptr, nullptr, nullptr),
            CONFORMAL_WRONG_INPUT);
  EXPECT_EQ(conformal_table_force(nullptr, middle.data(), 1, &value, nullptr, nullptr, nullptr),
            CONFORMAL_WRONG_INPUT);
}

} // namespace
