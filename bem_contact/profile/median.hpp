#pragma once

#include "bem_contact/base/conventions.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace bem_contact {

/// The upper median of at least one value.
inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// Median distance of neighbouring points, at least two.
inline double median_spacing(std::span<const Point2> points) {
  std::vector<double> lengths;
  for (std::size_t i = 1; i < points.size(); ++i)
    lengths.push_back(norm(points[i] - points[i - 1]));
  return median(std::move(lengths));
}

} // namespace bem_contact
