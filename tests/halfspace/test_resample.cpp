#include "bem_contact/base/error.hpp"
#include "bem_contact/halfspace/combine.hpp"
#include "bem_contact/halfspace/flat_strip.hpp"
#include "bem_contact/halfspace/near_field.hpp"
#include "bem_contact/halfspace/plane_strain.hpp"
#include "bem_contact/halfspace/resample.hpp"

#include "rectangle_oracle.hpp"
#include "steel.hpp"
#include "strip_kernel.hpp"
#include "tests/base/message.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace bem_contact;

namespace {

ExpandOptions options_for(double dx, int offsets) {
  ExpandOptions options;
  options.dx = dx;
  options.offsets = offsets;
  return options;
}

/// A half-space with a smooth symmetric addition, as a body's shape makes it: it fades with depth (e^-4k) and
/// varies along the strip. A load on a station is proportional to its width, so the addition is as well.
InfluenceFunction bent_body(int stations, double width) {
  InfluenceFunction f = halfspace_function(steel, stations, width, 0.4);
  for (std::size_t k = 0; k < f.wavenumber.size(); ++k)
    for (std::size_t row = 0; row < f.stations.size(); ++row)
      for (std::size_t column = 0; column <= row; ++column) {
        const double s = f.stations[row].s, t = f.stations[column].s;
        const double part =
            width * 1e-6 * std::exp(-4 * f.wavenumber[k]) * (1 + 0.2 * std::cos(0.5 * (s - t)));
        for (std::size_t i = 1; i < 3; ++i)
          f.kernel[f.kernel_index(k, 3 * row + i, 3 * column + i)] += part * (1 + 0.05 * (s + t));
      }
  return f;
}

double largest_difference(const InfluenceNumbers& first, const InfluenceNumbers& second) {
  const InfluenceNumbers a = with_every_pair_of_rows(first), b = with_every_pair_of_rows(second);
  EXPECT_EQ(a.values.size(), b.values.size());
  double error = 0;
  for (std::size_t i = 0; i < std::min(a.values.size(), b.values.size()); ++i)
    error = std::max(error, std::abs(a.values[i] - b.values[i]));
  return error / b.at(0, 0, 2, 0, 2);
}

} // namespace

TEST(Resample, StationsAsRowsAreExact) {
  const InfluenceFunction f = bent_body(8, 0.3);
  std::vector<double> rows;
  for (int i = 2; i < 7; ++i)
    rows.push_back(f.stations[static_cast<std::size_t>(i)].s);
  ExpandOptions direct = options_for(0.5, 4);
  direct.first_station = 2;
  direct.stations = 5;
  const InfluenceNumbers a = halfspace::resample(f, options_for(0.5, 4), rows, 0.3), b = expand(f, direct);
  EXPECT_LT(largest_difference(a, b), 1e-13);
}

TEST(Resample, OtherRowsOfAHalfSpaceAreTheClosedForms) {
  const InfluenceFunction f = halfspace_function(steel, 16, 0.25, 0.4);
  const double ds = 0.37; // another width, between the stations
  std::vector<double> rows;
  for (int i = 0; i < 9; ++i)
    rows.push_back(-1.6 + i * ds);
  const InfluenceNumbers a = halfspace::resample(f, options_for(0.4, 10), rows, ds);
  const InfluenceNumbers b = halfspace::influence_numbers(steel, 0.4, ds, 10, 9);
  const double error = largest_difference(a, b);
  std::printf("resampled half-space: %.2e of self\n", error);
  EXPECT_LT(error, 5e-5);
}

