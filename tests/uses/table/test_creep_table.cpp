#include "bem_contact/base/error.hpp"
#include "bem_contact/reference/creep_coefficients.hpp"
#include "bem_contact/uses/table/creep_table.hpp"
#include "tests/reference/rolling.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <random>

namespace {

using namespace bem_contact;
using namespace bem_contact::table;
using ::testing::HasSubstr;

constexpr double tolerance = 0.12;
constexpr CreepTableOptions coarse{.from = 0.5, .to = 2, .elements = 8, .tolerance = tolerance};
constexpr CreepContact contact{.a = 3, .b = 2, .shear_modulus = 8.2e4, .bound = 3e4};

class CreepTable : public ::testing::Test {
protected:
  static void SetUpTestSuite() {
    table_ = creep_table(coarse);
    solve_ = creep_point_solver(*table_.scale, coarse.elements);
    refine(table_, one_by_one(solve_), {.tolerance = tolerance});
    fmt::print("{} points, {} contacts; off by {:.3f} {:.3f} {:.3f}\n", table_.size(), table_.solved,
               table_.columns[0].interpolation_error, table_.columns[1].interpolation_error,
               table_.columns[2].interpolation_error);
  }

  static TabulatedForces at(double xi, double eta, double phi) {
    return creep_forces(table_, contact, xi, eta, phi);
  }

  static inline ContactTable table_;
  static inline PointSolver solve_;
};

/// With eight elements the coefficients themselves are 10 % off; tests/uses/curves shows that they converge.
TEST_F(CreepTable, SlopesAtZeroAreKalkersCoefficients) {
  const reference::CreepCoefficients k = reference::creep_coefficients(contact.a / contact.b, 0.28);
  const double c = std::sqrt(contact.a * contact.b), unit = c * c * contact.shear_modulus;
  const double xi = 1e-3 * contact.bound / unit, phi = xi / c;
  EXPECT_NEAR(at(xi, 0, 0).Fx / (unit * k.c11 * xi), 1, 0.2);
  EXPECT_NEAR(at(0, xi, 0).Fy / (unit * k.c22 * xi), 1, 0.2);
  EXPECT_NEAR(at(0, 0, phi).Fy / (unit * c * k.c23 * phi), 1, 0.2);
  EXPECT_NEAR(at(0, xi, 0).Mz / (-unit * c * k.c23 * xi), 1, 0.2);
  EXPECT_EQ(at(0, 0, 0).Fx, 0);
}

/// The interpolation overshoots beside the kink where slip becomes full; friction does not.
TEST_F(CreepTable, ForcesStayWithinFriction) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> creepage(-0.2, 0.2), spin(-0.05, 0.05);
  double largest = 0;
  for (int i = 0; i < 20000; ++i) {
    const TabulatedForces f = at(creepage(random), creepage(random), spin(random));
    largest = std::max(largest, std::hypot(f.Fx, f.Fy) / contact.bound);
  }
  EXPECT_LE(largest, 1 + 1e-12);
  EXPECT_GT(largest, 1 - 1e-3);
}

TEST_F(CreepTable, SignsAreThoseOfTheContact) {
  const TabulatedForces f = at(1e-3, 5e-4, 2e-4), back = at(-1e-3, 5e-4, 2e-4),
                        other = at(1e-3, -5e-4, -2e-4);
  EXPECT_EQ(back.Fx, -f.Fx);
  EXPECT_EQ(back.Fy, f.Fy);
  EXPECT_EQ(back.Mz, f.Mz);
  EXPECT_EQ(other.Fx, f.Fx);
  EXPECT_EQ(other.Fy, -f.Fy);
  EXPECT_EQ(other.Mz, -f.Mz);
  EXPECT_NE(at(1e-3, 5e-4, -2e-4).Fy, f.Fy);
  // A table has xi > 0 and eta > 0 only; here a solution with the other signs, by angles beyond the axes.
  const double angles[] = {0.7, -0.4};
  const auto solved = [](double alpha, double beta) { return solve_({0.1, 0.4, alpha, beta}).values; };
  const std::vector<double> one = solved(angles[0], angles[1]);
  const std::vector<double> xi_back = solved(std::numbers::pi - angles[0], angles[1]);
  const std::vector<double> both_back = solved(angles[0], std::numbers::pi + angles[1]);
  for (const std::size_t c : {0u, 1u, 2u}) {
    EXPECT_NEAR(xi_back[c], c == 0 ? -one[c] : one[c], 1e-6);
    EXPECT_NEAR(both_back[c], c == 0 ? one[c] : -one[c], 1e-6);
  }
}

