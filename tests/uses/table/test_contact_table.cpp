#include "bem_contact/base/error.hpp"
#include "bem_contact/h5/table.hpp"
#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/uses/table/refine.hpp"
#include "bem_contact/uses/table/table_file.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <numbers>
#include <random>
#include <sstream>
#include <unistd.h>

namespace {

using namespace bem_contact;
using namespace bem_contact::table;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

using Function = double (*)(const Point&);

/// A table of one function over two axes, 0 .. 1 and 2 .. 4.
ContactTable plane() {
  return {.axes = {{"x", "mm", "", {0, 0.5, 1}}, {"y", "N", "", {2, 3, 4}}},
          .columns = {{.name = "f", .unit = "1/mm", .description = ""}}};
}

PointsSolver solver_of(Function f) {
  return one_by_one([f](const Point& p) { return PointValues{{f(p)}, {std::nan("")}}; });
}

ContactTable refined(Function f, const Wanted& wanted) {
  ContactTable table = plane();
  refine(table, solver_of(f), wanted);
  return table;
}

double steep(const Point& p) {
  return std::tanh(20 * (p[0] - 0.3)) + 0.5 * p[1];
}

double quadratic(const Point& p) {
  return (1 + 2 * p[0] - p[0] * p[0]) * (3 - p[1] + 0.5 * p[1] * p[1]);
}

/// Of a function that is quadratic in each coordinate, nothing is lost; beyond the ends it is constant.
TEST(ContactTable, InterpolationIsExactForParabolas) {
  ContactTable t = refined(quadratic, {});
  EXPECT_EQ(t.size(), 9u);
  for (const Point& p : {Point{0.3, 2.7}, Point{0.9, 2.1}, Point{0.5, 3.3}, Point{1, 4}, Point{0, 2}})
    EXPECT_NEAR(interpolate(t, t.columns[0], p), quadratic(p), 1e-14);
  EXPECT_NEAR(interpolate(t, t.columns[0], Point{-5, 2.5}), quadratic({0, 2.5}), 1e-14);
  EXPECT_NEAR(interpolate(t, t.columns[0], Point{9, 99}), quadratic({1, 4}), 1e-14);
  EXPECT_NEAR(t.columns[0].interpolation_error, 0, 1e-14);
  EXPECT_THROW(interpolate(t, t.columns[0], Point{1}), InputError);
  t.axes[0].points = {0, 1}; // two points: a line
  t.axes[1].points = {2, 4};
  t.columns[0].values = {0, 2, 4, 10};
  EXPECT_NEAR(interpolate(t, t.columns[0], Point{0.25, 3}), 0.75 * 1 + 0.25 * 7, 1e-14);
}

/// What is outside is refused, and so is nan; a point at the end may be off by rounding.
TEST(ContactTable, LooksUpWithinItsAxesOnly) {
  const ContactTable t = refined(quadratic, {});
  EXPECT_NEAR(look_up(t, Point{0.3, 2.7}).at(0), quadratic({0.3, 2.7}), 1e-14);
  EXPECT_NEAR(look_up(t, Point{1, 4 + 1e-15}).at(0), quadratic({1, 4}), 1e-14);
  for (const Point& p :
       {Point{-0.1, 3}, Point{1.1, 3}, Point{0.5, 4.1}, Point{std::nan(""), 3}, Point{1}, Point{}})
    EXPECT_THROW(look_up(t, p), InputError);
  EXPECT_THROW(require_coordinates(t, 0), InputError);
  EXPECT_NO_THROW(require_coordinates(t, 2));
  try {
    look_up(t, Point{0.5, 5});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("y = 5 is outside the table (its axis goes from 2 to 4 N)"));
  }
}