TEST(Resample, TheBodysOwnPartIsInterpolated) {
  // Reference: the same body on stations that are the wanted rows.
  const double ds = 0.2;
  const InfluenceFunction wanted = bent_body(9, ds);
  std::vector<double> rows;
  for (const Station& station : wanted.stations)
    rows.push_back(station.s);
  const InfluenceNumbers exact = expand(wanted, options_for(0.4, 3));
  std::array<double, 2> error{};
  const InfluenceNumbers plain = halfspace::influence_numbers(steel, 0.4, ds, 3, 9);
  int run = 0;
  for (const double width : {0.8, 0.4}) { // centres lie at odd multiples of half a width
    const InfluenceNumbers a = halfspace::resample(bent_body(static_cast<int>(6.4 / width + 0.5), width),
                                                   options_for(0.4, 3), rows, ds);
    // u_n/p_n alone: the x and mixed parts carry only the error of the expansion
    for (int m = 0; m < 3; ++m)
      for (int i = 0; i < 9; ++i)
        for (int j = 0; j < 9; ++j)
          error[static_cast<std::size_t>(run)] =
              std::max(error[static_cast<std::size_t>(run)],
                       std::abs(a.at(m, i, 2, j, 2) - exact.at(m, i, 2, j, 2)) / exact.at(0, 0, 2, 0, 2));
    ++run;
  }
  std::printf("interpolated body: %.2e and %.2e of self; its own part is %.2e\n", error[0], error[1],
              largest_difference(exact, plain));
  EXPECT_LT(error[1], 2e-5);
  EXPECT_GT(largest_difference(exact, plain), 10 * error[1]);
}

TEST(Resample, StationsElsewhereChangeNoNumber) {
  const InfluenceFunction whole = bent_body(24, 0.3);
  for (const double step : {0.3, 0.28, 0.33}) {
    std::vector<double> rows;
    for (int i = 0; i < 6; ++i)
      rows.push_back(whole.stations[9].s + 0.013 + step * i);
    const StationRange used = halfspace::stations_under(whole, rows);
    EXPECT_EQ(used.first, 8);
    EXPECT_LE(used.count, 10);
    for (const int more : {0, 3}) {
      const StationRange range{used.first - more, used.count + 2 * more};
      InfluenceFunction part{part_of(whole, range)};
      const auto skipped = static_cast<std::size_t>(3 * range.first);
      for (std::size_t row = 0; row < static_cast<std::size_t>(3 * range.count); ++row)
        for (std::size_t column = 0; column <= row; ++column)
          for (std::size_t k = 0; k < whole.wavenumber_count(); ++k)
            part.kernel.push_back(whole.kernel[whole.kernel_index(k, row + skipped, column + skipped)]);
      EXPECT_TRUE(halfspace::resample(part, options_for(0.5, 7), rows, 0.3).values ==
                  halfspace::resample(whole, options_for(0.5, 7), rows, 0.3).values)
          << step << " " << more;
    }
  }
}

TEST(Resample, DescendingRowsAreTheSameNumbersTurned) {
  const InfluenceFunction f = bent_body(10, 0.3);
  std::vector<double> rows = {-0.71, -0.4, -0.02, 0.3, 0.66};
  const InfluenceNumbers up = halfspace::resample(f, options_for(0.5, 3), rows, 0.31);
  std::reverse(rows.begin(), rows.end());
  const InfluenceNumbers down = halfspace::resample(f, options_for(0.5, 3), rows, 0.31);
  for (int m = 0; m < 3; ++m)
    for (int a = 0; a < 5; ++a)
      for (int b = 0; b < 5; ++b)
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            EXPECT_NEAR(up.at(m, a, i, b, j), down.at(m, 4 - a, i, 4 - b, j), 1e-13 * up.at(0, 0, 2, 0, 2));
}

TEST(Resample, MaxwellBettiIsExact) {
  const InfluenceFunction f = bent_body(10, 0.3);
  const std::vector<double> rows = {-0.7, -0.41, -0.02, 0.3, 0.66};
  for (const auto& options : {options_for(0.5, 3), options_for(0, 1)}) {
    const InfluenceNumbers a = halfspace::resample(f, options, rows, 0.3);
    for (int m = 0; m < a.offsets; ++m)
      for (int row_i = 0; row_i < 5; ++row_i)
        for (int row_j = 0; row_j < 5; ++row_j)
          for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
              EXPECT_EQ(a.at(m, row_i, i, row_j, j), parity(i, j) * a.at(m, row_j, j, row_i, i));
  }
}

