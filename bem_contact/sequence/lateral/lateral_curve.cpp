#include "bem_contact/sequence/lateral/lateral_curve.hpp"

#include "bem_contact/sequence/lateral/settings.hpp"

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace bem_contact {

namespace {

using Point = LateralCurve::Point;

/// By how much the parabola through three points exceeds the force of the middle one, N, on the side of
/// `sign`. Nothing where the middle one is no extremum on that side.
std::optional<double> exceeds_middle(const Point& a, const Point& b, const Point& c, double sign) {
  if (sign * (*b.force - *a.force) <= 0 || sign * (*b.force - *c.force) < 0)
    return std::nullopt;
  const double left = (*b.force - *a.force) / (b.lateral - a.lateral),
               right = (*c.force - *b.force) / (c.lateral - b.lateral),
               second = 2 * (right - left) / (c.lateral - a.lateral),
               first = left + 0.5 * second * (b.lateral - a.lateral);
  return 0.5 * first * first / std::abs(second);
}

} // namespace

LateralCurve::LateralCurve(LateralForce rough, double resultant, KnownLateralForces& known)
    : rough_(std::move(rough)), resultant_(resultant), known_(known) {}

std::optional<double> LateralCurve::rough(double lateral) {
  const auto there = known_.rough.find(lateral);
  return there != known_.rough.end() ? there->second : known_.rough[lateral] = rough_(lateral);
}

/// By how much the rough force misses the model's at a displacement where both are known, N, as far as it
/// may do so elsewhere. The rough curve is off in the force and in the displacement. Where it is steep most
/// of a miss is of the second kind, and says nothing of other places: both are weighed by what they usually
/// are.
double LateralCurve::missed_at(double lateral, const KnownLateralForces::Exact& known) const {
  if (!known.rough)
    return 0;
  double steepest = 0;
  const auto look = [&](const std::pair<const double, std::optional<double>>& beside) {
    if (beside.second)
      steepest = std::max(steepest, std::abs((*beside.second - *known.rough) / (beside.first - lateral)));
  };
  if (const auto above = known_.rough.lower_bound(lateral + lateral::unsure); above != known_.rough.end())
    look(*above);
  if (const auto above = known_.rough.upper_bound(lateral - lateral::unsure); above != known_.rough.begin())
    look(*std::prev(above));
  const double in_force = lateral::uneven * resultant_, in_displacement = lateral::unsure * steepest;
  const double share = in_displacement > in_force ? in_force / in_displacement : 1;
  return share * share * (known.force - *known.rough);
}

double LateralCurve::missed(double lateral) const {
  const auto at = [&](const auto& known) { return missed_at(known.first, known.second); };
  if (known_.exact.empty())
    return 0;
  const auto above = known_.exact.lower_bound(lateral);
  if (above == known_.exact.end())
    return at(*std::prev(above));
  if (above == known_.exact.begin())
    return at(*above);
  const auto below = std::prev(above);
  return std::lerp(at(*below), at(*above), (lateral - below->first) / (above->first - below->first));
}

std::optional<double> LateralCurve::operator()(double lateral) {
  if (const std::optional<double> there = exact(lateral))
    return there;
  const std::optional<double> there = rough(lateral);
  return there ? std::optional(*there + missed(lateral)) : std::nullopt;
}

void LateralCurve::learn(const LateralSample& exact) {
  known_.exact[exact.lateral] = {exact.force, rough(exact.lateral)};
}

std::optional<double> LateralCurve::exact(double lateral) const {
  const auto there = known_.exact.find(lateral);
  return there != known_.exact.end() ? std::optional(there->second.force) : std::nullopt;
}

std::optional<LateralSample> LateralCurve::exact_beside(double lateral, int direction) const {
  const auto above = direction < 0 ? known_.exact.upper_bound(lateral) : known_.exact.lower_bound(lateral);
  if (above == (direction < 0 ? known_.exact.begin() : known_.exact.end()))
    return std::nullopt;
  const auto there = direction < 0 ? std::prev(above) : above;
  return LateralSample{there->first, there->second.force};
}

std::optional<LateralSample> LateralCurve::nearest_exact(double wanted) const {
  std::optional<LateralSample> out;
  for (const auto& [lateral, known] : known_.exact)
    if (!out || std::abs(known.force - wanted) < std::abs(out->force - wanted))
      out = {lateral, known.force};
  return out;
}

std::optional<double> LateralCurve::slope_beside(const LateralSample& here, double telling) const {
  std::optional<double> slope;
  double nearest = lateral::spacing;
  for (const auto& [lateral, known] : known_.exact) {
    const double apart = lateral - here.lateral, more = known.force - here.force;
    if (std::abs(more) < telling || std::abs(apart) >= nearest)
      continue;
    nearest = std::abs(apart);
    slope = more / apart;
  }
  return slope;
}

bool LateralCurve::exact_within(double lateral, double distance) const {
  const auto next = known_.exact.lower_bound(lateral - distance);
  return next != known_.exact.end() && next->first <= lateral + distance;
}

void LateralCurve::survey(double around) {
  const int each_side = static_cast<int>(std::lround(lateral::reach / lateral::spacing));
  for (int i = -each_side; i <= each_side; ++i)
    rough(around + i * lateral::spacing);
  const std::map<double, std::optional<double>> samples = known_.rough;
  for (auto b = std::next(samples.begin()); b != samples.end(); ++b) {
    const auto a = std::prev(b);
    double inside = a->second ? a->first : b->first, outside = a->second ? b->first : a->first;
    while (a->second.has_value() != b->second.has_value() && std::abs(outside - inside) > lateral::unsure) {
      const double middle = 0.5 * (inside + outside);
      (rough(middle) ? inside : outside) = middle;
    }
  }
}

std::vector<Point> LateralCurve::points() const {
  std::vector<Point> out;
  for (const auto& [lateral, force] : known_.rough)
    if (!known_.exact.contains(lateral))
      out.push_back({lateral, force ? std::optional(*force + missed(lateral)) : std::nullopt, false});
  for (const auto& [lateral, known] : known_.exact)
    out.push_back({lateral, known.force, true});
  std::ranges::sort(out, {}, &Point::lateral);
  return out;
}

void LateralCurve::survey_extrema(double wanted) {
  const std::vector<Point> all = points();
  for (std::size_t i = 1; i + 1 < all.size(); ++i) {
    const Point &a = all[i - 1], &b = all[i], &c = all[i + 1];
    if (!a.force || !b.force || !c.force)
      continue;
    const double sign = *b.force < wanted ? 1 : -1, misses = std::abs(wanted - *b.force);
    const std::optional<double> more = exceeds_middle(a, b, c, sign);
    // A parabola may be off by as much again.
    if (!more || misses > 2 * *more)
      continue;
    const double worst = sign * std::min(sign * *a.force, sign * *c.force);
    boost::math::tools::brent_find_minima([&](double at) { return -sign * (*this)(at).value_or(worst); },
                                          a.lateral, c.lateral, extremum_bits);
  }
}

} // namespace bem_contact