/// Points come where the function bends, and on no axis along which it is straight.
TEST(Refine, MeetsTheToleranceAtPointsNotUsed) {
  const ContactTable t = refined(steep, {.tolerance = 0.01});
  EXPECT_LE(t.columns[0].interpolation_error, 0.01);
  EXPECT_GT(t.columns[0].interpolation_error, 0.001);
  EXPECT_THAT(t.axes[1].points, ElementsAre(2, 3, 4));
  const auto inside = [&](double from, double to) {
    return std::ranges::count_if(t.axes[0].points, [=](double x) { return x > from && x < to; });
  };
  EXPECT_GT(inside(0.2, 0.4), 2 * inside(0.6, 1));
  EXPECT_EQ(t.checked, (t.axes[0].points.size() - 1) * 2);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> x(0, 1), y(2, 4);
  for (int i = 0; i < 200; ++i) {
    const Point p{x(random), y(random)};
    EXPECT_NEAR(interpolate(t, t.columns[0], p), steep(p), 0.011)
        << p[0]; // two points of a cell are not quite the worst
  }
}

double cubic(const Point& p) {
  return p[0] * p[0] * p[0] + 0.1 * std::pow(p[1] - 3, 3);
}

/// Of x^3 the middles of equal intervals are exact, and what lies beside them is off by h^3 / (6 sqrt(3)),
/// because slopes of parabolas are off by h^2. The stated error is at least that. (In the last interval,
/// where the parabola goes on, the error is 1.026 times that of the middle.)
TEST(Refine, TheStatedErrorIsMoreThanMiddlesShow) {
  ContactTable t = plane();
  t.axes[0].points = {0, 0.25, 0.5, 0.75, 1};
  t.axes[1].points = {2, 2.5, 3, 3.5, 4};
  refine(t, solver_of(cubic), {.tolerance = 1});
  EXPECT_EQ(t.size(), 25u);
  EXPECT_EQ(t.checked, 16u);
  EXPECT_GE(t.solved, 25u + 2 * 16);
  EXPECT_NEAR(interpolate(t, t.columns[0], Point{0.375, 3.25}), cubic({0.375, 3.25}), 1e-14);
  const double off_x = std::pow(0.25, 3) * std::sqrt(3) / 18, x = 0.375 - 0.25 * std::sqrt(3) / 6;
  EXPECT_NEAR(std::abs(interpolate(t, t.columns[0], Point{x, 3.25}) - cubic({x, 3.25})), off_x, 1e-14);
  EXPECT_GE(t.columns[0].interpolation_error, off_x);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> all_x(0, 1), all_y(2, 4);
  for (int i = 0; i < 500; ++i) {
    const Point p{all_x(random), all_y(random)};
    EXPECT_NEAR(interpolate(t, t.columns[0], p), cubic(p), 1.03 * t.columns[0].interpolation_error)
        << p[0] << " " << p[1];
  }
}

/// What is uneven within every cell, and least in the middles.
double uneven(const Point& p) {
  return 0.03 * std::sin(8 * std::numbers::pi * p[0]) + p[1];
}

/// All middles are met, and no cell is: points beside them say so.
TEST(Refine, MiddlesAloneDoNotPass) {
  const ContactTable t = refined(uneven, {.tolerance = 0.01});
  EXPECT_GT(t.axes[0].points.size(), 8u);
  EXPECT_EQ(t.axes[1].points.size(), 3u);
  for (double x = 0; x < 1; x += 0.01)
    EXPECT_NEAR(interpolate(t, t.columns[0], Point{x, 2.7}), uneven({x, 2.7}), 0.011) << x;
}

/// A second contact begins: the function jumps.
double with_jump(const Point& p) {
  return 0.3 * p[0] + (p[0] + 0.1 * p[1] > 0.91 ? 0.2 : 0.0);
}

double with_bend(const Point& p) {
  return 0.2 * p[0] + 2 * std::max(0.0, p[0] - 0.375) + 0.01 * p[1];
}