TEST(Resample, PlaneStrainRowsOfAHalfSpace) {
  const InfluenceFunction f = halfspace_function(steel, 16, 0.25, 0.4);
  std::vector<double> rows;
  for (int i = 0; i < 9; ++i)
    rows.push_back(-1.5 + i * 0.35);
  const InfluenceNumbers a = halfspace::resample(f, options_for(0, 1), rows, 0.35);
  const InfluenceNumbers b = halfspace::plane_strain_numbers(steel, 0.35, 9, 10);
  // They differ by a rigid motion: differences between rows agree, to what the kernel's quadrature holds.
  for (int row = 1; row < 9; ++row)
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(a.at(0, row, c, 0, c) - a.at(0, 0, c, 0, c), b.at(0, row, c, 0, c) - b.at(0, 0, c, 0, c),
                  1e-9 * a.at(0, 0, 2, 0, 2));
  EXPECT_NEAR(a.at(0, 8, 1, 0, 2), b.at(0, 8, 1, 0, 2), 1e-10 * std::abs(b.at(0, 8, 1, 0, 2)));
}

TEST(Resample, RowsOffTheStripAreRefused) {
  const InfluenceFunction f = halfspace_function(steel, 5, 0.4, 0.4);
  const auto resampled = [&](std::vector<double> rows, double ds) {
    return message_of([&] { halfspace::resample(f, options_for(0.5, 2), rows, ds); });
  };
  EXPECT_THAT(resampled({0.7, 1.1}, 0.4), testing::HasSubstr("leaves the contact strip"));
  EXPECT_THAT(resampled({-0.8, -0.4, -0.6}, 0.2), testing::HasSubstr("not in the order"));
  EXPECT_THAT(resampled({0, 0}, 0.2), testing::HasSubstr("not in the order"));
  EXPECT_THAT(resampled({}, 0.2), testing::HasSubstr("0 rows"));
  EXPECT_THAT(resampled({0.0, std::nan("")}, 0.2), testing::HasSubstr("not in the order"));
  EXPECT_THAT(resampled({std::nan("")}, 0.2), testing::HasSubstr("leaves the contact strip"));
  EXPECT_THAT(resampled({0.0}, -1), testing::HasSubstr("width above 0"));
  EXPECT_EQ(resampled({-0.8, -0.4, 0, 0.4, 0.8}, 0.4), "no error");
}

TEST(Combine, TurnsTheWheelIntoTheContactFrame) {
  const InfluenceNumbers rail = halfspace::influence_numbers({82000, 0.28}, 0.5, 0.2, 3, 4);
  InfluenceNumbers wheel = rail;
  // A wheel of the same material whose rows run against its own s: the same half-space seen from below.
  for (int m = 0; m < 3; ++m)
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < 4; ++b)
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            wheel.at(m, a, i, b, j) = rail.at(m, 3 - a, i, 3 - b, j);
  const InfluenceNumbers pair = halfspace::combine(rail, wheel);
  for (int m = 0; m < 3; ++m)
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < 4; ++b) {
        for (int c = 0; c < 3; ++c)
          EXPECT_NEAR(pair.at(m, a, c, b, c), 2 * rail.at(m, a, c, b, c), 1e-18);
        EXPECT_NEAR(pair.at(m, a, 0, b, 1), 2 * rail.at(m, a, 0, b, 1), 1e-18);
        for (int t = 0; t < 2; ++t) // the coupling of normal and tangential cancels for equal bodies
          EXPECT_NEAR(pair.at(m, a, 2, b, t), 0, 1e-18);
      }
  EXPECT_EQ(halfspace::combine_equal(rail).values, pair.values);
}

