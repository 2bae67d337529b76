#include "bem_contact/geometry/rail_height.hpp"

#include "bem_contact/geometry/settings.hpp"

#include <algorithm>

namespace bem_contact {

RailHeight::RailHeight(const WheelOnRail& pair)
    : rail_(pair.rail), origin_(pair.rail_pose.origin), turn_(pair.rail_pose.angle) {
  const auto table = rail_.nodes();
  std::vector<Point2> p;
  p.reserve(table.size());
  for (const TabulatedProfile::Node& node : table)
    p.push_back(origin_ + turn_(node.position));
  const auto top = std::ranges::min_element(p, {}, &Point2::z) - p.begin();
  auto from = top, to = top;
  while (from > 0 && p[from - 1].y < p[from].y)
    --from;
  while (to + 1 < static_cast<std::ptrdiff_t>(p.size()) && p[to + 1].y > p[to].y)
    ++to;
  first_ = static_cast<int>(from);
  for (auto k = from; k <= to; ++k)
    y_.push_back(p[k].y);
}

std::optional<RailHeight::Height> RailHeight::at(double y, int& near) const {
  if (!(y >= y_.front() && y <= y_.back()) || y_.size() < 2)
    return std::nullopt;
  const int last = static_cast<int>(y_.size()) - 2;
  near = std::clamp(near, 0, last);
  while (near > 0 && y < y_[near])
    --near;
  while (near < last && y > y_[near + 1])
    ++near;
  // Newton inside the bracket: y grows over the interval.
  double lo = 0, hi = 1, t = (y - y_[near]) / (y_[near + 1] - y_[near]);
  const auto nodes = rail_.nodes();
  const int k = first_ + near;
  const double length = nodes[k + 1].s - nodes[k].s;
  double z = 0;
  for (int i = 0; i < height_newton_steps; ++i) {
    const TabulatedProfile::Point q = rail_.between(k, t);
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
  return Height{origin_.z + z, nodes[k].s + t * length};
}

} // namespace bem_contact
