#include "fem_influence/harmonic/body_stresses.hpp"

#include "bem_contact/base/error.hpp"
#include "fem_influence/harmonic/remainder.hpp"
#include "fem_influence/harmonic/section_stresses.hpp"
#include "fem_influence/shared/body_description.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

namespace bem_contact::fem {

namespace {

using inside::AreaStresses;
using inside::BelowSurface;
using inside::Passage;
using inside::SurfaceTractions;

/// 1. Elements of an elliptical load along each axis, and points of each for the mean.
constexpr int elements_across = 24, points_of_mean = 6;
/// 1 (mm). A station's share of a row that is less is none.
constexpr double no_overlap = 1e-9;

/// What the rows bear on each station: forces are kept.
SurfaceTractions on_stations(const SurfaceTractions& t, std::span<const Station> stations, double width) {
  SurfaceTractions out = t;
  out.ds = width;
  out.s.clear();
  for (const Station& station : stations)
    out.s.push_back(station.s);
  for (std::vector<double>* field : {&out.px, &out.ps, &out.pn})
    field->assign(stations.size() * static_cast<std::size_t>(t.columns), 0);
  for (int row = 0; row < t.rows(); ++row) {
    const auto from = static_cast<std::size_t>(row * t.columns);
    const auto loaded = [&](std::size_t c) { return t.at(from + c) != std::array<double, 3>{}; };
    bool any = false;
    for (std::size_t c = 0; c < static_cast<std::size_t>(t.columns); ++c)
      any = any || loaded(c);
    if (!any)
      continue;
    const double s = t.s[static_cast<std::size_t>(row)];
    double covered = 0;
    for (std::size_t J = 0; J < stations.size(); ++J) {
      const double overlap = std::min(s + t.ds / 2, stations[J].s + width / 2) -
                             std::max(s - t.ds / 2, stations[J].s - width / 2);
      if (overlap <= no_overlap)
        continue;
      covered += overlap;
      for (std::size_t c = 0; c < static_cast<std::size_t>(t.columns); ++c) {
        const std::size_t to = J * static_cast<std::size_t>(t.columns) + c;
        out.px[to] += overlap / width * t.px[from + c];
        out.ps[to] += overlap / width * t.ps[from + c];
        out.pn[to] += overlap / width * t.pn[from + c];
      }
    }
    if (covered < (1 - 1e-6) * t.ds)
      throw InputError("The load leaves the strip", "its rows need stations",
                       "Move it, or give the body a longer strip.");
  }
  return out;
}

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

/// The depths of a column of points at which the body is solved for, besides those of the points.
struct AreaPlan {
  double least_depth = 0;                ///< mm
  std::vector<BelowSurface> probes;      ///< the points that are deep enough, then those of `columns`
  std::vector<int> own;                  ///< of each point its probe; -1: above the least depth, or beside
  std::vector<std::size_t> first_helper; ///< of each point above it, the first of three probes; else 0

  AreaPlan(const AreaStresses& area, const ProfileCurve& curve, double size, double station_width)
      : least_depth(std::max(least_depth_of_size * size, least_depth_of_station * station_width)) {
    for (const BelowSurface& p : area.points) {
      own.push_back(p.depth >= least_depth && is_below(curve, p) ? static_cast<int>(probes.size()) : -1);
      if (own.back() >= 0)
        probes.push_back(p);
    }
    std::vector<std::pair<double, std::size_t>> known; // arc lengths that have helpers
    for (std::size_t i = 0; i < area.points.size(); ++i) {
      first_helper.push_back(0);
      if (own[i] >= 0 || !is_below(curve, area.points[i]))
        continue;
      const double s = area.points[i].s;
      const auto found = std::ranges::find(known, s, &std::pair<double, std::size_t>::first);
      if (found != known.end()) {
        first_helper[i] = found->second;
        continue;
      }
      first_helper[i] = probes.size();
      known.emplace_back(s, probes.size());
      for (const double depth : helper_depths)
        probes.push_back({s, depth * least_depth});
    }
  }
};

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
        const AreaPlan& plan =
            plans.emplace_back(area, curve_, area.section ? area.section->size : load_size(tractions_[load]),
                               body_.strip.station_width);
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
    std::vector<Passage> rest = halfspace_stresses(tractions, plan.probes, columns);
    std::vector<double> error(plan.probes.size(), 0);
    for (std::size_t i = 0; i < rest.size(); ++i)
      for (std::size_t j = 0; j < rest[i].size(); ++j) {
        rest[i][j] = difference(found[i][j], rest[i][j]);
        if (coarse)
          error[i] = std::max(error[i], von_mises(difference((*coarse)[i][j], found[i][j])));
      }
    area.curvature = mean_curvature(curve_, area.points);
    for (std::size_t i = 0; i < area.points.size(); ++i) {
      const BelowSurface& p = area.points[i];
      area.positions.push_back(position_of(curve_, p));
      if (!is_below(curve_, p)) {
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        area.body.emplace_back(area.x.size(), halfspace::Stress{none, none, none, none, none, none});
        area.error.push_back(0);
        continue;
      }
      const Remainder at =
          plan.own[i] >= 0
              ? Remainder{rest[static_cast<std::size_t>(plan.own[i])],
                          error[static_cast<std::size_t>(plan.own[i])]}
              : towards_surface(std::span(rest).subspan(plan.first_helper[i], helper_depths.size()),
                                p.depth / plan.least_depth, error[plan.first_helper[i]]);
      Passage sum = area.flat[i];
      for (std::size_t j = 0; j < sum.size(); ++j)
        sum[j].add(1, at.stresses[j]);
      area.body.push_back(std::move(sum));
      area.error.push_back(at.error);
    }
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
