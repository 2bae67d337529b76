#include "bem_contact/profile/measured/dense_scan.hpp"

#include "bem_contact/profile/measured/walk.hpp"
#include "bem_contact/profile/median.hpp"
#include "bem_contact/profile/messages.hpp"
#include "bem_contact/profile/settings.hpp"

#include <cmath>

namespace bem_contact {

namespace {

/// mm. Means of neighbours lie no farther apart: over 1 mm a mean lies 3 um inside an arc of 13 mm radius.
constexpr double farthest_means = 1.0;
/// 1. Fewer means are no scan. Chosen.
constexpr std::size_t least_means = 20;
/// mm. Points that scatter by more are no scan of one surface. Chosen: laser scanners scatter by 0.1 mm.
constexpr double largest_scan_scatter = 0.3;

/// Of `count` points each; what is left over at the end joins the last.
std::vector<Point2> means(const std::vector<Point2>& points, std::size_t count) {
  std::vector<Point2> out;
  for (std::size_t from = 0; from + count <= points.size(); from += count) {
    const std::size_t to = from + 2 * count > points.size() ? points.size() : from + count;
    Point2 sum{};
    for (std::size_t i = from; i < to; ++i)
      sum = sum + points[i];
    out.push_back((1 / static_cast<double>(to - from)) * sum);
  }
  return out;
}

/// Standard deviation of the points from the line of their means, mm.
double scatter_about(const std::vector<Point2>& line, const std::vector<Point2>& points, std::size_t count) {
  std::vector<double> off;
  for (std::size_t k = 1; k + 1 < line.size(); ++k) {
    const Point2 chord = line[k + 1] - line[k - 1];
    for (std::size_t i = k * count; i < (k + 1) * count; ++i)
      off.push_back(std::abs(cross(chord, points[i] - line[k])) / norm(chord));
  }
  return normal_deviation_over_median * median(std::move(off));
}

} // namespace

bool thin_scan(std::vector<Point2>& points, const std::string& source) {
  const auto fits = [](const std::vector<Point2>& line) {
    return line.size() >= least_means && median_spacing(line) <= farthest_means;
  };
  std::size_t count = 2;
  std::vector<Point2> line = means(points, count);
  for (; fits(line) && (first_zig_zag(line) || runs_back(line)); line = means(points, ++count)) {
  }
  if (!fits(line))
    return false;
  // So many just do not turn back any more. Twice as many follow the profile.
  if (std::vector<Point2> smoother = means(points, 2 * count); fits(smoother)) {
    line = std::move(smoother);
    count *= 2;
  }
  const double scatter = scatter_about(line, points, count);
  if (scatter > largest_scan_scatter)
    return false;
  say_warning(
      "{}: its points scatter by {:.2g} um and lie {:.2g} mm apart, so that they run back and forth: each "
      "{} became their mean, {:.2g} mm apart",
      source, 1e3 * scatter, path_length(line) / static_cast<double>(points.size()), count,
      median_spacing(line));
  points = std::move(line);
  return true;
}

} // namespace bem_contact
