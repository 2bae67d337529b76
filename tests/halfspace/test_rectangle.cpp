#include "bem_contact/base/error.hpp"
#include "bem_contact/halfspace/element_line.hpp"
#include "bem_contact/halfspace/flat_strip.hpp"

#include "quadrature.hpp"
#include "rectangle_oracle.hpp"
#include "steel.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

using namespace bem_contact;
using halfspace::at_point;
using halfspace::averaged;
using halfspace::Matrix3;

namespace {

/// Boussinesq-Cerruti point force at the origin, n into the body.
Matrix3 point_force(const Material& m, double x, double s) {
  const double nu = m.poisson, g = m.shear_modulus, r = std::hypot(x, s), pi = std::numbers::pi;
  Matrix3 u{};
  u[0][0] = ((1 - nu) / r + nu * x * x / (r * r * r)) / (2 * pi * g);
  u[1][1] = ((1 - nu) / r + nu * s * s / (r * r * r)) / (2 * pi * g);
  u[0][1] = u[1][0] = nu * x * s / (r * r * r) / (2 * pi * g);
  u[2][2] = (1 - nu) / (2 * pi * g * r);
  u[0][2] = -(1 - 2 * nu) / (4 * pi * g) * x / (r * r);
  u[1][2] = -(1 - 2 * nu) / (4 * pi * g) * s / (r * r);
  u[2][0] = -u[0][2];
  u[2][1] = -u[1][2];
  return u;
}

/// Integral over the load rectangle: the field point cuts it into four, each mapped by Duffy's transformation
/// (r^-1 is cancelled by the Jacobian). Field points outside: the four signed rectangles work as well.
double quadrature_at_point(int i, int j, double x, double s, double a, double b) {
  static const GaussRule rule(40);
  double sum = 0;
  for (const int side_x : {-1, 1})
    for (const int side_s : {-1, 1}) {
      const double edge_x = side_x * a - x, edge_s = side_s * b - s;
      for (std::size_t p = 0; p < rule.point.size(); ++p)
        for (std::size_t q = 0; q < rule.point.size(); ++q) {
          const double t = (1 + rule.point[p]) / 2, v = (1 + rule.point[q]) / 2;
          const double w = side_x * side_s * rule.weight[p] * rule.weight[q] / 4 * t * edge_x * edge_s;
          // Position of the field point as seen from the load point.
          sum += w * (point_force(steel, -t * edge_x, -t * v * edge_s)[i][j] +
                      point_force(steel, -t * v * edge_x, -t * edge_s)[i][j]);
        }
    }
  return sum;
}

double largest(const Matrix3& m) {
  double value = 0;
  for (const auto& row : m)
    for (const double entry : row)
      value = std::max(value, std::abs(entry));
  return value;
}

} // namespace

TEST(Rectangle, PointValuesAgreeWithQuadrature) {
  struct Case {
    double x, s, a, b;
  };
  for (const Case c : {Case{0.1, 0.07, 0.25, 0.1}, Case{0.4, -0.3, 0.25, 0.1}, Case{-0.05, 0.05, 0.2, 0.2},
                       Case{-0.7, 0.2, 0.3, 0.15}})
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const Matrix3 u = at_point(steel, c.x, c.s, c.a, c.b);
        EXPECT_NEAR(u[i][j], quadrature_at_point(i, j, c.x, c.s, c.a, c.b), 1e-9 * largest(u))
            << i << j << " at " << c.x << ' ' << c.s;
      }
}

TEST(Rectangle, CentreOfASquareUnderPressure) {
  // u_n = 4 (1 - nu) / (2 pi G) * 2 a asinh(1) (Love 1929; Johnson 1985, eq. 3.26)
  const double a = 0.3;
  const Matrix3 u = at_point(steel, 0, 0, a, a);
  EXPECT_NEAR(u[2][2], (1 - 0.28) / (2 * std::numbers::pi * 82000) * 8 * a * std::asinh(1.0), 1e-20);
  EXPECT_EQ(u[0][2], 0);
  EXPECT_EQ(u[0][1], 0);
}