/// Middles of cells tell of half of a jump; the stated error is all of it, and no more points are taken for
/// it.
TEST(Refine, TheStatedErrorCoversAJump) {
  const ContactTable t = refined(with_jump, {.tolerance = 0.13});
  const double stated = t.columns[0].interpolation_error;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> x(0, 1), y(2, 4);
  double worst = 0;
  int outside = 0;
  for (int i = 0; i < 2000; ++i) {
    const Point p{x(random), y(random)};
    const double off = std::abs(interpolate(t, t.columns[0], p) - with_jump(p));
    worst = std::max(worst, off);
    outside += off > stated;
  }
  EXPECT_GT(worst, 0.14) << "this test would say nothing";
  EXPECT_LT(outside, 100);
  EXPECT_NEAR(stated, 0.2, 0.1);
}

/// Where a function merely bends, the stated error is what the middles say.
TEST(Refine, ABendIsNoJump) {
  const ContactTable t = refined(with_bend, {.tolerance = 0.2});
  EXPECT_LE(t.columns[0].interpolation_error, 0.2);
}

/// The plane with a line of points of its own at each x.
ContactTable nested_plane() {
  ContactTable t = plane();
  t.axes[1] = {"y", "N", "", {2, 3, 4, 2, 3, 4, 2, 3, 4}, {0, 3, 6, 9}};
  return t;
}

/// Points and weights by hand: the lines at x = 0, 0.5 and 1 have one, two and three points.
TEST(NestedAxes, EachPointHasItsOwnLine) {
  ContactTable t = plane();
  t.axes[1] = {"y", "N", "", {0, 2, 4, 2, 3, 4}, {0, 1, 3, 6}};
  t.columns[0].values = {7, 10, 20, 1, 5, 2};
  EXPECT_EQ(t.size(), 6u);
  EXPECT_EQ(t.point(0), (Point{0, 0}));
  EXPECT_EQ(t.point(2), (Point{0.5, 4}));
  EXPECT_EQ(t.point(4), (Point{1, 3}));
  EXPECT_EQ(t.axes[1].from(), 2);
  EXPECT_EQ(t.axes[1].to(), 4);
  EXPECT_NEAR(interpolate(t, t.columns[0], Point{0, 2.7}), 7, 1e-14);      // a single point: constant
  EXPECT_NEAR(interpolate(t, t.columns[0], Point{0.5, 2.5}), 12.5, 1e-14); // two points: a line
  EXPECT_NEAR(interpolate(t, t.columns[0], Point{1, 3}), 5, 1e-14);
  // At y = 3 the lines say 7, 15 and 5: the parabola through these.
  EXPECT_NEAR(interpolate(t, t.columns[0], Point{0.25, 3}), 0.375 * 7 + 0.75 * 15 - 0.125 * 5, 1e-13);
}

TEST(NestedAxes, InterpolationIsExactForParabolas) {
  ContactTable t = nested_plane();
  refine(t, solver_of(quadratic), {});
  EXPECT_EQ(t.size(), 9u);
  EXPECT_EQ(t.checked, 4u);
  EXPECT_EQ(t.solved, 13u);
  for (const Point& p : {Point{0.3, 2.7}, Point{0.9, 2.1}, Point{0.5, 3.3}, Point{1, 4}, Point{0, 2}})
    EXPECT_NEAR(interpolate(t, t.columns[0], p), quadratic(p), 1e-14);
}

/// A ridge across the corner.
double ridge(const Point& p) {
  return std::tanh(10 * (p[0] + 0.5 * p[1] - 2.2));
}

/// Lines get points only where the ridge crosses them, fewer than the tensor takes.
TEST(NestedAxes, PointsComeOnlyWhereTheFunctionBends) {
  ContactTable nested = nested_plane(), tensor = plane();
  refine(nested, solver_of(ridge), {.tolerance = 0.02});
  refine(tensor, solver_of(ridge), {.tolerance = 0.02});
  EXPECT_LT(nested.size(), 0.7 * static_cast<double>(tensor.size()));
  EXPECT_LE(nested.columns[0].interpolation_error, 0.02);
  EXPECT_GT(nested.columns[0].interpolation_error, 0.002);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> x(0, 1), y(2, 4);
  double worst = 0;
  for (int i = 0; i < 500; ++i) {
    const Point p{x(random), y(random)};
    worst = std::max(worst, std::abs(interpolate(nested, nested.columns[0], p) - ridge(p)));
  }
  fmt::print("{} points, {} of a tensor; off by up to {:.3f}\n", nested.size(), tensor.size(), worst);
  EXPECT_LE(worst, 0.03); // the middle of a cell is not quite the worst
}

