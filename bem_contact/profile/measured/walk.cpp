#include "bem_contact/profile/measured/walk.hpp"

#include "bem_contact/profile/measured/settings.hpp"
#include "bem_contact/profile/turn_at.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact {

namespace {

/// rad. No profile turns so sharply between two chords: there the points zig-zag. Chosen: beyond a right
/// angle, which the edge of a wheel's rim may have.
constexpr double zig_zag = 100 * std::numbers::pi / 180;

} // namespace

double path_length(std::span<const Point2> p) {
  double sum = 0;
  for (std::size_t i = 1; i < p.size(); ++i)
    sum += norm(p[i] - p[i - 1]);
  return sum;
}

std::optional<std::size_t> first_zig_zag(std::span<const Point2> p) {
  for (std::size_t i = 1; i + 1 < p.size(); ++i)
    if (turn_at(p, i) > zig_zag)
      return i;
  return std::nullopt;
}

bool runs_back(std::span<const Point2> p) {
  double travelled = 0, low = p.front().y, high = low;
  for (std::size_t i = 1; i < p.size(); ++i) {
    travelled += std::abs(p[i].y - p[i - 1].y);
    low = std::min(low, p[i].y);
    high = std::max(high, p[i].y);
  }
  return travelled > doubled_walk * (high - low);
}

} // namespace bem_contact