TEST(Rectangle, PairOfEqualBodiesHasTheElementFormulas) {
  // bem_contact/theory/numbers.md 2: u_x/p_x = (K1 + (1-nu) K2)/(pi G), u_n/p_n = (1-nu)(K1+K2)/(pi G),
  // u_x/p_s = -nu R/(pi G).
  const double a = 0.25, b = 0.1, x = 0.13, s = 0.42, nu = steel.poisson;
  double k1 = 0, k2 = 0, radius = 0;
  for (const int p : {-1, 1})
    for (const int q : {-1, 1}) {
      const double px = x + p * a, ps = s + q * b;
      k1 += p * q * ps * std::asinh(px / std::abs(ps));
      k2 += p * q * px * std::asinh(ps / std::abs(px));
      radius += p * q * std::hypot(px, ps);
    }
  const double c = 1 / (std::numbers::pi * steel.shear_modulus);
  const Matrix3 u = at_point(steel, x, s, a, b);
  EXPECT_NEAR(2 * u[0][0], c * (k1 + (1 - nu) * k2), 1e-18);
  EXPECT_NEAR(2 * u[1][1], c * (k2 + (1 - nu) * k1), 1e-18);
  EXPECT_NEAR(2 * u[2][2], c * (1 - nu) * (k1 + k2), 1e-18);
  EXPECT_NEAR(2 * u[0][1], -c * nu * radius, 1e-18);
}

TEST(Rectangle, SignsOfTheCoupling) {
  // A pressure pulls the surface towards the load and pushes it into the body.
  const Matrix3 ahead = averaged(steel, 2, 0, 0.2, 0.2);
  EXPECT_LT(ahead[component_x][component_n], 0);
  EXPECT_GT(ahead[component_n][component_x], 0);
  EXPECT_GT(ahead[component_n][component_n], 0);
  const Matrix3 right = averaged(steel, 0, 2, 0.2, 0.2);
  EXPECT_LT(right[component_s][component_n], 0);
  EXPECT_GT(right[component_n][component_s], 0);
  EXPECT_GT(averaged(steel, 1, 1, 0.2, 0.2)[component_x][component_s], 0);
  const Matrix3 incompressible = averaged({82000, 0.5 - 1e-12}, 2, 0, 0.2, 0.2);
  EXPECT_NEAR(incompressible[component_x][component_n] / ahead[component_x][component_n], 0, 1e-11);
}

TEST(Rectangle, AveragesAgreeWithQuadratureOfPointValues) {
  const double a = 0.25, b = 0.1;
  // On the element, overlapping none, sharing an edge, a corner, apart; centres on both axes.
  const std::array<std::array<double, 2>, 7> centres = {
      {{0, 0}, {2 * a, 0}, {0, 2 * b}, {-2 * a, 2 * b}, {4 * a, -6 * b}, {0, 10 * b}, {-6 * a, 0}}};
  for (const auto [x, s] : centres) {
    const Matrix3 mean = averaged(steel, x, s, a, b);
    const double scale = largest(mean);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        // Split where at_point has its logarithms only if they cross the receiver: they lie on its edges
        // here.
        const double reference = integrate(x - a, x + a, 40,
                                           [&](double px) {
                                             return integrate(s - b, s + b, 40, [&](double ps) {
                                               return at_point(steel, px, ps, a, b)[i][j];
                                             });
                                           }) /
                                 (4 * a * b);
        EXPECT_NEAR(mean[i][j], reference, 2e-10 * scale) << i << j << " at " << x << ' ' << s;
      }
  }
}

