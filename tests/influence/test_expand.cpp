// What expand does to any kernel; that the numbers are right is tested against closed forms in
// tests/halfspace.
#include "bem_contact/influence/expand.hpp"
#include "sample_function.hpp"

#include <gmock/gmock.h>

#include <array>

using namespace bem_contact;
using testing::HasSubstr;

namespace {

ExpandOptions options_for(double dx, int offsets,
                          StructuralCompliance structural = StructuralCompliance::included) {
  ExpandOptions options;
  options.dx = dx;
  options.offsets = offsets;
  options.structural = structural;
  return options;
}

/// x^T A x summed over the periodic line cannot be negative; the numbers at m = 0 alone must be definite.
bool positive_definite(const InfluenceNumbers& a) {
  const std::size_t n = 3 * static_cast<std::size_t>(a.rows);
  std::vector<double> m(a.values.begin(), a.values.begin() + static_cast<std::ptrdiff_t>(n * n));
  for (std::size_t c = 0; c < n; ++c) { // Gauss elimination without pivoting
    if (!(m[c * n + c] > 0))
      return false;
    for (std::size_t row = c + 1; row < n; ++row)
      for (std::size_t column = n; column-- > c;)
        m[row * n + column] -= m[row * n + c] / m[c * n + c] * m[c * n + column];
  }
  return true;
}

} // namespace

TEST(Expand, MaxwellBettiIsExact) {
  for (const auto structural : {StructuralCompliance::included, StructuralCompliance::removed}) {
    const InfluenceNumbers a = expand(sample_function(), options_for(0.5, 6, structural));
    for (int m = 0; m < 6; ++m)
      for (int p = 0; p < 3; ++p)
        for (int q = 0; q < 3; ++q)
          for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
              EXPECT_EQ(a.at(m, p, i, q, j), parity(i, j) * a.at(m, q, j, p, i));
    EXPECT_TRUE(positive_definite(a));
  }
}

TEST(Expand, OneHarmonicIsItsOwnSeries) {
  // A kernel that lives in harmonic 2 alone (and is exact there) gives c_2 g cos(k_2 x), c_2 g sin(k_2 x).
  InfluenceFunction f = sample_function();
  for (std::size_t k = 0; k < f.wavenumber_count(); ++k)
    for (std::size_t a = 0; a < 9; ++a)
      for (std::size_t b = 0; b <= a; ++b)
        f.kernel[f.kernel_index(k, a, b)] *= k == 2 ? 1 : (k == 0 || a == b ? 1e-12 : 0);
  const double dx = 0.5, k2 = f.wavenumber[2], s = std::sin(k2 * dx / 2);
  const double c = 2 * s * s / (f.half_period * k2 * k2 * dx / 2);
  const InfluenceNumbers a = expand(f, options_for(dx, 5));
  const auto g = [&](int row, int column) {
    return f.kernel[f.kernel_index(2, static_cast<std::size_t>(row), static_cast<std::size_t>(column))];
  };
  for (int m = 0; m < 5; ++m)
    for (int p = 0; p < 3; ++p)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          const double sign =
              parity(i, j) > 0 ? std::cos(k2 * dx * m) : (i == 0 ? 1 : -1) * std::sin(k2 * dx * m);
          EXPECT_NEAR(a.at(m, p, i, 0, j), c * g(3 * p + i, j) * sign, 1e-9 * c * 4e-6) << m << p << i << j;
        }
}

TEST(Expand, PlaneStrainIsTheFirstWavenumber) {
  const InfluenceFunction f = sample_function();
  const InfluenceNumbers a = expand(f, options_for(0, 1));
  EXPECT_EQ(a.dx, 0);
  for (std::size_t p = 0; p < 9; ++p)
    for (std::size_t q = 0; q < 9; ++q)
      EXPECT_EQ(a.values[9 * p + q], parity(static_cast<int>(p % 3), static_cast<int>(q % 3)) > 0
                                         ? f.kernel[f.kernel_index(0, p, q)]
                                         : 0);
}

