#pragma once

#include "bem_contact/geometry/contact_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace bem_contact {

inline constexpr double infinite = std::numeric_limits<double>::infinity();

/// The vertical distance over (x, y) without any contact locus: the wheel's surface from two angles, the rail
/// as a height. Independent of what it checks but for the curves and the rail's pose.
class BruteForce {
public:
  BruteForce(const TabulatedProfile& rail, const TabulatedProfile& wheel, double reach)
      : angles(2 * static_cast<int>(reach / dangle) + 1), wheel_(wheel) {
    const int n = static_cast<int>(std::ceil((rail.s_end() - rail.s_begin()) / 2e-3));
    for (int i = 0; i <= n; ++i)
      rail_.push_back(rail.at(std::min(rail.s_begin() + 2e-3 * i, rail.s_end())).position);
    for (double s = wheel.s_begin(); s <= wheel.s_end(); s += ds)
      profile_.push_back(wheel.at(s));
    for (const TabulatedProfile::Node& node : wheel.nodes())
      if (dot(node.before, node.after) < 0.99) // at an edge the angle of the least distance leaps with s
        profile_.push_back(wheel.at(node.s));
    std::ranges::sort(profile_, {}, &CurvePoint::s);
  }

  struct Minimum {
    double distance = infinite, s = 0, y = 0, x = 0, theta = 0;
  };
  /// Local minima, those within `band` of the lowest.
  std::vector<Minimum> search(const WheelsetPosition& position, const WheelOnRail& pair, double band) {
    stand(position, pair);
    const int n = static_cast<int>(profile_.size());
    std::vector<double>& h = raster_;
    h.assign(static_cast<std::size_t>(n) * angles, infinite);
    double lowest = infinite;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < angles; ++j) {
        double& value = h[static_cast<std::size_t>(i) * angles + j];
        value = distance(profile_[i].position, angle(j)).distance;
        lowest = std::min(lowest, value);
      }
    std::vector<Minimum> out;
    for (int i = 1; i + 1 < n; ++i)
      for (int j = 1; j + 1 < angles; ++j) {
        const double value = h[static_cast<std::size_t>(i) * angles + j];
        if (!(value < lowest + band))
          continue;
        bool least = true;
        for (int di = -1; di <= 1; ++di)
          for (int dj = -1; dj <= 1; ++dj)
            least &= value <= h[static_cast<std::size_t>(i + di) * angles + j + dj];
        if (!least)
          continue;
        const Minimum m = refined(profile_[i].s, angle(j));
        if (m.distance < infinite)
          out.push_back(m);
      }
    std::ranges::sort(out, {}, &Minimum::distance);
    return out;
  }

  /// How far the distance rises between a minimum and the next lower place of the profile.
  double barrier(const Minimum& m) const {
    double least = infinite;
    for (const double step : {-0.02, 0.02}) {
      double rise = 0, s = m.s + step;
      for (; s > wheel_.s_begin() && s < wheel_.s_end(); s += step) {
        const double h = least_over_angle(s, m.theta).distance;
        if (h < m.distance)
          break;
        rise = std::max(rise, h - m.distance);
      }
      least = std::min(least, rise);
    }
    return least;
  }

  /// What may differ there: 1e-6 mm and what the chords of the raster miss of the rail.
  static double tolerance(const WheelOnRail& pair, double rail_s) {
    const CurvePoint p = pair.rail_at(rail_s);
    return 1e-6 + dy * dy / 8 * std::abs(p.curvature / std::pow(std::cos(p.delta), 3));
  }
  bool is_minimum(const TouchPoint& p, double theta, double tolerance) const {
    const auto excess = [&](double s) { return least_over_angle(s, theta).distance - p.distance; };
    return std::abs(excess(p.wheel_s)) < tolerance && excess(p.wheel_s - 0.02) > -tolerance &&
           excess(p.wheel_s + 0.02) > -tolerance;
  }