TEST(Rectangle, FarFieldHoldsToAThousandElements) {
  const double a = 0.25, b = 0.1;
  for (const double distance : {13.0, 100.0, 1000.0})
    for (const double angle : {0.0, 0.3, 1.1, std::numbers::pi / 2}) {
      const double x = distance * 2 * a * std::cos(angle), s = distance * 2 * a * std::sin(angle);
      const Matrix3 mean = averaged(steel, x, s, a, b);
      // The relative position of load and receiver has a triangular density; 24 Gauss points per half.
      const GaussRule rule(24);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          double sum = 0;
          for (int hx : {-1, 1})
            for (int hs : {-1, 1})
              for (std::size_t p = 0; p < 24; ++p)
                for (std::size_t q = 0; q < 24; ++q) {
                  const double t = (1 + rule.point[p]) / 2, v = (1 + rule.point[q]) / 2;
                  sum += rule.weight[p] * rule.weight[q] / 4 * (1 - t) * (1 - v) *
                         point_force(steel, x + hx * 2 * a * t, s + hs * 2 * b * v)[i][j];
                }
          EXPECT_NEAR(mean[i][j], sum * 4 * a * b, 1e-11 * largest(mean)) << i << j << ' ' << distance;
        }
      EXPECT_NEAR(mean[2][2] / (4 * a * b * point_force(steel, x, s)[2][2]), 1, 0.2 / (distance * distance));
    }
}

TEST(Rectangle, ClosedFormAndFarFieldMeet) {
  // The switch lies at 12 max(a, b): values just inside and just outside join smoothly (third difference).
  for (const double b : {0.25, 0.025}) {
    const double a = 0.25, h = 1e-3;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const auto f = [&](double r) { return averaged(steel, 0.8 * r, 0.6 * r, a, b)[i][j] * r; };
        const double scale = largest(averaged(steel, 2.4, 1.8, a, b)) * 3;
        EXPECT_NEAR(f(3 - 1.5 * h) - 3 * f(3 - 0.5 * h) + 3 * f(3 + 0.5 * h) - f(3 + 1.5 * h), 0,
                    2e-10 * scale);
      }
  }
}

TEST(Rectangle, MaxwellBettiAndParityAreExact) {
  for (const double x : {0.0, 0.5, 2.3, 40.0})
    for (const double s : {0.0, -0.2, 1.7, -33.0}) {
      const Matrix3 there = averaged(steel, x, s, 0.25, 0.1), back = averaged(steel, -x, -s, 0.25, 0.1);
      const Matrix3 mirrored = averaged(steel, -x, s, 0.25, 0.1);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          EXPECT_EQ(there[i][j], back[j][i]);
          EXPECT_EQ(there[i][j], parity(i, j) * mirrored[i][j]);
        }
    }
}

TEST(Rectangle, ScalesWithLengthAndStiffness) {
  const Matrix3 one = averaged(steel, 0.7, -0.3, 0.25, 0.1);
  const Matrix3 metre = averaged({steel.shear_modulus / 2, steel.poisson}, 7, -3, 2.5, 1);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      EXPECT_NEAR(metre[i][j], 20 * one[i][j], 1e-13 * largest(metre));
}

TEST(Rectangle, TableHoldsTheElementNumbers) {
  const InfluenceNumbers table = halfspace::influence_numbers(steel, 0.5, 0.2, 3, 4);
  ASSERT_TRUE(table.translational);
  ASSERT_EQ(table.values.size(), 3u * 7 * 9);
  const InfluenceNumbers spelled = with_every_pair_of_rows(table);
  ASSERT_EQ(spelled.values.size(), 3u * 12 * 12);
  for (int m = 0; m < 3; ++m)
    for (int row_i = 0; row_i < 4; ++row_i)
      for (int row_j = 0; row_j < 4; ++row_j) {
        const Matrix3 expected = averaged(steel, m * 0.5, (row_i - row_j) * 0.2, 0.25, 0.1);
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            EXPECT_NEAR(spelled.at(m, row_i, i, row_j, j), expected[i][j],
                        1e-14 * table.at(0, 0, component_n, 0, component_n));
        for (int k = 0; k < 9; ++k)
          EXPECT_EQ(table.at(m, row_i, k / 3, row_j, k % 3), spelled.at(m, row_i, k / 3, row_j, k % 3));
      }
}

