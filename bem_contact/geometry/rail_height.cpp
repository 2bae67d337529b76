#include "bem_contact/geometry/rail_height.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/geometry/settings.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>

namespace bem_contact {

namespace {

/// 1. Newton steps for the height of the rail at y. They converge quadratically; the number is a bound.
constexpr int height_newton_steps = 30;

} // namespace

RailHeight::RailHeight(const WheelOnRail& pair)
    : rail_(pair.rail), origin_(pair.rail_pose.origin), turn_(pair.rail_pose.angle) {
  nodes_.reserve(rail_.nodes().size());
  for (const TabulatedProfile::Node& node : rail_.nodes())
    nodes_.push_back(origin_ + turn_(node.position));
  const std::vector<Stretch> rising = rising_stretches();
  if (rising.empty())
    throw InputError(fmt::format("Nothing of the rail '{}' is seen from above", rail_.name()),
                     "walked as it is, y nowhere grows along its profile", "Check the sides of the profile.");
  if (rising.size() == 1)
    seen_ = rising;
  else
    keep_upper(rising);
}

std::vector<RailHeight::Stretch> RailHeight::rising_stretches() const {
  std::vector<Stretch> out;
  const int count = static_cast<int>(nodes_.size());
  for (int first = 0, last = 0; first < count; first = last + 1) {
    last = first;
    while (last + 1 < count && nodes_[last + 1].y > nodes_[last].y)
      ++last;
    if (last > first)
      out.push_back({first, last, nodes_[first].y, nodes_[last].y});
  }
  return out;
}

/// Stretches do not cross: which of two is the upper one changes only where one of them ends.
void RailHeight::keep_upper(const std::vector<Stretch>& rising) {
  std::vector<double> ends;
  for (const Stretch& stretch : rising)
    ends.insert(ends.end(), {stretch.from, stretch.to});
  std::ranges::sort(ends);
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const double from = ends[i - 1], to = ends[i], middle = std::midpoint(from, to);
    const Stretch* upper = nullptr;
    for (const Stretch& stretch : rising)
      if (from < to && stretch.from <= from && to <= stretch.to &&
          (!upper || rough_height(stretch, middle) < rough_height(*upper, middle)))
        upper = &stretch;
    if (!upper)
      continue;
    if (!seen_.empty() && seen_.back().first == upper->first && seen_.back().to == from)
      seen_.back().to = to;
    else
      seen_.push_back({upper->first, upper->last, from, to});
  }
}

/// Between its nodes linear.
double RailHeight::rough_height(const Stretch& stretch, double y) const {
  const auto begin = nodes_.begin() + stretch.first;
  const auto above = std::upper_bound(begin + 1, nodes_.begin() + stretch.last, y,
                                      [](double value, Point2 node) { return value < node.y; });
  const Point2 a = *(above - 1), b = *above;
  return a.z + (b.z - a.z) * (y - a.y) / (b.y - a.y);
}

std::optional<RailHeight::Height> RailHeight::at(double y, int& near) const {
  auto after = std::ranges::upper_bound(seen_, y, {}, &Stretch::from);
  if (after == seen_.begin())
    return std::nullopt;
  const Stretch& stretch = *--after;
  // At a wall both of its ends have this y.
  const bool wall = y == stretch.from && after != seen_.begin() && (after - 1)->to == y;
  if (wall && rough_height(*(after - 1), y) < rough_height(stretch, y))
    return on(*(after - 1), y, near);
  if (!(y <= stretch.to))
    return std::nullopt;
  return on(stretch, y, near);
}

RailHeight::Height RailHeight::on(const Stretch& stretch, double y, int& near) const {
  near = std::clamp(near, stretch.first, stretch.last - 1);
  while (near > stretch.first && y < nodes_[near].y)
    --near;
  while (near < stretch.last - 1 && y > nodes_[near + 1].y)
    ++near;
  // Newton inside the bracket: y grows over the interval.
  double lo = 0, hi = 1, t = (y - nodes_[near].y) / (nodes_[near + 1].y - nodes_[near].y);
  const auto nodes = rail_.nodes();
  const double length = nodes[near + 1].s - nodes[near].s;
  double z = 0;
  for (int i = 0; i < height_newton_steps; ++i) {
    const TabulatedProfile::Point q = rail_.between(near, t);
    const double excess = origin_.y + turn_(q.position).y - y;
    const double slope = length * turn_(q.tangent).y;
    (excess > 0 ? hi : lo) = t;
    double next = slope > 0 ? t - excess / slope : -1;
    if (!(next >= lo && next <= hi))
      next = 0.5 * (lo + hi);
    const double step = next - t;
    t = next;
    z = turn_(q.position).z + step * length * turn_(q.tangent).z; // exact for the last step, which is tiny
    if (std::abs(step) < height_tolerance || std::abs(excess) < height_tolerance * (1 + std::abs(y)))
      break;
  }
  return {origin_.z + z, nodes[near].s + t * length};
}

} // namespace bem_contact
