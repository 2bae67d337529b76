#include "fem_influence/harmonic/body_stresses.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/inside/on_stations.hpp"
#include "bem_contact/inside/remainder.hpp"
#include "bem_contact/inside/settings.hpp"
#include "fem_influence/harmonic/section_stresses.hpp"
#include "fem_influence/shared/body_description.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

namespace bem_contact::fem {

namespace {

using inside::AreaPlan;
using inside::AreaStresses;
using inside::BelowSurface;
using inside::LoadedInside;
using inside::Passage;
using inside::SurfaceTractions;

/// 1. Elements of an elliptical load along each axis, and points of each for the mean.
constexpr int elements_across = 24, points_of_mean = 6;
/// 1 (smaller half width of the patch). The least depth at which the body is solved for, or that of stations.
constexpr double least_depth_of_size = 0.2;

/// Says whether the profile is above a point: beside the side of a thin body it is not.
bool is_below(const ProfileCurve& curve, const BelowSurface& p) {
  return p.s >= curve.s_begin() && p.s <= curve.s_end();
}

/// Beside the profile's ends as if it went on straight.
Point2 position_of(const ProfileCurve& curve, const BelowSurface& p) {
  const double s = std::clamp(p.s, curve.s_begin(), curve.s_end());
  const CurvePoint above = curve.at(s);
  return above.position + (p.s - s) * tangent_of(above.delta) + p.depth * normal_of(above.delta);
}

/// Mean curvature of the surface over the patch.
double mean_curvature(const ProfileCurve& curve, const std::vector<BelowSurface>& points) {
  const auto [first, last] = std::ranges::minmax(points, {}, &BelowSurface::s);
  const double from = std::max(first.s, curve.s_begin()), to = std::min(last.s, curve.s_end());
  return to > from ? (curve.at(to).delta - curve.at(from).delta) / (to - from) : curve.at(from).curvature;
}

/// Half of the shorter side of the smallest patch, mm.
double load_size(const SurfaceTractions& t) {
  double out = std::numeric_limits<double>::max();
  for (const std::vector<int>& elements : inside::loaded_patches(t))
    out = std::min(out, inside::section_below(t, elements).size);
  return out;
}

class BodyStresses {
public:
  BodyStresses(const BodyFile& body, const ProfileCurve& curve, const std::filesystem::path& mesh,
               std::span<const LoadedInside> loads)
      : body_(body), curve_(curve), mesh_(mesh), stations_(make_stations(body.strip, curve)) {
    for (const LoadedInside& load : loads)
      tractions_.push_back(on_stations(load.tractions, stations_, body.strip.station_width));
    require_mesh_of(body, curve, mesh);
    body_.harmonic.border_levels = 0; // the remainder has no jumps
  }

  void add_to(std::span<LoadedInside> loads, const StressProgress& progress) const {
    std::vector<AreaPlan> plans;
    SectionTask task{.body = body_,
                     .curve = curve_,
                     .mesh = mesh_,
                     .tractions = tractions_,
                     .least_depth = 1e9,
                     .areas = {}};
    for (std::size_t load = 0; load < loads.size(); ++load)
      for (const AreaStresses& area : loads[load].stresses.areas) {
        if (!area.section)
          std::ranges::for_each(area.points, [&](const BelowSurface& p) { require_below(p); });
        const double size = area.section ? area.section->size : load_size(tractions_[load]);
        const AreaPlan& plan = plans.emplace_back(
            area.points,
            std::max(least_depth_of_size * size, inside::least_depth_of_station * body_.strip.station_width),
            [&](const BelowSurface& p) { return is_below(curve_, p); });
        task.least_depth = std::min(task.least_depth, plan.least_depth);
        task.areas.push_back({.load = load, .points = plan.probes, .x = area.x});
      }
    const bool has_companion = body_.harmonic.degree > 1;
    const auto shown = [&](std::size_t before) {
      return [&, before](std::size_t done, std::size_t all) {
        progress(before + done, has_companion ? 2 * all : all);
      };
    };
    const SectionStresses found = section_stresses(task, shown(0));
    std::optional<SectionStresses> coarse;
    if (has_companion) {
      --task.body.harmonic.degree;
      coarse = section_stresses(task, shown(found.wavenumbers));
    }
    std::size_t k = 0;
    for (std::size_t load = 0; load < loads.size(); ++load) {
      inside::StressesInside& out = loads[load].stresses;
      out.unknowns = found.unknowns;
      out.wavenumbers = found.wavenumbers;
      out.body = curve_.name();
      for (AreaStresses& area : out.areas) {
        add_area(area, tractions_[load], plans[k], found.areas[k], coarse ? &coarse->areas[k] : nullptr);
        ++k;
      }
    }
  }

private:
  /// Of points of one's own; those below a patch may reach beyond a thin body, and have no stresses there.
  void require_below(const BelowSurface& p) const {
    if (!is_below(curve_, p))
      throw InputError("A point lies beside the profile", "its arc length is beyond the profile's ends",
                       "Move it, or leave it out.");
  }

