#include "bem_contact/profile/measured/closed_outline.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/measured/walk.hpp"
#include "bem_contact/profile/median.hpp"
#include "bem_contact/profile/messages.hpp"
#include "bem_contact/profile/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace bem_contact {

namespace {

/// 1 (median distances of neighbours). An outline whose ends are this near is closed. Chosen.
constexpr double closing_spacings = 3.0;
/// 1 (share of its length). As above, of few points.
constexpr double widest_closing = 0.1;
/// 1 (share of the square of the length). A closed outline encloses more: a rail 0.017, a scan there and back
/// 0.001.
constexpr double least_enclosed = 0.005;
/// 1 (share of the height). Within so much of its end in z a rail's base has its whole width.
constexpr double base_band = 0.02;
/// 1 (share of that width). As above.
constexpr double least_base = 0.9;

/// Ends where it began, and goes round something: a scan there and back does not.
bool is_closed(const std::vector<Point2>& p) {
  const double length = path_length(p);
  const double most = std::min(closing_spacings * median_spacing(p), widest_closing * length);
  if (norm(p.back() - p.front()) > most)
    return false;
  double twice_area = 0;
  for (std::size_t i = 1; i < p.size(); ++i)
    twice_area += cross(p[i - 1] - p[0], p[i] - p[0]);
  return std::abs(twice_area) / 2 > least_enclosed * length * length;
}

double width_of(const std::vector<Point2>& p) {
  const auto [low, high] = std::ranges::minmax(p, {}, &Point2::y);
  return p.empty() ? 0 : high.y - low.y;
}

/// Height of the base: the end in z that is as wide as the whole rail, if one alone is.
std::optional<double> base_of(const std::vector<Point2>& p) {
  const auto [low, high] = std::ranges::minmax(p, {}, &Point2::z);
  const double band = base_band * (high.z - low.z);
  std::optional<double> base;
  for (const double end : {low.z, high.z}) {
    std::vector<Point2> near;
    std::ranges::copy_if(p, std::back_inserter(near), [&](Point2 q) { return std::abs(q.z - end) < band; });
    if (near.empty() || width_of(near) < least_base * width_of(p))
      continue;
    if (base)
      return std::nullopt;
    base = end;
  }
  return base;
}

} // namespace

void open_outline(std::vector<Point2>& points, const std::string& source, ProfileKind kind) {
  if (!is_closed(points))
    return;
  const std::optional<double> base = kind == ProfileKind::rail ? base_of(points) : std::nullopt;
  if (!base)
    throw InputError(
        fmt::format("{}: the outline is closed", source),
        "a profile is the line on which wheel and rail can touch, and has two ends",
        kind == ProfileKind::rail
            ? "Give the part from foot to foot, or from flank to flank, over the head."
            : "Give the part from the back of the flange over its tip and the tread to the field side.");
  const auto [low, high] = std::ranges::minmax(points, {}, &Point2::z);
  const double half = (high.z - low.z) / 2;
  const auto below = [&](Point2 p) { return std::abs(p.z - *base) < half; };
  if (norm(points.back() - points.front()) < crowded)
    points.pop_back(); // where the walk closes there is one point
  // Walked from the base on, so that what is left is in one piece.
  std::rotate(points.begin(), std::ranges::find_if(points, below), points.end());
  std::rotate(points.begin(), std::ranges::find_if_not(points, below), points.end());
  std::erase_if(points, below);
  say_warning("{}: the outline is closed: its lower half, with the base at z = {:.4g} mm, is left out",
              source, *base);
}

} // namespace bem_contact