TEST(Rectangle, ALineIsItsElements) {
  for (const auto& [dx, ds] : {std::pair{0.5, 0.2}, std::pair{0.2, 0.2}, std::pair{0.2, 0.55}})
    for (const double s : {0.0, 0.3 * ds, -ds, 2.6 * ds, -7 * ds, 31 * ds, 90 * ds}) {
      std::vector<Matrix3> line(130);
      halfspace::averaged_line(steel, s, dx, ds, line);
      const double self = averaged(steel, 0, 0, dx / 2, ds / 2)[component_n][component_n];
      for (int m = 0; m < 130; ++m) {
        const Matrix3 expected = averaged(steel, m * dx, s, dx / 2, ds / 2);
        const double local = expected[component_n][component_n];
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            EXPECT_NEAR(line[static_cast<std::size_t>(m)][i][j], expected[i][j], 1e-13 * local + 1e-15 * self)
                << dx << ' ' << ds << ' ' << s << ' ' << m << i << j;
      }
    }
}

TEST(Rectangle, ElementsThatAreNoneAreRefused) {
  const auto message = [](const std::function<void()>& call) {
    try {
      call();
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  std::vector<Matrix3> line(1);
  EXPECT_THAT(message([&] { halfspace::averaged_line(steel, 0, 0, 1, line); }),
              testing::HasSubstr("not a positive number"));
  EXPECT_THAT(message([&] { halfspace::averaged_line(steel, 0, 1, -1, line); }),
              testing::HasSubstr("width ds"));
  EXPECT_THAT(
      message([] { halfspace::influence_numbers(steel, 1, std::numeric_limits<double>::quiet_NaN(), 1, 1); }),
      testing::HasSubstr("not a positive number"));
  EXPECT_THAT(message([] { halfspace::influence_numbers(steel, 1, 1, 0, 1); }),
              testing::HasSubstr("without elements"));
}

TEST(PlaneStrain, NumbersAreTheLimitOfLongElements) {
  // Differences between two rows do not depend on the reference distance and are those of a long rectangle.
  const double ds = 0.2, half_length = 2e8;
  const InfluenceNumbers strip = halfspace::plane_strain_numbers(steel, ds, 6, 5);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int row = 1; row < 6; ++row) {
        const auto mean = [&](int d) { // mid-plane of a long load, averaged over the receiver's width alone
          return integrate(d * ds - ds / 2, d * ds + ds / 2, 24,
                           [&](double s) { return at_point(steel, 0, s, half_length, ds / 2)[i][j]; }) /
                 ds;
        };
        EXPECT_NEAR(strip.at(0, row, i, 0, j) - strip.at(0, 0, i, 0, j), mean(row) - mean(0),
                    1e-9 * strip.at(0, 0, 2, 0, 2))
            << i << j << row;
      }
}

TEST(PlaneStrain, ReferenceDistanceIsWhereTheSurfaceStaysAtRest) {
  const double ds = 0.01;
  const InfluenceNumbers strip = halfspace::plane_strain_numbers(steel, ds, 501, 5);
  EXPECT_NEAR(strip.at(0, 500, 2, 0, 2) / strip.at(0, 0, 2, 0, 2), 0, 1e-6);
  EXPECT_GT(strip.at(0, 0, 2, 0, 2), 0);
}

TEST(PlaneStrain, PressurePullsTheSurfaceTowardsTheLoad) {
  const InfluenceNumbers strip = halfspace::plane_strain_numbers(steel, 0.2, 3, 5);
  const double full = (1 - 2 * 0.28) / (4 * 82000.0) * 0.2; // (1-2nu)/(4G) per N/mm (Johnson 1985, eq. 2.21)
  EXPECT_NEAR(strip.at(0, 2, 1, 0, 2), -full, 1e-12 * full);
  EXPECT_NEAR(strip.at(0, 0, 1, 2, 2), full, 1e-12 * full);
  EXPECT_NEAR(strip.at(0, 2, 2, 0, 1), full, 1e-12 * full);
  EXPECT_EQ(strip.at(0, 1, 1, 1, 2), 0);
}