/// The slope is continuous across the points of the outer axis, whatever lines they have.
TEST(NestedAxes, SlopeIsContinuous) {
  ContactTable t = nested_plane();
  refine(t, solver_of(ridge), {.tolerance = 0.02});
  const double h = 1e-6;
  const auto at = [&](double x) { return interpolate(t, t.columns[0], Point{x, 2.7}); };
  for (std::size_t i = 1; i + 1 < t.axes[0].points.size(); ++i) {
    const double x = t.axes[0].points[i];
    EXPECT_NEAR((at(x + h) - at(x)) / h, (at(x) - at(x - h)) / h, 1e-3) << x;
  }
}

/// An error relative to a larger scale, or of a column that is not held, adds no point.
TEST(Refine, LooksAtHeldColumnsByTheirScale) {
  ContactTable t = plane();
  t.columns[0].scale = 1000;
  t.columns.push_back({.name = "g", .unit = "", .description = "", .held = false});
  refine(t, one_by_one([](const Point& p) {
           return PointValues{{steep(p), 1e9 * std::pow(p[0], 4)}, {0.1, 0.2}};
         }),
         {});
  EXPECT_EQ(t.size(), 9u);
  EXPECT_GT(t.columns[1].interpolation_error, 1e7);
  EXPECT_EQ(t.columns[1].element_error, 0.2);
}

TEST(Refine, SaysWhereTheToleranceIsNotMet) {
  const auto jump = [](const Point& p) { return p[0] < 0.7 ? 0.0 : 1.0; };
  try {
    refined(jump, {.tolerance = 0.01, .most_points = 60});
    FAIL();
  } catch (const ConvergenceError& error) {
    for (const char* part :
         {"not within 1 %", "f is still off by", "x = 0.", "60 are allowed", "--most-points"})
      EXPECT_THAT(error.what(), HasSubstr(part));
  }
  ContactTable nested = nested_plane();
  EXPECT_THROW(refine(nested, solver_of(jump), {.tolerance = 0.01, .most_points = 60}), ConvergenceError);
  EXPECT_THROW(refine(nested, solver_of([](const Point&) { return std::nan(""); }), {}), InputError);
  EXPECT_THROW(refined(jump, {.most_points = 8}), InputError);
  EXPECT_THROW(refined(jump, {.tolerance = 0}), InputError);
  EXPECT_THROW(refined([](const Point&) { return std::nan(""); }, {}), InputError);
}

const record::Record table_head{{"format", record::Text{table_format}}};

