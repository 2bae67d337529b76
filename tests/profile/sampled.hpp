#pragma once

#include "bem_contact/profile/standard_profiles.hpp"

#include <fmt/format.h>

#include <random>
#include <string>
#include <vector>

namespace bem_contact {

/// Points of a curve at equal steps of arc length of about `step` mm.
inline std::vector<Point2> sampled_curve(const ProfileCurve& curve, double step) {
  std::vector<Point2> points;
  const double length = curve.s_end() - curve.s_begin();
  const int count = static_cast<int>(length / step);
  for (int i = 0; i <= count; ++i)
    points.push_back(curve.at(curve.s_begin() + i * length / count).position);
  return points;
}

/// Normally distributed scatter of both coordinates, mm.
inline std::vector<Point2> noisy(std::vector<Point2> points, double scatter, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal(0, scatter);
  for (Point2& p : points)
    p = p + Point2{normal(generator), normal(generator)};
  return points;
}

inline std::string as_columns(const std::vector<Point2>& points) {
  std::string text;
  for (const Point2 p : points)
    text += fmt::format("{:.9g} {:.9g}\n", p.y, p.z);
  return text;
}

} // namespace bem_contact