TEST_F(CreepTable, FullSlipGivesTheFrictionBound) {
  EXPECT_NEAR(at(10, 0, 0).Fx, contact.bound, 1e-4 * contact.bound);
  EXPECT_NEAR(at(0, -10, 0).Fy, -contact.bound, 1e-4 * contact.bound);
  const TabulatedForces turned = at(10, 10, 0);
  EXPECT_NEAR(std::hypot(turned.Fx, turned.Fy), contact.bound, 2 * tolerance * contact.bound);
  const TabulatedForces spin = creep_forces(table_, {2, 2, 8.2e4, 3e4}, 0, 0, 100);
  const double exact = reference::full_spin_moment(0.3, 1e5, 2);
  EXPECT_NEAR(spin.Mz / exact, 1, 0.03);
  EXPECT_NEAR(spin.Fy, 0, 0.01 * contact.bound);
}

/// t = 1 is an integral, all else a solution: they meet. Elastic slip is of the order of 1 - t. Spin alone
/// about a circle: Mz = mu N R 3 pi / 16.
TEST_F(CreepTable, FullSlipIsTheLimitOfSolutions) {
  const double half_pi = 0.5 * std::numbers::pi;
  EXPECT_NEAR(solve_({0, 1, half_pi, half_pi}).values[2], 3 * std::numbers::pi / 16, 1e-4);
  const PointSolver finer = creep_point_solver(*table_.scale, 24);
  for (Point at : {Point{0.3, 1, 0.4, 0.5}, Point{-0.2, 1, 1.2, -0.8}, Point{0, 1, 0.9, 1.2}}) {
    const std::vector<double> full = finer(at).values;
    at[1] = 0.998;
    const std::vector<double> nearly = finer(at).values;
    for (const std::size_t c : {0u, 1u, 2u})
      EXPECT_NEAR(nearly[c], full[c], 0.01) << at[2] << " " << c;
  }
}

TEST_F(CreepTable, ErrorHoldsAtRandomPoints) {
  std::mt19937 random(7);
  const auto between = [&](const Axis& axis) {
    return std::uniform_real_distribution<double>(axis.points.front(), axis.points.back())(random);
  };
  double worst = 0;
  for (int i = 0; i < 40; ++i) {
    Point point;
    for (const Axis& axis : table_.axes)
      point.push_back(between(axis));
    const std::vector<double> solved = solve_(point).values;
    for (std::size_t c = 0; c < 3; ++c)
      worst = std::max(worst, std::abs(interpolate(table_, table_.columns[c], point) - solved[c]));
  }
  fmt::print("random points are off by up to {:.3f}\n", worst);
  EXPECT_LE(worst, tolerance);
}

TEST(CreepTableInput, IsRefusedInWords) {
  const auto refused = [](CreepTableOptions options, const char* word) {
    try {
      creep_table(options);
      ADD_FAILURE() << word;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(word));
    }
  };
  refused({.from = 0.01}, "within 0.1 to 10");
  refused({.from = 2, .to = 1}, "two ends that grow");
  refused({.poisson = 0.6}, "Poisson's ratio 0.6");
  refused({.elements = 2}, "2 elements");
  refused({.tolerance = 0.5}, "between 0 and 0.3");
  EXPECT_THROW(creep_forces({}, contact, 0, 0, 0), InputError);
}

} // namespace