/// A table is looked up for years: no bit of a number changes unseen. One without checksums is read, with a
/// remark.
TEST(TableFile, HasAChecksumForEachNumber) {
  const ContactTable t = refined(steep, {.tolerance = 0.1});
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / fmt::format("checked_{}.h5", getpid());
  write_table(file, table_head, t);
  std::ostringstream bytes;
  bytes << std::ifstream(file, std::ios::binary).rdbuf();
  const std::string whole = bytes.str();
  const auto read_with = [&](std::size_t at, int bit) {
    std::string flipped = whole;
    flipped[at] = static_cast<char>(flipped[at] ^ (1 << bit));
    std::ofstream(file, std::ios::binary) << flipped;
    return read_table(file);
  };
  for (const Column& column : t.columns)
    for (const double number : {column.values.front(), column.values.back(), column.scale}) {
      const std::string stored(reinterpret_cast<const char*>(&number), sizeof number);
      const std::size_t at = whole.find(stored);
      ASSERT_NE(at, std::string::npos);
      for (int bit = 0; bit < 64; bit += 3)
        EXPECT_THROW(read_with(at + bit / 8, bit % 8), InputError) << bit;
    }
  write_table(file, table_head, t);
  H5Table old = read_h5(file);
  old.checksums = false;
  write_h5(file, old);
  testing::internal::CaptureStderr();
  EXPECT_EQ(read_table(file).columns[0].values, t.columns[0].values);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("has no checksums"));
  old.datasets["values/" + t.columns[0].name].values[0] = std::nan(""); // not known there
  write_h5(file, old);
  EXPECT_TRUE(std::isnan(read_table(file).columns[0].values[0]));
  old.datasets["axes/x"].values[0] = std::nan("");
  write_h5(file, old);
  EXPECT_THROW(read_table(file), InputError);
  std::filesystem::remove(file);
}

/// The scene that a table of a scene was made from, and the option of one of creep forces.
TEST(TableFile, OfAnotherVersionIsRefusedWithTheCommandThatMakesItAnew) {
  const ContactTable t = refined(steep, {.tolerance = 0.1});
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / fmt::format("old_table_{}.h5", getpid());
  const auto message = [&](const char* format, const char* scene, const ContactTable& table) {
    record::Record head{{"format", record::Text{format}}};
    if (scene)
      head.add("scene", record::Text{scene});
    write_table(file, head, table);
    try {
      read_table(file);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("it was read");
  };
  EXPECT_EQ(message(table_format, "my.toml", t), "it was read");
  EXPECT_THAT(message("bem_contact table 3", "my.toml", t),
              AllOf(HasSubstr("'bem_contact table 3', today's is 'bem_contact table 4'"),
                    HasSubstr("Make it again: bem_contact table my.toml -o " + file.string())));
  EXPECT_THAT(message("bem_contact table 5", nullptr, t), HasSubstr("bem_contact table SCENE.toml -o "));
  ContactTable creep = t;
  creep.scale = CreepScale{{0, 1}, {4, 4}, {4, 4}, 0.28};
  EXPECT_THAT(message("bem_contact table 3", nullptr, creep),
              HasSubstr("bem_contact table --creep-forces -o "));
  std::filesystem::remove(file);
}

TEST(TableFile, IsReadAsItWasWritten) {
  ContactTable t = refined(steep, {.tolerance = 0.1});
  t.scale = {{-1, 0, 1}, {3, 4, 5}, {3.5, 4.5, 5.5}, 0.28};
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / fmt::format("table_{}.h5", getpid());
  write_table(file, table_head, t);
  const ContactTable read = read_table(file);
  EXPECT_EQ(read.axes[1].name, "y");
  EXPECT_EQ(read.axes[0].unit, "mm");
  EXPECT_EQ(read.axes[0].points, t.axes[0].points);
  EXPECT_EQ(read.columns[0].values, t.columns[0].values);
  EXPECT_EQ(read.columns[0].interpolation_error, t.columns[0].interpolation_error);
  EXPECT_EQ(read.scale->c22, t.scale->c22);
  EXPECT_EQ(read.solved, t.solved);
  ContactTable nested = nested_plane();
  refine(nested, solver_of(steep), {.tolerance = 0.1});
  write_table(file, table_head, nested);
  EXPECT_EQ(read_table(file).axes[1].first, nested.axes[1].first);
  EXPECT_EQ(read_table(file).columns[0].values, nested.columns[0].values);
  H5Table damaged = read_h5(file);
  damaged.datasets["first/y"].values[1] += 1e6;
  write_h5(file, damaged);
  EXPECT_THROW(read_table(file), InputError);
  H5Table other;
  other.attributes["format"] = std::string(table_format);
  write_h5(file, other);
  EXPECT_THROW(read_table(file), InputError);
  std::filesystem::remove(file);
}

} // namespace
