#include "meshes/size_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bem_contact::meshes {

namespace {

/// 1. Sizes of the size field are rounded down to powers of this, so that few square roots are needed.
constexpr double level_ratio = 1.05;
/// 1. Sizes that differ by less, relatively, are the same level: rounding of a power.
constexpr double same_level = 1e-9;

} // namespace

void SizeField::add(double size, std::vector<Point2> sources) {
  // Levels keep the number of square roots small: one a level and place.
  const double level = std::pow(level_ratio, std::floor(std::log(size) / std::log(level_ratio)));
  const auto at = std::lower_bound(levels_.begin(), levels_.end(), level * (1 - same_level),
                                   [](const Level& l, double s) { return l.size < s; });
  if (at != levels_.end() && at->size < level * (1 + same_level))
    at->sources.insert(at->sources.end(), sources.begin(), sources.end());
  else
    levels_.insert(at, {level, std::move(sources)});
}

double SizeField::operator()(Point2 p) const {
  double size = largest_;
  for (const auto& level : levels_) {
    if (level.size >= size)
      break;
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& source : level.sources)
      nearest = std::min(nearest, dot(p - source, p - source));
    size = std::min(size, level.size + grading_ * std::sqrt(nearest));
  }
  return size;
}

} // namespace bem_contact::meshes
