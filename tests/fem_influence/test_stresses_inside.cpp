#include "bem_contact/base/error.hpp"
#include "bem_contact/inside/remainder.hpp"
#include "fem_influence/harmonic/body_stresses.hpp"
#include "fem_influence/harmonic/section_stresses.hpp"
#include "section_meshes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace bem_contact::fem::test {
namespace {

using halfspace::Stress;
using inside::AreaStresses;
using inside::BelowSurface;
using inside::difference;
using inside::helper_depths;
using inside::LoadedInside;
using inside::Remainder;
using inside::StressesInside;
using inside::SurfaceTractions;
using inside::towards_surface;

void without_progress(std::size_t, std::size_t) {}

BodyFile block_body() {
  BodyFile body;
  body.body.kind = BodyKind::block;
  body.strip = {-6, 6, 0.5};
  body.harmonic.half_period = 200;
  return body;
}

StressesInside inside_block(const SurfaceTractions& load, std::span<const BelowSurface> own = {}) {
  const Folder folder;
  write_block_mesh(folder / "block.msh", 0.5, 6, 150);
  std::vector<LoadedInside> loads{{load, inside::halfspace_inside(load, inside::Side::rail, own)}};
  add_body_stresses(loads, block_body(), straight_line(150), folder / "block.msh", without_progress);
  return loads[0].stresses;
}

std::array<double, 6> components(const Stress& t) {
  return {t.xx, t.ss, t.nn, t.xs, t.xn, t.sn};
}

/// Largest difference of a component, MPa.
double largest_difference(const Stress& a, const Stress& b) {
  double out = 0;
  for (const double d : components(difference(a, b)))
    out = std::max(out, std::abs(d));
  return out;
}

/// From the surface on, a large flat block has the stresses of the half-space's closed forms within 0.5 % of
/// the largest von Mises stress, with and without friction. The stated error covers that.
TEST(StressesInside, OfAFlatBlockAreTheHalfSpaces) {
  for (const double friction : {0.0, 0.3}) {
    const StressesInside found =
        inside_block(tractions_of({.s = 0, .a = 5, .b = 4, .pressure = 1000, .friction = friction}, 0.28));
    const AreaStresses& area = found.areas.at(0);
    const double scale = peaks_of(found, area).flat_von_mises.value;
    EXPECT_NEAR(peaks_of(found, area).von_mises.value, scale, 0.002 * scale);
    double worst = 0;
    for (std::size_t i = 0; i < area.points.size(); ++i) {
      double here = 0;
      for (std::size_t j = 0; j < area.x.size(); ++j)
        here = std::max(here, largest_difference(area.body[i][j], area.flat[i][j]));
      worst = std::max(worst, here);
      EXPECT_LE(here, area.error[i] + 0.004 * scale);
    }
    EXPECT_LT(worst, 0.005 * scale) << friction;
  }
}

/// The unit traction of one element, along each axis, from a tenth of its width on: within 0.5 % of the
/// traction.
TEST(StressesInside, OfOneElementAreTheHalfSpaces) {
  std::vector<BelowSurface> points;
  for (const double depth : {0.05, 0.1, 0.25, 0.5, 1.0, 2.0, 4.0})
    points.push_back({0.25, depth});
  for (const int component : {int(component_x), int(component_s), int(component_n)}) {
    SurfaceTractions one{
        .dx = 0.5, .ds = 0.5, .x0 = 0, .columns = 1, .s = {0.25}, .px = {0}, .ps = {0}, .pn = {1e-9}};
    (component == component_x ? one.px : component == component_s ? one.ps : one.pn) = {1};
    const StressesInside found = inside_block(one, points);
    const AreaStresses& area = found.areas.at(0);
    for (std::size_t i = 0; i < points.size(); ++i) {
      double worst = 0;
      for (std::size_t j = 0; j < area.x.size(); ++j)
        worst = std::max(worst, largest_difference(area.body[i][j], area.flat[i][j]));
      EXPECT_LT(worst, 0.005) << component << " depth " << points[i].depth;
    }
  }
}

/// Hertz on a circle: 0.3146 p0 is the largest shear on the axis, 0.47 a deep (nu = 0.28).
TEST(StressesInside, OfAHertzCircle) {
  const StressesInside found = inside_block(tractions_of({.s = 0, .a = 4, .b = 4, .pressure = 1000}, 0.28));
  const inside::Peak shear = peaks_of(found, found.areas.at(0)).shear;
  EXPECT_NEAR(shear.value, 314.6, 0.01 * 314.6);
  EXPECT_NEAR(shear.at.depth, 0.47 * 4, 0.3);
}

/// What a box below the contact bears, nn on its bottom and sn on its sides, is the force on its top.
TEST(StressesInside, BearTheForce) {
  const Folder folder;
  write_block_mesh(folder / "block.msh", 0.5, 6, 150, false, 1.25);
  BodyFile body = block_body();
  body.harmonic.border_levels = 0;
  const ProfileCurve curve = straight_line(150);
  constexpr int rows = 24, columns = 20;
  SurfaceTractions load{.dx = 0.5, .ds = 0.5, .x0 = -4.75, .columns = columns};
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      if (column == 0)
        load.s.push_back(-5.75 + 0.5 * row);
      const bool loaded = row >= 8 && row < 16;
      load.pn.push_back(loaded ? 100 : 0);
      load.px.push_back(loaded ? 30 : 0);
      load.ps.push_back(0);
    }
  AskedStresses plane;
  for (double s = -98; s < 99; s += 4) // middles of equal steps
    plane.points.push_back({s, 8});
  for (const double side : {-100.0, 100.0})
    for (const double depth : {1.0, 3.0, 5.0, 7.0})
      plane.points.push_back({side, depth});
  for (double x = -198; x < 199; x += 4)
    plane.x.push_back(x);
  const SectionTask on{.body = body,
                       .curve = curve,
                       .mesh = folder / "block.msh",
                       .tractions = {&load, 1},
                       .least_depth = 6,
                       .areas = {plane}};
  const SectionStresses found = section_stresses(on, without_progress);
  double borne = 0;
  for (std::size_t i = 0; i < plane.points.size(); ++i)
    for (const Stress& t : found.areas.at(0)[i])
      borne -= plane.points[i].depth == 8 ? 16 * t.nn : (plane.points[i].s > 0 ? 8 : -8) * t.sn;
  const double force = load.force()[component_n];
  EXPECT_NEAR(borne, force, 0.001 * force);
}

