#include "bem_contact/profile/running_head.hpp"

#include "bem_contact/profile/standard_profiles.hpp"
#include "worn_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace bem_contact {
namespace {

using Points = std::vector<Point2>;

/// 60E1 with something beside its gauge side: a wall of a groove, then a level top.
Points beside(double height, double groove, double width) {
  Points points = worn_points("60E1", {}, {}, 0.4);
  const double face = std::ranges::min(points, {}, &Point2::y).y, bottom = points.front().z;
  const Point2 wall{face - groove, -height};
  Points out{{wall.y - width, bottom}, {wall.y - width, wall.z}, wall, {wall.y, bottom}};
  out.insert(out.end(), points.begin(), points.end());
  return out;
}

TEST(RunningHead, OfOneHeadIsItsTop) {
  const Points points = worn_points("60E1", {}, {}, 0.4);
  const std::size_t top = top_of_running_head(points, 14);
  EXPECT_EQ(top, static_cast<std::size_t>(std::ranges::min_element(points, {}, &Point2::z) - points.begin()));
}

TEST(RunningHead, IsTheOneBehindTheGrooveHoweverHighTheKeeperIs) {
  for (const double height : {-8.0, 0.0, 0.5, 20.0, 60.0})
    for (const double groove : {40.0, 45.0, 60.0}) {
      const Points points = beside(height, groove, 20);
      EXPECT_NEAR(points[top_of_running_head(points, 14)].y, 0, 0.5) << height << ' ' << groove;
    }
}

/// A blade lies on its stock rail: the highest of both counts, as no flange passes between them.
TEST(RunningHead, OfABladeBesideItsStockRailIsTheHigherOne) {
  const Points points = beside(3, 5, 20);
  EXPECT_LT(points[top_of_running_head(points, 14)].y, -36);
}

} // namespace
} // namespace bem_contact
