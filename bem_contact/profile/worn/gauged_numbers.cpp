#include "bem_contact/profile/worn/gauged_numbers.hpp"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <functional>
#include <limits>

namespace bem_contact {

namespace {

/// mm. Heights above the tread and below the tip at which a flange is measured.
constexpr double above_tread = 10.0, below_tip = 2.0;
/// mm. A lower flange has no place above the tread and below the tip.
constexpr double lowest_flange = above_tread + below_tip;
/// mm. Longest step along a curve on which what is looked for lies between two points. Chosen.
constexpr double gauging_step = 0.1;

/// Arc lengths at which f, of the point there, vanishes.
std::vector<double> where(const ProfileCurve& curve, const std::function<double(const CurvePoint&)>& f) {
  std::vector<double> out;
  const std::vector<CurvePoint> points = points_along(curve, gauging_step);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double a = f(points[i - 1]), b = f(points[i]);
    if (a == 0)
      out.push_back(points[i - 1].s);
    if (a * b >= 0)
      continue;
    const auto [from, to] =
        boost::math::tools::bisect([&](double s) { return f(curve.at(s)); }, points[i - 1].s, points[i].s,
                                   boost::math::tools::eps_tolerance<double>());
    out.push_back((from + to) / 2);
  }
  return out;
}

/// A straight line, and where curves cross it: how far along it, mm.
struct Line {
  Point2 from, along; ///< unit vector

  /// The crossing nearest to a place along the line.
  std::optional<double> crossing(const ProfileCurve& curve, const NominalPlace& place, double near) const {
    std::optional<double> best;
    const auto at = [&](const CurvePoint& p) { return place.to_nominal(p.position) - from; };
    for (const double s : where(curve, [&](const CurvePoint& p) { return cross(along, at(p)); })) {
      const double along_it = dot(at(curve.at(s)), along);
      if (!best || std::abs(along_it - near) < std::abs(*best - near))
        best = along_it;
    }
    return best;
  }
};

/// How far the measured curve lies inside the nominal one along a line that leads into the steel.
std::optional<double> worn_along(const Line& line, const ProfileCurve& rail, const ProfileCurve& nominal,
                                 const NominalPlace& place) {
  const std::optional<double> before = line.crossing(nominal, {}, 0);
  const std::optional<double> now = before ? line.crossing(rail, place, *before) : std::nullopt;
  return now ? std::optional(*now - *before) : std::nullopt;
}

/// The highest point of a walk, or with sign -1 the lowest.
CurvePoint extreme(const ProfileCurve& curve, double sign) {
  const std::vector<CurvePoint> points = points_along(curve, gauging_step);
  const auto height = [&](const CurvePoint& p) { return sign * p.position.z; };
  CurvePoint best = *std::ranges::min_element(points, {}, height);
  for (const double s : where(curve, [](const CurvePoint& p) { return std::sin(p.delta); }))
    if (const CurvePoint level = curve.at(s); height(level) < height(best))
      best = level;
  return best;
}

} // namespace

std::optional<FlangeNumbers> flange_numbers(const ProfileCurve& wheel, double tape_circle) {
  if (wheel.s_begin() > 0 || wheel.s_end() < 0 || std::abs(wheel.at(0).position.y) > gauging_step)
    return std::nullopt;
  const CurvePoint tip = extreme(wheel, -1);
  const double tread = wheel.at(0).position.z, height = tip.position.z - tread;
  const bool ends_there = tip.s > wheel.s_end() - gauging_step; // a face that was cut off has no tip
  if (height < lowest_flange || tip.position.y > 0 || ends_there)
    return std::nullopt;
  // The last place on the way to the tip: a worn face may hang over.
  const auto face_at = [&](double z) {
    double y = std::numeric_limits<double>::infinity();
    for (const double s : where(wheel, [&](const CurvePoint& p) { return p.position.z - z; }))
      if (s > 0 && s < tip.s)
        y = std::min(y, wheel.at(s).position.y);
    return y;
  };
  const double face = face_at(tread + above_tread), shoulder = face_at(tip.position.z - below_tip);
  if (!std::isfinite(face) || !std::isfinite(shoulder))
    return std::nullopt;
  return FlangeNumbers{height, face + tape_circle, face - shoulder};
}

std::optional<HeadWear> head_wear(const ProfileCurve& rail, const ProfileCurve& nominal,
                                  const NominalPlace& place) {
  const double top = extreme(nominal, 1).position.z;
  const Line down{{0, top}, {0, 1}};
  // Gauge faces lie some 36 mm beside the axis; of several crossings the nearest to there is meant.
  const std::optional<double> gauge_face =
      Line{{nominal.at(nominal.s_begin()).position.y, top + head_wear_depth}, {1, 0}}.crossing(nominal, {},
                                                                                               0);
  if (!gauge_face)
    return std::nullopt;
  const double gauge_y = nominal.at(nominal.s_begin()).position.y + *gauge_face;
  const Line across{{gauge_y, top + head_wear_depth}, {1, 0}};
  const Line aslant{{gauge_y, top}, {std::sqrt(0.5), std::sqrt(0.5)}};
  const auto W1 = worn_along(down, rail, nominal, place), W2 = worn_along(across, rail, nominal, place),
             W3 = worn_along(aslant, rail, nominal, place);
  return W1 && W2 && W3 ? std::optional(HeadWear{*W1, *W2, *W3}) : std::nullopt;
}

} // namespace bem_contact