/// Of a disc or a bore of this radius in plane strain: it is loaded over the whole period.
struct RoundBody {
  static constexpr double radius = 10;
  static constexpr int count = 48;
  Folder folder;
  bool hole;
  ProfileCurve circle;
  BodyFile body;
  SurfaceTractions tractions;

  explicit RoundBody(bool is_bore) : hole(is_bore), circle(full_circle(radius, is_bore)) {
    write_ring_mesh(folder / "ring.msh", radius, hole ? 40 * radius : 0.02 * radius, count);
    body.body.kind = hole ? BodyKind::bore : BodyKind::disc;
    body.strip = {circle.s_begin(), circle.s_end(), (circle.s_end() - circle.s_begin()) / count};
    body.harmonic.remote_distance = 0.5 * radius;
    body.harmonic.half_period = 4 * radius;
    body.harmonic.degree = 2;
    body.harmonic.border_levels = 0;
    tractions = {.dx = 8 * radius, .ds = body.strip.station_width, .x0 = 0, .columns = 1};
    for (int i = 0; i < count; ++i)
      tractions.s.push_back(circle.s_begin() + (i + 0.5) * tractions.ds);
    tractions.px.assign(count, 0), tractions.ps = tractions.px, tractions.pn = tractions.px;
  }
  std::vector<inside::Passage> stresses(const std::vector<BelowSurface>& points) const {
    return section_stresses({.body = body,
                             .curve = circle,
                             .mesh = folder / "ring.msh",
                             .tractions = {&tractions, 1},
                             .least_depth = 2.5,
                             .areas = {{.load = 0, .points = points, .x = {0}}}},
                            without_progress)
        .areas.at(0);
  }
};

