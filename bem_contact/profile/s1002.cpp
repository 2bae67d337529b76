#include "bem_contact/profile/s1002.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace bem_contact {

namespace {

// EN 13715:2020, S1002 (also UIC 510-2): zone by zone from the field side to the flange back.

struct PolynomialZone {
  double from, to; ///< y, from > to
  std::array<double, 9> c;
};

constexpr PolynomialZone zone_a{60, 32.15796, {1.364323640, -0.066666667}};
constexpr PolynomialZone zone_b{32.15796,
                                -26,
                                {0, -3.358537058e-2, 1.565681624e-3, -2.810427944e-5, 5.844240864e-8,
                                 -1.562379023e-8, 5.309217349e-15, -5.957839843e-12, 2.646656573e-13}};
constexpr PolynomialZone zone_c{-26,
                                -35,
                                {-4.320221063e3, -1.038384026e3, -1.065501873e2, -6.051367875,
                                 -2.054332446e-1, -4.169739389e-3, -4.687195829e-5, -2.252755540e-7}};
constexpr PolynomialZone zone_e{-38.426669071, -39.764473993, {-93.576667419, -2.747477419}};

struct ArcZone {
  double from, to; ///< y, from > to
  Point2 centre;
  double radius; ///< > 0: z = centre + root, convex; < 0: z = centre - root, concave
};

constexpr ArcZone zone_d{-35, -38.426669071, {-26.210665, 16.446}, -13};
constexpr ArcZone zone_f{-39.764473993, -49.662510381, {-58.558326413, 8.834924130}, 20};
constexpr ArcZone zone_g{-49.662510381, -62.764705882, {-55, 16}, 12};
constexpr ArcZone zone_h{-62.764705882, -70, {-49.5, 9.519259302}, 20.5};

double height(const PolynomialZone& zone, double y) {
  long double z = 0;
  for (std::size_t k = zone.c.size(); k-- > 0;)
    z = z * y + zone.c[k];
  return static_cast<double>(z);
}

double height(const ArcZone& zone, double y) {
  const double root = std::sqrt(std::max(0.0, zone.radius * zone.radius - std::pow(y - zone.centre.y, 2)));
  return zone.centre.z + std::copysign(root, zone.radius);
}

/// Pieces of at most s1002_piece, each about its own start: (y, z) = (y0 - t, zone(y0 - t)).
void add(std::vector<CurvePiece>& pieces, const PolynomialZone& zone) {
  const int count = static_cast<int>(std::ceil((zone.from - zone.to) / s1002_piece));
  for (int i = 0; i < count; ++i) {
    const double y0 = zone.from + (zone.to - zone.from) * i / count;
    const double y1 = zone.from + (zone.to - zone.from) * (i + 1) / count;
    std::array<long double, 9> c{};
    std::copy(zone.c.begin(), zone.c.end(), c.begin());
    // Taylor shift to y0 by repeated synthetic division; in long double, zone C cancels four digits.
    for (std::size_t k = 0; k < c.size(); ++k)
      for (std::size_t j = c.size() - 1; j-- > k;)
        c[j] += c[j + 1] * static_cast<long double>(y0);
    std::array<double, 9> z{};
    for (std::size_t k = 0; k < c.size(); ++k)
      z[k] = static_cast<double>(k % 2 == 0 ? c[k] : -c[k]);
    pieces.push_back(polynomial_piece(std::array<double, 2>{y0, -1}, z, y0 - y1));
  }
}

void add(std::vector<CurvePiece>& pieces, const ArcZone& zone) {
  const double sign = zone.radius > 0 ? 1 : -1;
  const auto inclination = [&](double y) {
    const Point2 outward = Point2{y, height(zone, y)} - zone.centre;
    const double delta = std::atan2(sign * outward.y, -sign * outward.z);
    return delta < 0 ? delta + 2 * std::numbers::pi : delta;
  };
  const double start = inclination(zone.from), end = inclination(zone.to);
  pieces.push_back(arc_piece({zone.from, height(zone, zone.from)}, start, 1 / zone.radius,
                             std::abs((end - start) * zone.radius)));
}

} // namespace

ProfileCurve s1002_profile() {
  std::vector<CurvePiece> pieces;
  pieces.push_back(
      line_piece({zone_a.from, height(zone_a, zone_a.from)}, {zone_a.to, height(zone_a, zone_a.to)}));
  add(pieces, zone_b);
  // So that the tread is where the formulas put it, the line of zone A starts at the small jump off it.
  const Point2 jump = pieces[1].start - point_on(pieces[0], pieces[0].length).position;
  pieces[0].start = pieces[0].start + jump;
  pieces[0].middle = pieces[0].middle + jump;
  add(pieces, zone_c);
  add(pieces, zone_d);
  pieces.push_back(
      line_piece({zone_e.from, height(zone_e, zone_e.from)}, {zone_e.to, height(zone_e, zone_e.to)}));
  add(pieces, zone_f);
  add(pieces, zone_g);
  add(pieces, zone_h);
  return ProfileCurve::from_pieces("S1002", std::move(pieces));
}

double s1002_height(double y) {
  if (!(y >= zone_h.to && y <= zone_a.from))
    throw InputError(fmt::format("y = {} mm is off the profile S1002", y), "it runs from -70 to 60 mm",
                     "Ask for a point on the profile.");
  for (const PolynomialZone& zone : {zone_a, zone_b, zone_c, zone_e})
    if (y >= zone.to && y <= zone.from)
      return height(zone, y);
  for (const ArcZone& zone : {zone_d, zone_f, zone_g})
    if (y >= zone.to && y <= zone.from)
      return height(zone, y);
  return height(zone_h, y);
}

} // namespace bem_contact
