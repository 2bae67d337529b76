#include "bem_contact/profile/measured/worn_side.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace bem_contact {

namespace {

/// mm. So far below the top the crown tells its axis; above it is too flat for a comparison along y.
constexpr double crown_depth = 2.0;
/// mm. New heads are convex. A flank that lies farther behind the line between two of its points is worn;
/// noise and the rounding of drawings stay below. Chosen.
constexpr double deepest_recess = 0.15;
/// mm. Heads of rails are no deeper; below lie fishing surface and web.
constexpr double largest_flank_depth = 34.0;
/// mm. Where a flank leads inwards by more, the head ends. What lies farther outwards, and higher than that,
/// is a keeper or another rail.
constexpr double under_head = 3.0;
/// mm. What the lowest part of the flanks is: below the wear, which ends where the flange does. It tells the
/// axis.
constexpr double unworn_flank = 6.0;
/// mm. A scan that shows less of the flanks does not tell which is worn.
constexpr double least_flanks = 16.0;
/// rad. Flanks whose axis leans by more are not inclined in the track (1:20), but one of them is worn down to
/// the end of the scan.
constexpr double largest_lean = 0.07;
/// mm. Less wear of one side than of the other tells nothing: rolling tolerances are 0.5 mm. Chosen.
constexpr double least_side_wear = 1.0;

constexpr double depth_step = 0.5; // mm
constexpr int upright_rounds = 2;  // each a step of Newton's method for the lean

/// Half of a head: y of its flank, seen from the top outwards, at depths in equal steps below the top.
class Flank {
public:
  /// side: -1 towards smaller y, 1 towards larger y.
  Flank(std::span<const Point2> points, int side) : side_(side) {
    const auto top = std::ranges::min_element(points, {}, &Point2::z) - points.begin();
    const double height = points[top].z;
    const auto count = static_cast<std::ptrdiff_t>(points.size());
    double outermost = side * points[top].y;
    for (std::ptrdiff_t i = top; i + side >= 0 && i + side < count && next() <= largest_flank_depth;
         i += side) {
      const Point2 a = points[i], b = points[i + side];
      outermost = std::max(outermost, side * b.y);
      if (side * b.y < outermost - under_head)
        break;
      for (double depth = next(); b.z - height >= depth; depth = next())
        y_.push_back(b.z > a.z ? a.y + (b.y - a.y) * (depth - (a.z - height)) / (b.z - a.z) : b.y);
    }
    const double deepest = next() - depth_step;
    alone_ = std::ranges::none_of(
        points, [&](Point2 p) { return side * p.y > outermost + under_head && p.z - height < deepest; });
  }

  double depth() const { return alone_ && !y_.empty() ? next() - depth_step : 0; }
  double y(double depth) const { return y_[static_cast<std::size_t>(std::lround(depth / depth_step)) - 1]; }
  /// Outwards, mean slope dy/dz of the lowest part above `depth`.
  double slope(double depth) const { return side_ * (y(depth) - y(depth - unworn_flank)) / unworn_flank; }
  /// How far the flank lies behind the straight line between two of its points above `depth`, mm. A new head
  /// is convex. Means of three depths, against noise.
  double recess(double depth) const {
    std::vector<double> out;
    for (double at = crown_depth + depth_step; at + depth_step <= depth; at += depth_step)
      out.push_back(side_ * (y(at - depth_step) + y(at) + y(at + depth_step)) / 3);
    const auto slope = [&](std::size_t i, std::size_t k) {
      return (out[k] - out[i]) / static_cast<double>(k - i);
    };
    double most = 0;
    for (std::size_t from = 0, to = 0; from + 1 < out.size();
         from = to) { // to the next point that no line passes by
      to = from + 1;
      for (std::size_t k = to + 1; k < out.size(); ++k)
        to = slope(from, k) >= slope(from, to) ? k : to;
      for (std::size_t i = from + 1; i < to; ++i)
        most = std::max(most, (slope(from, to) - slope(from, i)) * static_cast<double>(i - from));
    }
    return most;
  }

private:
  double next() const { return depth_step * static_cast<double>(y_.size() + 1); }

  int side_;
  std::vector<double> y_;
  bool alone_ = true;
};

std::vector<Point2> leaned(std::span<const Point2> points, double angle) {
  std::vector<Point2> out;
  for (const Point2 p : points)
    out.push_back(turned(p, angle));
  return out;
}

/// Of an upright head. What is missing on the right leaves the middle between both flanks farther to the
/// left.
double difference(const Flank& left, const Flank& right, double depth) {
  const auto middle = [&](double at) { return std::midpoint(left.y(at), right.y(at)); };
  double least = middle(depth), largest = least; // below the wear, or where all of one flank is worn
  for (double at = crown_depth; at <= depth; at += depth_step) {
    least = std::min(least, middle(at));
    largest = std::max(largest, middle(at));
  }
  const double worn = 2 * (largest - least);
  const bool left_worn = left.recess(depth) > deepest_recess,
             right_worn = right.recess(depth) > deepest_recess;
  if (worn < least_side_wear || (left_worn && right_worn))
    return 0;
  if (left_worn != right_worn)
    return left_worn ? -worn : worn;
  // Both are convex. Crown and lower flanks must agree on the axis; then the wear lies between them.
  const double axis = middle(depth - unworn_flank / 2);
  if (2 * std::abs(middle(crown_depth) - axis) > least_side_wear)
    return 0;
  const double to_left = axis - least, to_right = largest - axis;
  return std::min(to_left, to_right) > std::max(to_left, to_right) / 2 ? 0
         : to_left > to_right                                          ? worn
                                                                       : -worn;
}

} // namespace

double more_worn_at_larger_y(std::span<const Point2> points) {
  std::vector<Point2> upright(points.begin(), points.end());
  double lean = 0;
  for (int round = 0;; ++round) {
    const Flank left(upright, -1), right(upright, 1);
    const double depth = std::min(left.depth(), right.depth());
    if (depth < least_flanks)
      return 0;
    if (round == upright_rounds)
      return difference(left, right, depth);
    lean += std::atan((right.slope(depth) - left.slope(depth)) / 2);
    if (std::abs(lean) > largest_lean) // worn down to the end of the scan: the flatter flank is
      return std::copysign(depth * std::abs(lean), lean);
    upright = leaned(points, lean);
  }
}

} // namespace bem_contact