/// Michell's solutions of a disc and of a bore under the pressure p cos 2 phi: in a disc
/// rr = -p cos 2 phi, tt = p (1 - 2 r2/R2) cos 2 phi, rt = p (1 - r2/R2) sin 2 phi; around a bore
/// rr = p (R4/r4 - 2 R2/r2) cos 2 phi, tt = -p R4/r4 cos 2 phi, rt = p (R4/r4 - R2/r2) sin 2 phi.
TEST(StressesInside, OfDiscAndBoreAreMichells) {
  for (const bool hole : {false, true}) {
    RoundBody round(hole);
    const double half = std::numbers::pi / RoundBody::count * 2,
                 p = std::sin(half) / half; // constant on each station
    for (int i = 0; i < RoundBody::count; ++i)
      round.tractions.pn[static_cast<std::size_t>(i)] =
          std::cos(2 * round.tractions.s[static_cast<std::size_t>(i)] / RoundBody::radius);
    std::vector<BelowSurface> points;
    for (const double phi : {0.3, 1.1, 2.0})
      for (const double depth : {2.5, 4.0, 6.0})
        points.push_back({phi * RoundBody::radius, depth});
    const std::vector<inside::Passage> found = round.stresses(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double phi = points[i].s / RoundBody::radius, c = std::cos(2 * phi), s = std::sin(2 * phi);
      const double r = (RoundBody::radius + (hole ? 1 : -1) * points[i].depth) / RoundBody::radius,
                   r2 = r * r;
      const Stress right = hole ? Stress{.ss = -p * c / (r2 * r2),
                                         .nn = p * c * (1 / (r2 * r2) - 2 / r2),
                                         .sn = p * s * (1 / (r2 * r2) - 1 / r2)}
                                : Stress{.ss = p * c * (1 - 2 * r2), .nn = -p * c, .sn = -p * s * (1 - r2)};
      const Stress& t = found[i].at(0);
      EXPECT_NEAR(t.ss, right.ss, 0.005) << hole << " " << i;
      EXPECT_NEAR(t.nn, right.nn, 0.005) << hole << " " << i;
      EXPECT_NEAR(t.sn, right.sn, 0.005) << hole << " " << i;
      EXPECT_NEAR(t.xx, 0.28 * (right.ss + right.nn), 0.005) << hole << " " << i;
    }
  }
}

/// The middle of the disc is held, which shows near it. A disc between two opposite line loads P: both
/// Flamant's, and P / (pi R) in all directions (Timoshenko and Goodier, Theory of Elasticity, section 41).
TEST(StressesInside, OfADiscBetweenTwoLineLoads) {
  RoundBody round(false);
  round.body.harmonic.degree = 3; // stresses rise steeply below the loads
  constexpr double radius = RoundBody::radius;
  const std::size_t n = RoundBody::count;
  for (const std::size_t station : {n / 2 - 1, n / 2, n - 1, std::size_t(0)})
    round.tractions.pn[station] = 100;
  const std::vector<BelowSurface> points{{0, 3}, {0, 5}, {0, 6}, {3, 4}, {50, 5}, {9, 3}};
  const std::vector<inside::Passage> found = round.stresses(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const CurvePoint above = round.circle.at(points[i].s);
    const Point2 at = above.position + points[i].depth * normal_of(above.delta);
    double yy = 0, zz = 0, yz = 0;
    constexpr int parts = 200;
    for (int j = 0; j < parts; ++j) {
      const double angle = 4 * std::numbers::pi / double(n) * ((j + 0.5) / parts - 0.5),
                   load = 100 * radius * 4 * std::numbers::pi / double(n) / parts;
      for (const double side : {1.0, -1.0}) {
        const Point2 from{side * radius * std::sin(angle), side * radius * std::cos(angle)};
        const Point2 way = at - from, inwards = (-1 / radius) * from;
        const double r2 = dot(way, way), radial = -2 * load / std::numbers::pi * dot(way, inwards) / r2;
        yy += radial * way.y * way.y / r2, zz += radial * way.z * way.z / r2,
            yz += radial * way.y * way.z / r2;
      }
      yy += load / (std::numbers::pi * radius), zz += load / (std::numbers::pi * radius);
    }
    const double c = std::cos(above.delta), s = std::sin(above.delta);
    const Stress& t = found[i].at(0);
    const double scale = std::abs(yy) + std::abs(zz);
    EXPECT_NEAR(t.ss, yy * c * c + zz * s * s + 2 * yz * c * s, 0.005 * scale) << i;
    EXPECT_NEAR(t.nn, yy * s * s + zz * c * c - 2 * yz * c * s, 0.005 * scale) << i;
    EXPECT_NEAR(t.sn, (zz - yy) * c * s + yz * (c * c - s * s), 0.005 * scale) << i;
  }
}

/// What a body has more than the half-space is carried to the surface as a parabola, and no traction is
/// there.
TEST(Remainder, IsNoTractionOfTheSurface) {
  const auto at = [](double d) { // along: 3 + 2 d + d2; across: 5 d + d2
    const double along = 3 + 2 * d + d * d, across = 5 * d + d * d;
    return inside::Passage{{along, -along, across, 2 * along, -across, 3 * across}};
  };
  const std::vector<inside::Passage> helpers{at(helper_depths[0]), at(helper_depths[1]),
                                             at(helper_depths[2])};
  for (const double d : {0.0, 0.3, 0.9}) {
    const Remainder found = towards_surface(helpers, d, 0);
    EXPECT_NEAR(largest_difference(found.stresses.at(0), at(d).at(0)), 0, 1e-12) << d;
    EXPECT_GT(found.error, 0);
  }
  const Stress surface = towards_surface(helpers, 0, 0).stresses.at(0);
  EXPECT_EQ(surface.nn, 0);
  EXPECT_EQ(surface.xn, 0);
  EXPECT_EQ(surface.sn, 0);
}

