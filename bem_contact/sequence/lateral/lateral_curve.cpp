#include "bem_contact/sequence/lateral/lateral_curve.hpp"

#include "bem_contact/sequence/lateral/settings.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace bem_contact {

namespace {

using Point = LateralCurve::Point;

/// Second derivative of the parabola through three points that have a force, N/mm2.
double curvature(const Point& a, const Point& b, const Point& c) {
  const double left = (*b.force - *a.force) / (b.lateral - a.lateral);
  const double right = (*c.force - *b.force) / (c.lateral - b.lateral);
  return 2 * (right - left) / (c.lateral - a.lateral);
}

/// How far the curve may depart from the line between points[i] and points[i + 1], N, by the points beside.
double bend(const std::vector<Point>& points, std::size_t i) {
  const auto of = [&](std::size_t first) {
    const bool known = first + 2 < points.size() && points[first].force && points[first + 2].force;
    return known ? std::abs(curvature(points[first], points[first + 1], points[first + 2])) : 0.0;
  };
  const double width = points[i + 1].lateral - points[i].lateral;
  return std::max(i > 0 ? of(i - 1) : 0.0, of(i)) * width * width / 8;
}

} // namespace

LateralCurve::LateralCurve(LateralForce rough, double around, double resultant, KnownLateralForces& known)
    : rough_(std::move(rough)), resultant_(resultant), known_(known) {
  const int each_side = static_cast<int>(std::lround(lateral_reach / first_lateral_samples));
  for (int i = -each_side; i <= each_side; ++i)
    this->rough(around + i * first_lateral_samples);
}

/// Of a sample, which is kept.
std::optional<double> LateralCurve::rough(double lateral) {
  const auto there = known_.rough.find(lateral);
  return there != known_.rough.end() ? there->second : known_.rough[lateral] = rough_(lateral);
}

double LateralCurve::missed(double lateral) const {
  const auto at = [](const auto& known) {
    return known.second.rough ? known.second.force - *known.second.rough : 0.0;
  };
  const auto above = known_.exact.lower_bound(lateral);
  if (known_.exact.empty())
    return 0;
  if (above == known_.exact.end())
    return at(*std::prev(above));
  if (above == known_.exact.begin())
    return at(*above);
  const auto below = std::prev(above);
  return std::lerp(at(*below), at(*above), (lateral - below->first) / (above->first - below->first));
}

std::optional<double> LateralCurve::operator()(double lateral) {
  if (const auto exact = known_.exact.find(lateral); exact != known_.exact.end())
    return exact->second.force;
  const std::optional<double> there = rough_(lateral);
  return there ? std::optional(*there + missed(lateral)) : std::nullopt;
}

void LateralCurve::learn(const LateralSample& exact) {
  const auto sample = known_.rough.find(exact.lateral);
  known_.exact[exact.lateral] = {exact.force,
                                 sample != known_.rough.end() ? sample->second : rough_(exact.lateral)};
}

std::vector<Point> LateralCurve::samples() const {
  std::vector<Point> out;
  for (const auto& [lateral, force] : known_.rough)
    out.push_back({lateral, force ? std::optional(*force + missed(lateral)) : std::nullopt, false});
  return out;
}

/// A sample more in the middle of each interval where the curve ends, or bends so much that it may pass
/// `wanted` unseen. False if there is none.
bool LateralCurve::refine(double wanted) {
  const std::vector<Point> points = samples();
  std::vector<double> more;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Point &a = points[i], &b = points[i + 1];
    if (b.lateral - a.lateral < 1.5 * lateral_step || (!a.force && !b.force))
      continue;
    bool unseen = !a.force || !b.force;
    if (!unseen) {
      const double between = bend(points, i);
      unseen = between > even_lateral_force * resultant_ &&
               std::min(*a.force, *b.force) - between <= wanted &&
               wanted <= std::max(*a.force, *b.force) + between;
    }
    if (unseen)
      more.push_back(0.5 * (a.lateral + b.lateral));
  }
  for (const double lateral : more)
    rough(lateral);
  return !more.empty();
}

/// A sample at each extremum that falls short of `wanted` and whose parabola does hardly.
void LateralCurve::add_extrema(double wanted) {
  const std::vector<Point> points = samples();
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const Point &a = points[i - 1], &b = points[i], &c = points[i + 1];
    if (!a.force || !b.force || !c.force)
      continue;
    const double sign = *b.force < wanted ? 1 : -1;
    if (sign * (*b.force - *a.force) <= 0 || sign * (*b.force - *c.force) < 0)
      continue;
    const double second = curvature(a, b, c);
    const double first = (*c.force - *a.force) / (c.lateral - a.lateral) +
                         0.5 * second * (2 * b.lateral - a.lateral - c.lateral);
    const double beyond = 0.5 * first * first / std::abs(second); // of the parabola's extremum over b
    const double at = b.lateral - first / second;
    if (sign * (wanted - *b.force) < 2 * beyond && at > a.lateral && at < c.lateral)
      rough(at);
  }
}

std::vector<Point> LateralCurve::points(double wanted) {
  while (refine(wanted))
    continue;
  add_extrema(wanted);
  std::vector<Point> out = samples();
  std::erase_if(out, [&](const Point& p) { return known_.exact.contains(p.lateral); });
  for (const auto& [lateral, known] : known_.exact)
    out.push_back({lateral, known.force, true});
  std::ranges::sort(out, {}, &Point::lateral);
  return out;
}

LateralSample LateralCurve::leaves(const LateralSample& from, double error, int direction) const {
  const auto exact = known_.exact.find(from.lateral);
  const double missing = exact != known_.exact.end() && exact->second.rough
                             ? from.force - *exact->second.rough
                             : missed(from.lateral);
  std::vector<Point> beside = samples();
  std::erase_if(beside, [&](const Point& p) { return direction * (p.lateral - from.lateral) <= 0; });
  if (direction < 0)
    std::ranges::reverse(beside);
  LateralSample last = from;
  for (const Point& p : beside) {
    const std::optional<double> force = known_.rough.at(p.lateral);
    if (!force)
      break;
    const LateralSample next{p.lateral, *force + missing};
    if (std::abs(next.force - from.force) > error) {
      const double bound = from.force + std::copysign(error, next.force - from.force);
      const double share = (bound - last.force) / (next.force - last.force);
      return {std::lerp(last.lateral, next.lateral, share), bound};
    }
    last = next;
  }
  return last;
}

} // namespace bem_contact
