#include "bem_contact/profile/measured/outliers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace bem_contact {

namespace {

/// 1 (scatters). A single point that lies off the line of its neighbours by more is an outlier: noise hardly
/// ever has so much. Chosen.
constexpr double outlier_scatters = 12.0;
/// mm. As above, of exact points. Chosen.
constexpr double least_outlier = 0.05;
/// 1 (share of the outlier's distance). Its neighbours lie nearer to their own line without it. At a corner
/// they are off by 0.1 times as much as its point and more.
constexpr double neighbour_share = 0.05;
/// 1 (scatters). Noise alone may move a neighbour so far from its line. Chosen.
constexpr double neighbour_scatters = 5.0;

/// Distance of p from the cubic through four points that lie along its line; infinite where they double back.
double off_cubic(Point2 p, const std::array<Point2, 4>& through) {
  const Point2 chord = through.back() - through.front();
  const double length = norm(chord);
  if (length == 0)
    return std::numeric_limits<double>::infinity();
  const Point2 along = (1 / length) * chord, across{-along.z, along.y};
  std::array<double, 4> u{}, height{};
  for (std::size_t i = 0; i < 4; ++i) {
    u[i] = dot(through[i] - p, along);
    height[i] = dot(through[i] - p, across);
    if (i > 0 && u[i] <= u[i - 1])
      return std::numeric_limits<double>::infinity();
  }
  double at_point = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    double share = height[i];
    for (std::size_t k = 0; k < 4; ++k)
      if (k != i)
        share *= u[k] / (u[k] - u[i]);
    at_point += share;
  }
  return std::abs(at_point);
}

} // namespace

std::vector<Outlier> outliers(std::span<const Point2> p, double scatter) {
  std::vector<Outlier> out;
  const double least = std::max(outlier_scatters * scatter, least_outlier);
  for (std::size_t i = 3; i + 3 < p.size(); ++i) {
    const double distance = off_cubic(p[i], {p[i - 2], p[i - 1], p[i + 1], p[i + 2]});
    if (!(distance > least && std::isfinite(distance)))
      continue;
    const double before = off_cubic(p[i - 1], {p[i - 3], p[i - 2], p[i + 1], p[i + 2]}),
                 after = off_cubic(p[i + 1], {p[i - 2], p[i - 1], p[i + 2], p[i + 3]});
    if (std::max(before, after) < std::max(neighbour_share * distance, neighbour_scatters * scatter))
      out.push_back({p[i], distance});
  }
  return out;
}

} // namespace bem_contact