TEST(StressesInside, RefusesALoadBesideTheStrip) {
  EXPECT_THROW(inside_block(tractions_of({.s = 4, .a = 3, .b = 3, .pressure = 1}, 0.28)), InputError);
}

/// The section below a patch may reach beyond a thin body: its points there have none, and all others have
/// what a wide body has nearly, more of it.
TEST(StressesInside, OfAThinBodyEndAtItsSides) {
  const Folder folder;
  write_block_mesh(folder / "blade.msh", 0.5, 6, 8);
  const SurfaceTractions load = tractions_of({.s = 0, .a = 4, .b = 4, .pressure = 1000}, 0.28);
  std::vector<LoadedInside> loads{{load, inside::halfspace_inside(load, inside::Side::rail)}};
  add_body_stresses(loads, block_body(), straight_line(8), folder / "blade.msh", without_progress);
  const StressesInside& found = loads[0].stresses;
  const AreaStresses& area = found.areas.at(0);
  int beside = 0;
  for (std::size_t i = 0; i < area.points.size(); ++i) {
    const BelowSurface& p = area.points[i];
    if (std::abs(p.s) > 8) {
      ++beside;
      EXPECT_FALSE(std::isfinite(area.body[i][0].xx)) << p.s;
    } else if (std::abs(p.s) < 7.9 && p.depth < 7.5) {
      EXPECT_TRUE(std::isfinite(area.body[i][0].xx)) << p.s << ' ' << p.depth;
    }
  }
  EXPECT_GT(beside, 0);
  EXPECT_GT(peaks_of(found, area).von_mises_change, 0.02);
}

/// Two loads in one run have what each has alone: they share factors and the widest set of waves.
TEST(StressesInside, OfTwoLoadsAreThoseOfEach) {
  const Folder folder;
  write_block_mesh(folder / "block.msh", 0.5, 6, 30);
  const auto inside_of = [&](const std::vector<EllipticalLoad>& ellipses) {
    std::vector<LoadedInside> loads;
    for (const EllipticalLoad& ellipse : ellipses) {
      const SurfaceTractions load = tractions_of(ellipse, 0.28);
      loads.push_back({load, inside::halfspace_inside(load, inside::Side::rail)});
    }
    add_body_stresses(loads, block_body(), straight_line(30), folder / "block.msh", without_progress);
    return loads;
  };
  const EllipticalLoad wide{.s = 0, .a = 4, .b = 4, .pressure = 1000, .friction = 0.3},
      narrow{.s = 1, .a = 3, .b = 3.5, .pressure = 800};
  const auto both = inside_of({wide, narrow});
  for (std::size_t load = 0; load < 2; ++load) {
    const auto alone = inside_of({load == 0 ? wide : narrow});
    const AreaStresses &a = both[load].stresses.areas.at(0), &b = alone[0].stresses.areas.at(0);
    ASSERT_EQ(a.points.size(), b.points.size());
    double largest = 0, off = 0;
    for (std::size_t i = 0; i < a.points.size(); ++i)
      for (std::size_t j = 0; j < a.x.size(); ++j) {
        largest = std::max(largest, von_mises(b.body[i][j]));
        off = std::max(off, von_mises(difference(a.body[i][j], b.body[i][j])) - b.error[i]);
      }
    EXPECT_LT(off, 1e-4 * largest) << load;
  }
}

/// Points that lie beside the body have no stresses there, and those of the half-space all the same.
TEST(StressesInside, KnowWhereTheBodyEnds) {
  const std::vector<BelowSurface> points{{0, 2}, {0, 151}};
  const StressesInside found =
      inside_block(tractions_of({.s = 0, .a = 3, .b = 3, .pressure = 1}, 0.28), points);
  EXPECT_TRUE(std::isfinite(found.areas.at(0).body[0][0].xx));
  EXPECT_FALSE(std::isfinite(found.areas.at(0).body[1][0].xx));
  EXPECT_TRUE(std::isfinite(found.areas.at(0).flat[1][0].xx));
}

} // namespace
} // namespace bem_contact::fem::test