TEST(LineStore, WhatIsKeptChangesNoNumber) {
  const InfluenceFunction f = bent_body(16, 0.4);
  halfspace::LineStore known;
  for (const auto& [dx, offsets] :
       {std::pair(0.5, 4), std::pair(0.4, 4), std::pair(0.5, 10), std::pair(0.5, 6)})
    for (const double stretch : {1.0, 1.01}) {
      std::vector<double> rows;
      for (int i = 0; i < 9; ++i)
        rows.push_back(f.stations.front().s + 0.7 + 0.3 * stretch * i);
      const InfluenceNumbers kept = halfspace::resample(f, options_for(dx, offsets), rows, 0.3, &known),
                             anew = halfspace::resample(f, options_for(dx, offsets), rows, 0.3);
      EXPECT_TRUE(kept.values == anew.values) << dx << " " << offsets << " " << stretch;
      EXPECT_TRUE(halfspace::influence_numbers(steel, dx, 0.3, offsets, 5, &known).values ==
                  halfspace::influence_numbers(steel, dx, 0.3, offsets, 5).values);
    }
}

TEST(Combine, RefusesToDoubleNumbersThatDependOnBothRows) {
  EXPECT_THAT(message_of([] {
                halfspace::combine_equal(
                    with_every_pair_of_rows(halfspace::influence_numbers(steel, 0.5, 0.2, 2, 3)));
              }),
              testing::HasSubstr("depend on both rows"));
}

TEST(Combine, RefusesDifferentGrids) {
  const InfluenceNumbers a = halfspace::influence_numbers(steel, 0.5, 0.2, 2, 3),
                         b = halfspace::influence_numbers(steel, 0.5, 0.21, 2, 3),
                         c = halfspace::influence_numbers(steel, 0.5, 0.2, 3, 3);
  EXPECT_THAT(message_of([&] { halfspace::combine(a, b); }), testing::HasSubstr("different grids"));
  EXPECT_THAT(message_of([&] { halfspace::combine(a, c); }), testing::HasSubstr("different grids"));
}

TEST(NearField, FewLinesServeRowsThatAreNotEquallyFar) {
  // Opposite equal rows of the rail a wheel's rows scatter by per cents; each number against its closed form.
  std::vector<double> rows;
  for (int i = 0; i < 24; ++i)
    rows.push_back(0.3 * i * (1 + 0.0004 * i) + 0.002 * std::sin(0.8 * i));
  for (const auto& options : {options_for(0.5, 6), options_for(0, 1)}) {
    halfspace::LineStore known;
    const halfspace::NearField near(steel, options, rows, 0.3, known);
    EXPECT_LT(near.lines(), rows.size() * (rows.size() + 1) / 2 / 2);
    for (int m = 0; m < options.offsets; ++m)
      for (int row_i = 0; row_i < 24; ++row_i)
        for (int row_j = 0; row_j <= row_i; ++row_j) {
          const double s = rows[static_cast<std::size_t>(row_i)] - rows[static_cast<std::size_t>(row_j)];
          const halfspace::Matrix3 exact = options.dx == 0
                                               ? halfspace::averaged_plane_strain(steel, s, 0.3, 100)
                                               : halfspace::averaged(steel, m * options.dx, s, 0.25, 0.15);
          halfspace::LineMix mix;
          near.add_to(mix, row_i, row_j, 1);
          const auto offsets = static_cast<std::size_t>(options.offsets);
          std::vector<double> lines(9 * offsets);
          for (std::size_t e = 0; e < 9; ++e)
            halfspace::add_mix(mix, e * offsets, 0, &lines[e * offsets], offsets);
          for (std::size_t e = 0; e < 9; ++e)
            EXPECT_NEAR(lines[e * offsets + static_cast<std::size_t>(m)], exact[e / 3][e % 3],
                        2e-6 * std::abs(exact[2][2]))
                << m << " " << row_i << " " << row_j << " " << e;
        }
  }
}