private:
  static constexpr double ds = 0.25, dangle = 2e-3;
  int angles; ///< of the raster
  double angle(int j) const { return dangle * (j - angles / 2); }

  void stand(const WheelsetPosition& position, const WheelOnRail& pair) {
    const double side = position.side == WheelSide::left ? -1 : 1;
    roll_ = side * position.roll, yaw_ = side * position.yaw, lateral_ = side * position.lateral;
    arm_ = position.back_to_back / 2 + 70, radius_ = position.wheel_radius;
    axis_ = position.roller_radius > 0 ? position.roller_radius + position.rail_vertical : infinite;
    // As a height on a regular raster of y, from the points that are seen from above.
    std::vector<Point2>& p = placed_;
    p.resize(rail_.size());
    std::ranges::transform(rail_, p.begin(), [&](const Point2& q) { return pair.rail_pose.to_track(q); });
    const auto [lo, hi] = std::ranges::minmax(p, {}, &Point2::y);
    y0_ = lo.y;
    height_.assign(static_cast<std::size_t>((hi.y - lo.y) / dy) + 1, infinite);
    for (std::size_t k = 0; k + 1 < p.size(); ++k) {
      const Point2 a = p[k].y <= p[k + 1].y ? p[k] : p[k + 1], b = p[k].y <= p[k + 1].y ? p[k + 1] : p[k];
      for (int i = static_cast<int>(std::ceil((a.y - y0_) / dy)); y0_ + i * dy <= b.y; ++i) {
        const double t = b.y > a.y ? (y0_ + i * dy - a.y) / (b.y - a.y) : 0;
        height_[i] = std::min(height_[i], a.z + t * (b.z - a.z));
      }
    }
  }

  Minimum distance(Point2 section, double theta) const {
    const double r = radius_ + section.z;
    const double x = r * std::sin(theta), y = arm_ + section.y, z = r * std::cos(theta);
    const double rolled_y = y * std::cos(roll_) - z * std::sin(roll_);
    const double down = y * std::sin(roll_) + z * std::cos(roll_) - radius_;
    const double across = lateral_ + x * std::sin(yaw_) + rolled_y * std::cos(yaw_);
    const double at = (across - y0_) / dy;
    const auto k = static_cast<std::ptrdiff_t>(std::floor(at));
    if (k < 0 || k + 1 >= static_cast<std::ptrdiff_t>(height_.size()))
      return {};
    const double t = at - static_cast<double>(k), height = (1 - t) * height_[k] + t * height_[k + 1];
    const double along = x * std::cos(yaw_) - rolled_y * std::sin(yaw_);
    if (axis_ == infinite)
      return {height - down, 0, across, along};
    // A circle of the roller: where a vertical line at `along` meets it.
    const double circle = axis_ - height, under = circle * circle - along * along;
    return under > 0 ? Minimum{axis_ - std::sqrt(under) - down, 0, across, along} : Minimum{};
  }

  template <class F> static double golden(double a, double b, double tolerance, const F& f) {
    const double g = 0.5 * (std::sqrt(5.0) - 1);
    double c = b - g * (b - a), d = a + g * (b - a), fc = f(c), fd = f(d);
    while (b - a > tolerance) {
      if (fc < fd) {
        b = d, d = c, fd = fc, c = b - g * (b - a), fc = f(c);
      } else {
        a = c, c = d, fc = fd, d = a + g * (b - a), fd = f(d);
      }
    }
    return 0.5 * (a + b);
  }

  Minimum least_over_angle(double s, double theta0) const {
    const Point2 p = wheel_.at(std::clamp(s, wheel_.s_begin(), wheel_.s_end())).position;
    const double theta = golden(theta0 - 2 * dangle, theta0 + 2 * dangle, 1e-8,
                                [&](double t) { return distance(p, t).distance; });
    Minimum m = distance(p, theta);
    m.s = s, m.theta = theta;
    return m;
  }

  /// Over the angle inside, over the arc length outside; nothing where it runs out of the cells around it.
  Minimum refined(double s0, double theta0) const {
    const double s = golden(s0 - 2 * ds, s0 + 2 * ds, 1e-6,
                            [&](double t) { return least_over_angle(t, theta0).distance; });
    const Minimum m = least_over_angle(s, theta0);
    return std::abs(m.s - s0) > 1.9 * ds || std::abs(m.theta - theta0) > 1.9 * dangle ? Minimum{} : m;
  }

  static constexpr double dy = 1e-3;
  TabulatedProfile wheel_;
  std::vector<Point2> rail_;
  std::vector<CurvePoint> profile_;
  double roll_ = 0, yaw_ = 0, lateral_ = 0, arm_ = 0, radius_ = 0, y0_ = 0, axis_ = infinite;
  std::vector<double> height_;
  // Scratch, kept: they are large, and fresh memory is dear.
  std::vector<Point2> placed_;
  std::vector<double> raster_;
};

} // namespace bem_contact
