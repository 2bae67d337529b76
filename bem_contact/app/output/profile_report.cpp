#include "bem_contact/app/output/profile_report.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace bem_contact::app {

namespace {

/// mm. `profile` prints one mean radius for each stretch of this length. A wheel has about 30 of them.
constexpr double radius_stretch = 5.0;
/// mm. A larger radius is printed as straight. Chosen.
constexpr double straight_radius = 20000.0;

std::string radius_text(double turn, double length) {
  const double radius = length / turn;
  return std::abs(radius) < straight_radius ? fmt::format("{:9.1f}", radius)
                                            : fmt::format("{:>9}", "straight");
}

std::string advice_text(const ReadingAdvice& advice) {
  if (advice.smoothing == 0)
    return "no smoothing needed";
  return advice.nominal.empty() ? fmt::format("smoothing = {:.2g} advised", advice.smoothing)
                                : fmt::format("nominal = \"{}\" advised, else smoothing = {:.2g}",
                                              advice.nominal, advice.smoothing);
}

std::string noise_text(const MeasuredProfile& p) {
  if (p.noise.coarse)
    return "  noise: not known; the points are too far apart for a curved profile\n";
  if (p.smoothing > 0 || p.worn)
    return fmt::format("  noise: {:.2f} um as measured\n", 1e3 * p.noise.scatter);
  return fmt::format(
      "  noise: {:.2f} um{}; a curve through all points has pressures off by some {:.0f} MPa (steel); {}\n",
      1e3 * p.noise.scatter,
      p.noise.waves > 0 ? fmt::format(" and waves of 2 to 10 mm, {:.2f} um", 1e3 * p.noise.waves) : "",
      p.noise.pressure, advice_text(p.advice));
}

std::string like_text(const LikeStandard& like) {
  const std::string other = like.other.empty() ? "" : fmt::format(" or {}", like.other);
  return fmt::format("  like {}{}, worn by {:.3f} .. {:.3f} mm\n", like.name, other, like.least_depth,
                     like.largest_depth);
}

std::string turn_text(const ProfileFindings& found) {
  if (found.turn < 0)
    return fmt::format("  inclined: turned by {:.2f} degrees ({}): the file is already inclined; give "
                       "position.rail_inclination = 0 with it\n",
                       degrees(found.turn), inclination_text(found.turn));
  return found.turn > 0 ? fmt::format("  turned by {:.2f} degrees: {}\n", degrees(found.turn),
                                      leans_outwards(found.turn))
                        : "";
}

/// The numbers of EN 15313.
std::string gauged_text(const ProfileFindings& found) {
  std::string out;
  if (const auto& f = found.flange)
    out +=
        fmt::format("  flange: Sh {:.2f} mm, Sd {:.2f} mm, qR {:.2f} mm (height, thickness 10 mm above the "
                    "tread, steepness; EN 15313)\n",
                    f->Sh, f->Sd, f->qR);
  const auto no_minus = [](double mm) { return std::abs(mm) < 0.005 ? 0.0 : mm; }; // no "-0.00"
  if (const auto& w = found.wear)
    out += fmt::format("  wear: W1 {:.2f} mm, W2 {:.2f} mm, W3 {:.2f} mm (down on the axis, across {:g} mm "
                       "below the top, at 45 degrees)\n",
                       no_minus(w->W1), no_minus(w->W2), no_minus(w->W3), head_wear_depth);
  return out;
}

} // namespace

std::string to_text(const MeasuredProfile& p, const ProfileFindings& found, ProfileKind kind) {
  const ProfileCurve& curve = p.curve;
  const double length = curve.s_end() - curve.s_begin();
  std::string out = fmt::format("Profile of a {}: {}\n", name_of(kind), curve.name());
  if (p.points > 0) {
    out += fmt::format("  points: {}, {:.3g} mm apart in the median\n", p.points, p.noise.spacing);
    out += noise_text(p);
    if (!p.outliers.empty())
      out +=
          fmt::format("  outliers: {}, the first at y = {:.2f}, z = {:.2f} by {:.2g} mm\n", p.outliers.size(),
                      p.outliers.front().point.y, p.outliers.front().point.z, p.outliers.front().distance);
  }
  if (found.like)
    out += like_text(*found.like);
  out += turn_text(found);
  if (p.worn)
    out += fmt::format("  nominal: {}\n", worn_text(*p.worn));
  if (p.smoothing > 0)
    out += fmt::format(
        "  smoothed: waves shorter than {} mm removed, {:.2f} um root mean square, {:.2f} um at "
        "most: {} (up to {:.2f} um is taken for noise)\n",
        wavelength_text(p), 1e3 * p.removed_rms, 1e3 * p.removed_most,
        p.takes_shape_away() ? "shape is taken away" : "noise alone", 1e3 * p.largest_noise_removed());
  out +=
      fmt::format("  length: {:.2f} mm, s = {:.2f} .. {:.2f} mm\n", length, curve.s_begin(), curve.s_end());
  out += gauged_text(found);
  out += "  radii: mean over each stretch, > 0 convex, < 0 concave\n";
  out += "      from s       to s          y          z   inclination    radius\n";
  out += "          mm         mm         mm         mm       degrees        mm\n";
  const int stretches = std::max(1, static_cast<int>(std::ceil(length / radius_stretch)));
  for (int i = 0; i < stretches; ++i) {
    const CurvePoint a = curve.at(curve.s_begin() + length * i / stretches),
                     b = curve.at(curve.s_begin() + length * (i + 1) / stretches),
                     m = curve.at((a.s + b.s) / 2);
    out += fmt::format("  {:10.2f} {:10.2f} {:10.2f} {:10.2f} {:13.2f} {}\n", a.s, b.s, m.position.y,
                       m.position.z, degrees(m.delta) - (kind == ProfileKind::wheel ? 180 : 0),
                       radius_text(b.delta - a.delta, b.s - a.s));
  }
  return out;
}

} // namespace bem_contact::app