TEST(Expand, RemovedHoldsTheRemoteSectionAtRest) {
  // Forces q on the remote section bring its motion r p + S q to zero: q = -S^-1 r p, so u = g p + r^T q.
  const InfluenceFunction f = sample_function();
  const InfluenceNumbers removed = expand(f, options_for(0, 1, StructuralCompliance::removed));
  for (std::size_t load = 0; load < 9; ++load) {
    std::array<std::array<double, 7>, 6> system{};
    for (std::size_t d = 0; d < 6; ++d) {
      for (std::size_t e = 0; e < 6; ++e)
        system[d][e] = f.remote_self[6 * d + e];
      system[d][6] = -f.remote[9 * d + load];
    }
    for (std::size_t c = 0; c < 6; ++c)
      for (std::size_t row = 0; row < 6; ++row)
        if (row != c) {
          const double factor = system[row][c] / system[c][c];
          for (std::size_t column = 0; column < 7; ++column)
            system[row][column] -= factor * system[c][column];
        }
    for (std::size_t row = 0; row < 9; ++row)
      if (parity(static_cast<int>(row % 3), static_cast<int>(load % 3)) > 0) {
        double u = f.kernel[f.kernel_index(0, row, load)];
        for (std::size_t d = 0; d < 6; ++d)
          u += f.remote[9 * d + row] * system[d][6] / system[d][d];
        EXPECT_NEAR(removed.values[9 * row + load], u, 1e-12 * f.kernel[0]);
      }
  }
  EXPECT_LT(removed.values[0], f.kernel[0]);
}

TEST(Expand, ARunOfStationsIsTheMiddleOfTheTable) {
  const InfluenceFunction f = sample_function();
  ExpandOptions options = options_for(0.5, 3, StructuralCompliance::removed);
  const InfluenceNumbers all = expand(f, options);
  options.first_station = 1;
  options.stations = 2;
  const InfluenceNumbers part = expand(f, options);
  ASSERT_EQ(part.rows, 2);
  for (int m = 0; m < 3; ++m)
    for (int p = 0; p < 2; ++p)
      for (int q = 0; q < 2; ++q)
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            EXPECT_NEAR(part.at(m, p, i, q, j), all.at(m, p + 1, i, q + 1, j), 1e-14 * all.at(0, 0, 0, 0, 0));
}

TEST(Expand, AngleIsTheCommonCoordinateOfAWheel) {
  // A(x; a) = (Rc/R) A_ref(x R/Rc; a R/Rc): the same elements in angle, the same force per angle.
  InfluenceFunction f = sample_function();
  f.invariance = Invariance::revolution;
  f.reference_radius = 20 / std::numbers::pi;
  f.half_period = std::numbers::pi * f.reference_radius;
  for (double& k : f.wavenumber)
    k *= 20 / f.half_period; // rounding of 20/pi*pi
  const InfluenceNumbers reference = expand(f, options_for(0.5, 4));
  ExpandOptions options = options_for(0.55, 4);
  options.contact_radius = 1.1 * f.reference_radius;
  const InfluenceNumbers larger = expand(f, options);
  for (std::size_t e = 0; e < larger.values.size(); ++e)
    EXPECT_NEAR(larger.values[e], 1.1 * reference.values[e], 1e-12 * reference.values[0]);
  EXPECT_EQ(larger.dx, 0.55);
}

TEST(Expand, RefusesWhatTheFileDoesNotServe) {
  const InfluenceFunction f = sample_function(); // k_max = 40: dx >= 0.25
  const auto refusal = [&](const ExpandOptions& options) { return message_of([&] { expand(f, options); }); };
  EXPECT_EQ(refusal(options_for(0.25, 2)), "no error");
  EXPECT_THAT(refusal(options_for(0.24, 2)),
              testing::AllOf(HasSubstr("too coarse along x"), HasSubstr("0.25")));
  EXPECT_THAT(refusal(options_for(0.5, 41)), HasSubstr("longer than the half period"));
  EXPECT_THAT(refusal(options_for(0, 2)), HasSubstr("Plane strain has no offsets"));
  EXPECT_THAT(refusal(options_for(std::nan(""), 2)), HasSubstr("cannot be expanded"));
  EXPECT_THAT(refusal(options_for(0.5, 0)), HasSubstr("cannot be expanded"));
  ExpandOptions options = options_for(0.5, 2);
  options.first_station = 2;
  options.stations = 2;
  EXPECT_THAT(refusal(options), HasSubstr("Stations were asked for"));
  options = options_for(0.5, 2);
  options.contact_radius = -1;
  EXPECT_THAT(refusal(options), HasSubstr("contact radius"));

  InfluenceFunction singular = f;
  singular.remote_self.assign(singular.remote_self.size(), 1e-6);
  EXPECT_THAT(message_of([&] { expand(singular, options_for(0.5, 2, StructuralCompliance::removed)); }),
              HasSubstr("structural compliance"));
  InfluenceFunction plane = f;
  plane.wavenumber.resize(1);
  EXPECT_THAT(message_of([&] { expand(plane, options_for(0.5, 2)); }), HasSubstr("plane strain only"));
}
