#include "bem_contact/inside/remainder.hpp"
#include "bem_contact/inside/stresses_by_file.hpp"
#include "fem_influence/harmonic/body_stresses.hpp"
#include "fem_influence/harmonic/run_plan.hpp"
#include "fem_influence/harmonic/stress_run.hpp"
#include "section_meshes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace bem_contact::fem::test {
namespace {

using halfspace::Stress;
using inside::AreaStresses;
using inside::LoadedInside;
using inside::SurfaceTractions;

/// A body whose stresses are computed twice: by one solution for each wavenumber of this load, and from the
/// stress kernel of all unit loads.
struct TwoWays {
  Folder folder;
  BodyFile body;
  ProfileCurve curve;
  std::filesystem::path mesh = folder / "body.msh";

  explicit TwoWays(ProfileCurve profile) : curve(std::move(profile)) {
    body.harmonic.half_period = 120;
    body.harmonic.degree = 2;
    body.harmonic.border_levels = 0;
    body.stress = {.depths = 14, .deepest = 12, .beyond = 6};
  }

  LoadedInside once(const SurfaceTractions& load) const {
    LoadedInside out{load, inside::halfspace_inside(load, inside::Side::rail)};
    add_body_stresses({&out, 1}, body, curve, mesh, [](std::size_t, std::size_t) {});
    return out;
  }
  StressKernel kernel() const {
    StressKernel out =
        run_stresses(plan_stresses(body, curve), curve, mesh, folder / "out.h5", "", [](std::size_t) {});
    validate(out, static_cast<std::size_t>(body.strip.stations()));
    return out;
  }
  /// Largest difference over the largest von Mises stress; of points that both have.
  void expect_equal(const SurfaceTractions& load, double bar) const {
    const LoadedInside right = once(load);
    LoadedInside found{load, inside::halfspace_inside(load, inside::Side::rail)};
    add_stresses_by_file(found.stresses, load, plan_run(body, curve).function, kernel());
    const AreaStresses &a = found.stresses.areas.at(0), &b = right.stresses.areas.at(0);
    const inside::AreaPeaks peaks = peaks_of(right.stresses, b);
    std::size_t both = 0;
    double worst = 0, rest = 0, beyond = 0;
    for (std::size_t i = 0; i < a.points.size(); ++i)
      for (std::size_t j = 0; j < a.x.size(); ++j) {
        if (!std::isfinite(a.body[i][j].xx) || !std::isfinite(b.body[i][j].xx))
          continue;
        ++both;
        const double off = von_mises(inside::difference(a.body[i][j], b.body[i][j]));
        worst = std::max(worst, off);
        beyond = std::max(beyond, off - a.error[i]);
        rest = std::max(rest, von_mises(inside::difference(b.body[i][j], b.flat[i][j])));
      }
    EXPECT_GT(both, a.points.size() * a.x.size() / 2);
    EXPECT_LT(worst, bar * peaks.von_mises.value)
        << "remainder " << rest << " of " << peaks.von_mises.value << ", beyond the stated error " << beyond;
  }
};

SurfaceTractions contact(double s) {
  return tractions_of({.s = s, .a = 4, .b = 3, .pressure = 1000, .friction = 0.3}, 0.28);
}

/// Convex and concave: what the half-space does not have is large here.
TEST(StressKernel, OfDiscAndBoreIsOneSolutionForEachWavenumber) {
  for (const bool hole : {false, true}) {
    constexpr double radius = 12;
    constexpr int around = 96;
    TwoWays ways(full_circle(radius, hole));
    write_ring_mesh(ways.mesh, radius, hole ? 20 * radius : 0.02 * radius, around);
    ways.body.body.kind = hole ? BodyKind::bore : BodyKind::disc;
    const double width = 2 * std::numbers::pi * radius / around;
    ways.body.strip = {-12 * width, 12 * width, width};
    ways.expect_equal(contact(0.3), 0.004);
  }
}

/// A thin blade, held at its sides and below; points beside it have none.
TEST(StressKernel, OfABladeIsOneSolutionForEachWavenumber) {
  TwoWays ways(straight_line(8));
  write_block_mesh(ways.mesh, 0.5, 6, 8);
  ways.body.body.kind = BodyKind::block;
  ways.body.strip = {-6, 6, 0.5};
  ways.expect_equal(contact(0.2), 0.004);
}

/// Of revolution: lengths and loads are those of the reference radius.
TEST(StressKernel, OfAWheelIsOneSolutionForEachWavenumber) {
  TwoWays ways(straight_line(8, true));
  write_block_mesh(ways.mesh, 0.5, 6, 8, true);
  ways.body.body.kind = BodyKind::outline;
  ways.body.body.reference_radius = 60;
  ways.body.strip = {-6, 6, 0.5};
  ways.expect_equal(contact(0), 0.004);
}

} // namespace
} // namespace bem_contact::fem::test
