#include "bem_contact/base/error.hpp"
#include "bem_contact/reference/hertz.hpp"
#include "tests/reference/conformal.hpp"
#include "tests/reference/line_and_quartic.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

using namespace bem_contact;
using namespace bem_contact::reference;

namespace {
using std::numbers::pi;
constexpr double degree = pi / 180;
const Material steel{82000, 0.28};
} // namespace

TEST(Persson, PublishedVectors) {
  struct Row {
    double eps, clearance, pressure, digits_clearance, digits_pressure;
  };
  for (const Row& row : {Row{10, 82.2206, 3.66156, 5e-5, 5e-6}, Row{20, 19.5353, 1.85239, 5e-5, 5e-6},
                         Row{30, 7.94354, 1.26029, 5e-6, 5e-6}, Row{45, 2.82312, 0.882111, 5e-6, 5e-7},
                         Row{60, 1.06720, 0.711721, 5e-6, 5e-7}, Row{75, 0.287077, 0.628103, 5e-7, 5e-7}}) {
    EXPECT_NEAR(persson_clearance(row.eps * degree), row.clearance, row.digits_clearance) << row.eps;
    EXPECT_NEAR(persson_pressure(row.eps * degree, 0), row.pressure, row.digits_pressure) << row.eps;
    EXPECT_NEAR(persson_half_angle(persson_clearance(row.eps * degree)), row.eps * degree, 1e-13);
  }
  EXPECT_NEAR(persson_half_angle(0) / degree, 84.828, 5e-4);
}

TEST(Persson, ThePinOfTheIssue) {
  const double eps = 30 * degree, radius = 10, clearance = 0.2;
  const double load = plane_strain_modulus(steel) * clearance / persson_clearance(eps);
  EXPECT_NEAR(load, 5734.92, 5e-3);
  EXPECT_NEAR(persson_pressure(eps, 0) * load / radius, 722.77, 5e-3);
  // Hertz at the same load: relative radius R (R + dR)/dR, taken as R^2/dR as conformal theory does.
  const double hertz =
      hertz_line_by_force(radius * radius / clearance, contact_modulus(steel, steel), load).max_pressure;
  EXPECT_NEAR(hertz, 644.83, 5e-3);
}

TEST(Persson, PressureCarriesTheLoadAndVanishesAtTheEdge) {
  for (const double eps : {10 * degree, 45 * degree, 84 * degree}) {
    double sum = 0;
    const int n = 100000;
    for (int i = 0; i < n; ++i) { // angle = eps sin t: no square root at the edge
      const double t = -pi / 2 + (i + 0.5) * pi / n, phi = eps * std::sin(t);
      sum += persson_pressure(eps, phi) * std::cos(phi) * eps * std::cos(t) * pi / n;
    }
    EXPECT_NEAR(sum, 1, 1e-6) << eps;
    EXPECT_EQ(persson_pressure(eps, eps), 0);
    EXPECT_EQ(persson_pressure(eps, 2 * eps), 0);
  }
}

TEST(Persson, SmallAnglesAreHertz) { // E1* dR/Q -> 8/(pi eps^2), p R/Q -> 2/(pi eps)
  EXPECT_NEAR(persson_clearance(1e-3) * pi * 1e-6 / 8, 1, 1e-5);
  EXPECT_NEAR(persson_pressure(1e-3, 0) * pi * 1e-3 / 2, 1, 1e-5);
}

TEST(Persson, RefusesWhatHasNoSolution) {
  EXPECT_THROW(persson_clearance(0), InputError);
  EXPECT_THROW(persson_pressure(4, 0), InputError);
  EXPECT_THROW(persson_half_angle(-1), InputError);
  EXPECT_THROW(persson_half_angle(std::nan("")), InputError);
}

TEST(Michell, PairIsHoleMinusDisc) {
  for (int n = 2; n < 9; ++n) {
    const auto pair = michell_pair(steel, 10, n);
    const auto disc = michell_disc(steel, 10, n), hole = michell_hole(steel, 10, n);
    EXPECT_NEAR(hole.radial - disc.radial, pair[0][0], 1e-14 * pair[0][0]);
    EXPECT_NEAR(hole.circumferential - disc.circumferential, pair[1][0], 1e-14 * pair[0][0]);
    EXPECT_LT(disc.radial, 0); // a pressure presses the disc together
    EXPECT_GT(hole.radial, 0); // and widens the hole
  }
  EXPECT_THROW(michell_pair(steel, 10, 1), InputError);
  EXPECT_THROW(michell_disc(steel, 10, 1), InputError);
  EXPECT_NEAR(michell_pair(steel, 10, 0)[0][0], 20 / plane_strain_modulus(steel), 1e-18);
}

TEST(Michell, LineLoadIsTheSumOfItsHarmonics) {
  // p_0 = P/(2 pi R), p_n = P/(pi R); the sum over n >= 2 misses the rigid motion (cos(th), -sin(th))/4.
  const double radius = 10, load = 100;
  for (const double theta : {0.3, 1.0, 2.5}) {
    double radial = michell_pair(steel, radius, 0)[0][0] * load / (2 * pi * radius), around = 0;
    const int terms = 20000;
    for (int n = 2; n <= terms; ++n) {
      const auto c = michell_pair(steel, radius, n);
      // Fejer's weights: the series of ln is only conditionally convergent.
      const double p = load / (pi * radius) * (1 - n / (terms + 1.0));
      radial += c[0][0] * p * std::cos(n * theta);
      around += c[1][0] * p * std::sin(n * theta);
    }
    const double unit = 4 * load / (pi * plane_strain_modulus(steel));
    const RadialDisplacement closed = michell_line_load(steel, load, theta);
    EXPECT_NEAR(radial / unit, closed.radial / unit - std::cos(theta) / 4, 1e-4);
    EXPECT_NEAR(around / unit, closed.circumferential / unit + std::sin(theta) / 4, 1e-4);
  }
  EXPECT_THROW(michell_line_load(steel, load, 0), InputError);
}

TEST(Michell, LineLoadTurnsNegativeAt41Point9Degrees) {
  EXPECT_GT(michell_line_load(steel, 1, 41.8 * degree).radial, 0);
  EXPECT_LT(michell_line_load(steel, 1, 42.0 * degree).radial, 0);
}

TEST(SphereInSeat, HertzRatioFollowsFromTheOtherColumns) {
  // Hertz with relative radius R^2/dR; in units of R = dR = E = 1 the force is Q/(E dR R).
  const Material m{1 / 2.6, 0.3};
  for (const SeatEntry& entry : sphere_in_seat()) {
    const double hertz = hertz_by_force(0.5, 0.5, contact_modulus(m, m), entry.force).max_pressure;
    EXPECT_NEAR(entry.pressure * entry.force / hertz, entry.pressure_ratio, 5e-4 * entry.pressure_ratio);
  }
}
