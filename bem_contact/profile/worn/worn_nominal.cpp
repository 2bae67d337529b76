#include "bem_contact/profile/worn/worn_nominal.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/median.hpp"
#include "bem_contact/profile/settings.hpp"
#include "bem_contact/profile/worn/settings.hpp"
#include "bem_contact/profile/worn/wear_depth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

namespace bem_contact {

namespace {

/// mm. No rail or wheel in service is worn by more; a point farther off is that of another shape.
constexpr double farthest_from_nominal = 5.0;
/// mm. Root mean square, as above. Chosen.
constexpr double farthest_rms_from_nominal = 2.0;
/// mm. So near a point lies on the nominal profile but for its scatter.
constexpr double lies_on_nominal = 0.02;
/// 1 (component of the normal along y). Flanks of rails are steeper: beyond 53 degrees.
constexpr double steep_normal = 0.8;
/// 1. Fewer points tell no depth.
constexpr std::size_t least_nominal_points = 20;
/// 1 (median distances of points). Depths nearer to each other become one.
constexpr double least_depth_step = 0.3;
/// mm. A jump of the nominal curvature is looked for so far before and after a joint.
constexpr double jump_distance = 1e-6;
/// 1/mm. Less is no jump: it moves no curvature in contact by a thousandth.
constexpr double curvature_jump = 1e-5;
/// 1. Chords of a worn profile from one jump to the next, at least: a cubic spline needs four points.
constexpr std::ptrdiff_t least_smooth_chords = 4;

/// Depths over the arc length of the nominal profile, in rising order.
struct Depths {
  std::vector<double> s, depth;
};

/// Points that scatter along the profile may change places or come too near to each other: those within a
/// part of the usual distance become their mean.
Depths depths_on(const ProfileCurve& nominal, std::span<const Point2> points, const NominalPlace& place,
                 double spacing) {
  std::vector<PointOnNominal> seen;
  for (const Point2 p : points)
    if (const PointOnNominal one = seen_from(nominal, p, place); !one.beyond)
      seen.push_back(one);
  std::ranges::sort(seen, {}, &PointOnNominal::s);
  const double least = least_depth_step * spacing;
  Depths out;
  for (std::size_t i = 0; i < seen.size();) {
    double s = 0, depth = 0, count = 0;
    const double from = seen[i].s;
    for (; i < seen.size() && seen[i].s < from + least; ++i, ++count) {
      s += seen[i].s;
      depth += seen[i].depth;
    }
    out.s.push_back(s / count);
    out.depth.push_back(depth / count);
  }
  return out;
}

/// Cubic through the four values about s.
double between(std::span<const double> s, std::span<const double> value, double at) {
  const auto after = std::ranges::upper_bound(s, at) - s.begin();
  const auto first = std::clamp<std::ptrdiff_t>(after - 2, 0, static_cast<std::ptrdiff_t>(s.size()) - 4);
  double sum = 0;
  for (std::ptrdiff_t i = first; i < first + 4; ++i) {
    double share = value[i];
    for (std::ptrdiff_t k = first; k < first + 4; ++k)
      if (k != i)
        share *= (at - s[k]) / (s[i] - s[k]);
    sum += share;
  }
  return sum;
}

/// Arc lengths inside (from, to) where the curvature or the tangent of the profile jumps.
std::vector<double> jumps(const ProfileCurve& nominal, double from, double to) {
  std::vector<double> out;
  for (const double s : nominal.joints()) {
    if (s <= from || s >= to)
      continue;
    const CurvePoint before = nominal.at(s - jump_distance), after = nominal.at(s + jump_distance);
    if (std::abs(after.curvature - before.curvature) > curvature_jump ||
        std::abs(after.delta - before.delta) > tangent_slack)
      out.push_back(s);
  }
  return out;
}

/// The worn curve: through the points of the nominal profile, moved by the depth, in one smooth piece from
/// jump to jump.
ProfileCurve worn_curve(const ProfileCurve& nominal, const NominalPlace& place, const Depths& smooth,
                        const std::string& name) {
  const double first = smooth.s.front(), last = smooth.s.back();
  std::vector<double> ends = jumps(nominal, first + crowded, last - crowded);
  ends.push_back(last);
  std::vector<Point2> points;
  std::vector<std::size_t> corners;
  const auto add = [&](double s) {
    const CurvePoint p = nominal.at(s);
    points.push_back(place.to_measured(p.position + between(smooth.s, smooth.depth, s) * normal_of(p.delta)));
  };
  double from = first;
  add(first);
  for (const double to : ends) {
    const auto inside = std::ranges::count_if(smooth.s, [&](double s) { return s > from && s < to; });
    const auto count = std::max<std::ptrdiff_t>(inside + 1, least_smooth_chords);
    for (std::ptrdiff_t i = 1; i <= count; ++i)
      add(i == count ? to : from + (to - from) * static_cast<double>(i) / static_cast<double>(count));
    if (to < last)
      corners.push_back(points.size() - 1);
    from = to;
  }
  return ProfileCurve::through_points(name, points, corners);
}

void refuse_far(const ProfileCurve& nominal, const NominalFit& fit, std::size_t points,
                const std::string& source) {
  throw InputError(
      fmt::format("{}: the profile is not one of {} that is worn", source, nominal.name()),
      fmt::format("where {0} lies best, moved by {1:.3f} mm along y and {2:.3f} mm along z and turned by "
                  "{3:.3f} degrees, the points lie {4:.3g} .. {5:.3g} mm inside it (root mean square {6:.3g} "
                  "mm), and {7} of {8} beyond its ends; taken are at most {9:g} mm, root mean square {10:g} "
                  "mm, and half of the points",
                  nominal.name(), fit.place.shift.y, fit.place.shift.z, degrees(fit.place.angle), fit.least,
                  fit.largest, fit.rms, fit.beyond, points, farthest_from_nominal, farthest_rms_from_nominal),
      "Name the profile from which it was made, or leave out nominal and give smoothing.");
}

} // namespace

NominalFit fit_nominal(const ProfileCurve& nominal, std::span<const Point2> points, double scatter) {
  return fit_at(place_nominal(nominal, points, scatter), nominal, points, scatter);
}

NominalFit fit_at(const NominalPlace& place, const ProfileCurve& nominal, std::span<const Point2> points,
                  double scatter) {
  NominalFit fit{.place = place};
  const double lies_on = lies_on_nominal + placing_scatters * scatter;
  double squares = 0, added = 0, on_it = 0, outside = 0;
  std::array<double, 2> steep{}, steep_on_it{};
  bool any = false;
  for (const Point2 p : points) {
    const PointOnNominal seen = seen_from(nominal, p, fit.place);
    if (seen.beyond) {
      ++fit.beyond;
      continue;
    }
    fit.least = any ? std::min(fit.least, seen.depth) : seen.depth;
    fit.largest = any ? std::max(fit.largest, seen.depth) : seen.depth;
    squares += seen.depth * seen.depth;
    added += std::pow(std::min(seen.depth, 0.0), 2);
    on_it += std::abs(seen.depth) < lies_on;
    outside += seen.depth < -lies_on;
    if (std::abs(seen.normal.y) > steep_normal) {
      ++steep[seen.normal.y > 0];
      steep_on_it[seen.normal.y > 0] += std::abs(seen.depth) < lies_on;
    }
    any = true;
  }
  const std::size_t on = points.size() - fit.beyond;
  fit.rms = any ? std::sqrt(squares / static_cast<double>(on)) : 0;
  fit.added_rms = any ? std::sqrt(added / static_cast<double>(on)) : 0;
  fit.share = on_it / static_cast<double>(points.size());
  fit.outside = outside / static_cast<double>(points.size());
  if (steep[0] > 0 && steep[1] > 0)
    fit.flanks = std::min(steep_on_it[0] / steep[0], steep_on_it[1] / steep[1]);
  fit.near = 2 * fit.beyond <= points.size() && on >= least_nominal_points &&
             std::max(-fit.least, fit.largest) <= farthest_from_nominal &&
             fit.rms <= farthest_rms_from_nominal;
  return fit;
}

std::string not_worn_from(const ProfileCurve& nominal, const NominalFit& fit) {
  if (fit.outside > most_outside)
    return fmt::format("{:.0f} % of it lie outside, up to {:.2f} mm, and wear takes steel away",
                       100 * fit.outside, -fit.least);
  if (is_wheel(nominal) && std::abs(fit.place.angle) > largest_wheel_turn)
    return fmt::format("it would be turned by {:.2f} degrees, and wheels are measured within {:.2f} degrees",
                       degrees(fit.place.angle), degrees(largest_wheel_turn));
  return "";
}

WornNominal worn_from_nominal(const ProfileCurve& nominal, std::span<const Point2> points, double scatter,
                              double smoothing, const std::string& source) {
  const NominalFit fit = fit_nominal(nominal, points, scatter);
  if (!fit.near)
    refuse_far(nominal, fit, points.size(), source);
  const double spacing = median_spacing(points);
  const Depths measured = depths_on(nominal, points, fit.place, spacing);
  const SmoothDepth smooth = smoothing > 0
                                 ? smoothed_depth(measured.s, measured.depth, smoothing)
                                 : smoothed_depth_by_noise(measured.s, measured.depth, scatter, spacing);
  const auto [least, largest] = std::ranges::minmax(smooth.depth);
  const auto [shortest, longest] = std::ranges::minmax(smooth.wavelength);
  WornNominal out{.curve = worn_curve(nominal, fit.place, {measured.s, smooth.depth},
                                      std::filesystem::path(source).filename().string()),
                  .nominal = nominal.name(),
                  .points = points.size() - fit.beyond,
                  .beyond = fit.beyond,
                  .place = fit.place,
                  .least_depth = least,
                  .largest_depth = largest,
                  .shortest_wave = shortest,
                  .longest_wave = longest,
                  .doubt = not_worn_from(nominal, fit)};
  double depths = 0, removed = 0;
  for (std::size_t i = 0; i < measured.s.size(); ++i) {
    const double moved = measured.depth[i] - smooth.depth[i];
    depths += smooth.depth[i] * smooth.depth[i];
    removed += moved * moved;
    out.removed_most = std::max(out.removed_most, std::abs(moved));
  }
  out.rms_depth = std::sqrt(depths / static_cast<double>(measured.s.size()));
  out.removed_rms = std::sqrt(removed / static_cast<double>(measured.s.size()));
  return out;
}

std::string worn_text(const WornNominal& worn) {
  return fmt::format("{} worn by {:.3f} .. {:.3f} mm (root mean square {:.3f} mm), where it is moved by "
                     "{:.3f} mm along y and "
                     "{:.3f} mm along z and turned by {:.3f} degrees; {} points beyond its ends left out",
                     worn.nominal, worn.least_depth, worn.largest_depth, worn.rms_depth, worn.place.shift.y,
                     worn.place.shift.z, degrees(worn.place.angle), worn.beyond);
}

} // namespace bem_contact
