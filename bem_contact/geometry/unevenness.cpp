#include "bem_contact/geometry/unevenness.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace bem_contact {

namespace {

/// max(g, 0) with the corner rounded where |g| < width: the polynomial that is smooth to the second
/// derivative at both ends.
double rounded_positive(double g, double width) {
  if (g <= -width)
    return 0;
  if (g >= width)
    return g;
  const double t = g / width;
  return width * (3 + t * (8 + t * (6 - t * t))) / 16;
}

/// How far the chord that ends at +- half_angle lies inside the circle, mm; below 0 outside of the chord.
double inside_circle(double radius, double half_angle, double angle) {
  return radius * (1 - std::cos(half_angle) / std::cos(angle));
}

} // namespace

void refuse_uneven(const std::string& problem, const std::string& why) {
  throw InputError(problem, why, "Leave out wheel.flat, wheel.polygon, rail.joint and sections of either.");
}

double depth_of_chord(double radius, double length) {
  return inside_circle(radius, std::asin(length / (2 * radius)), 0);
}

UnevenSurfaces::UnevenSurfaces(Unevenness what, double wheel_radius,
                               std::shared_ptr<const SectionedSurface> wheel)
    : what_(std::move(what)), radius_(wheel_radius), turned_(what_.along / wheel_radius) {
  if (const WheelFlat& flat = what_.flat; flat.given()) {
    half_angle_ =
        flat.length > 0 ? std::asin(flat.length / (2 * radius_)) : std::acos(1 - flat.depth / radius_);
    const double chord = inside_circle(radius_, half_angle_, 0);
    share_ = flat.depth > 0 ? flat.depth / chord : 1;
    blend_ = 0.5 * flat.rounding * std::tan(half_angle_); // the chord's slope at its ends
    range_ += share_ * chord;
  }
  for (const double amplitude : what_.polygon.amplitudes)
    range_ += 2 * std::abs(amplitude);
  const RailJoint& joint = what_.joint;
  range_ += joint.dip + std::abs(joint.step);
  if (joint.gap > 0 || joint.step != 0)
    range_ += joint.rounding + depth_of_chord(radius_, joint.gap); // so deep the wheel sinks into a gap
  if (wheel) {
    sections_.emplace(std::move(wheel), turned_ - what_.sections_angle);
    range_ += sections_->range();
  }
}

double UnevenSurfaces::depth(double theta) const {
  const double angle = theta + turned_;
  double depth = 0;
  if (what_.flat.given()) {
    const double beside = std::remainder(angle - what_.flat.angle, 2 * std::numbers::pi);
    if (std::abs(beside) < 2 * half_angle_ + what_.flat.rounding / radius_)
      depth = share_ * rounded_positive(inside_circle(radius_, half_angle_, beside), blend_);
  }
  const WheelPolygon& polygon = what_.polygon;
  for (std::size_t i = 0; i < polygon.orders.size(); ++i)
    depth -= polygon.amplitudes[i] *
             std::cos(polygon.orders[i] * (angle - (polygon.phases.empty() ? 0 : polygon.phases[i])));
  return depth;
}

double UnevenSurfaces::rail(double x) const {
  const RailJoint& joint = what_.joint;
  if (!joint.given())
    return 0;
  const double u = what_.along + x - joint.at, from_end = std::abs(u) - 0.5 * joint.gap;
  if (joint.gap > 0 && from_end < 0)
    return no_rail;
  const double share = std::max(0.0, 1 - 2 * std::abs(u) / joint.dip_length);
  double depth = joint.dip * share * share + (u > 0 ? joint.step : 0);
  if ((joint.gap > 0 || joint.step != 0) && from_end < joint.rounding) {
    const double inside = joint.rounding - from_end;
    depth += joint.rounding - std::sqrt(std::max(0.0, joint.rounding * joint.rounding - inside * inside));
  }
  return depth;
}

} // namespace bem_contact
