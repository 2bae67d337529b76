#include "bem_contact/uses/conicity/equivalent_conicity.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace bem_contact {

namespace {

/// mm. A motion whose width differs by more from the one asked for stands at a jump of the width: there is
/// none of this amplitude.
constexpr double width_tolerance = 1e-6;

/// The potential S at one displacement, seen from its lowest point outwards: `away` is the distance from
/// there, `force` is dS/d(away).
struct Node {
  double away = 0, force = 0, potential = 0;
};
using Flank = std::vector<Node>;

std::vector<double> potential_of(const std::vector<RadiusDifference>& f) {
  std::vector<double> s{0};
  for (std::size_t k = 1; k < f.size(); ++k)
    s.push_back(s.back() + 0.5 * (f[k].lateral - f[k - 1].lateral) * (f[k].difference + f[k - 1].difference));
  return s;
}

/// How far from the lowest point S first reaches `level`; nothing where it stays below.
std::optional<double> reach(const Flank& flank, double level) {
  for (std::size_t k = 1; k < flank.size(); ++k) {
    const Node &a = flank[k - 1], &b = flank[k];
    if (b.potential < level)
      continue;
    const double h = b.away - a.away, rest = level - a.potential;
    if (h == 0 || rest <= 0)
      return a.away;
    const double slope = (b.force - a.force) / h;
    return a.away +
           std::min(h, 2 * rest / (a.force + std::sqrt(std::max(0.0, a.force * a.force + 2 * slope * rest))));
  }
  return std::nullopt;
}

/// Integral of dt / sqrt(q) over a stretch of length h, q = q0 + .. - slope t^2 / 2, from its roots at both
/// ends: with u = h / (sqrt(q0) + sqrt(q1)) it is 2 u where q is linear, an arctangent where q is a circle's
/// and an area tangent where it is a hyperbola's.
double passage(double h, double root0, double root1, double slope) {
  const double u = h / (root0 + root1), w = u * std::sqrt(0.5 * std::abs(slope));
  if (w < 1e-8)
    return 2 * u;
  return 2 * u * (slope > 0 ? std::atan(w) : std::atanh(std::min(w, 1.0))) / w;
}

/// Integral of d(away) / sqrt(level - S) from the lowest point to the turning point.
double time_on(const Flank& flank, double level, double end) {
  double sum = 0;
  for (std::size_t k = 1; k < flank.size(); ++k) {
    const Node &a = flank[k - 1], &b = flank[k];
    const double full = b.away - a.away, h = std::min(b.away, end) - a.away;
    if (full > 0 && h > 0) {
      const double last = b.away < end ? std::sqrt(std::max(0.0, level - b.potential)) : 0;
      sum += passage(h, std::sqrt(std::max(0.0, level - a.potential)), last, (b.force - a.force) / full);
    }
    if (b.away >= end)
      break;
  }
  return sum;
}

} // namespace

std::vector<RadiusDifference> with_zeros(std::span<const RadiusDifference> function) {
  std::vector<RadiusDifference> out;
  for (const RadiusDifference& b : function) {
    const RadiusDifference a = out.empty() ? b : out.back();
    if (a.difference * b.difference < 0)
      out.push_back({a.lateral + (b.lateral - a.lateral) * a.difference / (a.difference - b.difference), 0});
    out.push_back(b);
  }
  return out;
}

std::optional<EquivalentConicity> equivalent_conicity(std::span<const RadiusDifference> function,
                                                      double amplitude, const KlingelLengths& lengths) {
  if (function.size() < 3 || !std::ranges::is_sorted(function, {}, &RadiusDifference::lateral) ||
      !(amplitude > 0))
    throw InputError("The conicity of this rolling radius difference cannot be found",
                     "it needs three values in rising order of displacement, and an amplitude above 0",
                     "Give such a function, in mm.");
  const std::vector<RadiusDifference> f = with_zeros(function);
  const std::vector<double> s = potential_of(f);
  const std::size_t lowest = std::ranges::min_element(s) - s.begin();
  Flank right, left;
  for (std::size_t k = lowest; k < f.size(); ++k)
    right.push_back({f[k].lateral - f[lowest].lateral, f[k].difference, s[k] - s[lowest]});
  for (std::size_t k = lowest + 1; k-- > 0;)
    left.push_back({f[lowest].lateral - f[k].lateral, -f[k].difference, s[k] - s[lowest]});

  const auto width = [&](double level) {
    const auto to_right = reach(right, level), to_left = reach(left, level);
    return to_right && to_left ? *to_right + *to_left : std::numeric_limits<double>::infinity();
  };
  const auto highest = [](const Flank& flank) {
    return std::ranges::max(flank, {}, &Node::potential).potential;
  };
  double low = 0, high = std::min(highest(right), highest(left));
  if (!(width(high) >= 2 * amplitude) || !(high > 0))
    return std::nullopt;
  for (double middle = 0.5 * high; low < middle && middle < high;
       middle = 0.5 * (low + high)) // to the last bit
    (width(middle) < 2 * amplitude ? low : high) = middle;
  const double from = *reach(left, high), to = *reach(right, high);
  EquivalentConicity out{.amplitude = amplitude,
                         .wavelength = std::numeric_limits<double>::infinity(),
                         .from = f[lowest].lateral - from,
                         .to = f[lowest].lateral + to};
  if (from + to > 2 * amplitude + width_tolerance)
    return std::nullopt;
  const double er = lengths.contact_distance * lengths.wheel_radius;
  out.wavelength = 2 * std::sqrt(0.5 * er) * (time_on(right, high, to) + time_on(left, high, from));
  const double wave_number = 2 * std::numbers::pi / out.wavelength;
  out.tan_gamma = 0.5 * wave_number * wave_number * er;
  return out;
}

} // namespace bem_contact