  void add_area(AreaStresses& area, const SurfaceTractions& tractions, const AreaPlan& plan,
                const std::vector<Passage>& found, const std::vector<Passage>* coarse) const {
    // the half-space under the same tractions on stations, which the body was solved for
    std::vector<int> columns;
    for (const double x : area.x)
      columns.push_back(static_cast<int>(std::lround((x - tractions.x0) / tractions.dx)));
    inside::ProbedRemainder rest{halfspace_stresses(tractions, plan.probes, columns),
                                 std::vector<double>(plan.probes.size(), 0)};
    for (std::size_t i = 0; i < plan.probes.size(); ++i)
      for (std::size_t j = 0; j < area.x.size(); ++j) {
        rest.stresses[i][j] = inside::difference(found[i][j], rest.stresses[i][j]);
        if (coarse)
          rest.error[i] =
              std::max(rest.error[i], halfspace::von_mises(inside::difference((*coarse)[i][j], found[i][j])));
      }
    area.curvature = mean_curvature(curve_, area.points);
    for (const BelowSurface& p : area.points)
      area.positions.push_back(position_of(curve_, p));
    add_remainder(area, plan, rest);
  }

  BodyFile body_;
  const ProfileCurve& curve_;
  std::filesystem::path mesh_;
  std::vector<Station> stations_;
  std::vector<SurfaceTractions> tractions_; ///< of each load on the stations
};

} // namespace

inside::SurfaceTractions tractions_of(const EllipticalLoad& load, double poisson) {
  SurfaceTractions out;
  out.dx = 2 * load.a / elements_across;
  out.ds = 2 * load.b / elements_across;
  out.x0 = -load.a + out.dx / 2;
  out.columns = elements_across;
  out.poisson = poisson;
  for (int row = 0; row < elements_across; ++row) {
    out.s.push_back(load.s - load.b + (row + 0.5) * out.ds);
    for (int column = 0; column < elements_across; ++column) {
      double mean = 0;
      for (int i = 0; i < points_of_mean; ++i)
        for (int j = 0; j < points_of_mean; ++j) {
          const double x = out.x(column) / load.a +
                           2.0 / elements_across * ((i + 0.5) / points_of_mean - 0.5),
                       s = (out.s.back() - load.s) / load.b +
                           2.0 / elements_across * ((j + 0.5) / points_of_mean - 0.5);
          mean += std::sqrt(std::max(0.0, 1 - x * x - s * s)) / (points_of_mean * points_of_mean);
        }
      out.pn.push_back(load.pressure * mean);
      out.px.push_back(load.friction * load.pressure * mean);
      out.ps.push_back(0);
    }
  }
  return out;
}

void add_body_stresses(std::span<LoadedInside> loads, const BodyFile& body, const ProfileCurve& curve,
                       const std::filesystem::path& mesh, const StressProgress& progress) {
  BodyStresses(body, curve, mesh, loads).add_to(loads, progress);
}

} // namespace bem_contact::fem
