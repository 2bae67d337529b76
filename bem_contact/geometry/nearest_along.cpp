#include "bem_contact/geometry/nearest_along.hpp"

#include "bem_contact/geometry/settings.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <limits>
#include <utility>

namespace bem_contact {

namespace {

/// 1. Halvings of a sample's length until the end of a stretch is found: 0.5 mm to 1e-12 mm.
constexpr int end_halvings = 40;
/// 1. How much farther than by its own tilt the normal of a yawed wheel moves the nearest point: the tangent
/// of the steepest flange, 75 degrees.
constexpr double steepest = 4;

} // namespace

NearestAlong::NearestAlong(UnevenSurfaces surfaces, const WheelFrame& frame, double wheel_radius)
    : surfaces_(std::move(surfaces)), frame_(frame), radius_(wheel_radius) {
  // A round wheel rises by x^2 / 2R: farther away than this unevenness cannot bring it to the rail.
  const double reach = std::sqrt(2 * (surfaces_.range() + uneven_margin) / wheel_radius),
               turn = steepest * std::abs(frame.axle[0]);
  beside_ = 1 + static_cast<int>(std::ceil(reach * wheel_radius / uneven_step));
  const int count = beside_ + static_cast<int>(std::ceil(turn * wheel_radius / uneven_step));
  for (int i = -count; i <= count; ++i)
    samples_.push_back(sample(i * uneven_step / wheel_radius));
}

NearestAlong::Sample NearestAlong::sample(double theta) const {
  return {theta, std::sin(theta), std::cos(theta), surfaces_.depth(theta)};
}

/// UnevenSurfaces::wheel()
Point2 NearestAlong::offset(const Circle& c, const Sample& s) const {
  const SectionedWheel* sections = surfaces_.wheel_sections();
  return Point2{0, -s.depth} + (sections ? sections->offset(s.theta, c.s) : Point2{});
}

double NearestAlong::x_of(const Circle& c, const Sample& s) const {
  const Point2 off = offset(c, s);
  return c.x0 + off.y * frame_.axle[0] +
         (c.radius + off.z) * (s.cosine * frame_.down[0] + s.sine * frame_.forward[0]);
}

/// Along the normal towards the rail, from where the even circle is nearest: a difference of radii would be
/// rounded so coarsely that the nearest angle was off by 1e-8.
double NearestAlong::reach(const Circle& c, const Sample& s) const {
  const Point2 off = offset(c, s);
  const double along = s.cosine * c.n_down + s.sine * c.n_forward,
               beside = s.sine * c.n_down - s.cosine * c.n_forward;
  return off.y * c.n_axle + off.z * along - c.radius * beside * beside / (c.n_radial + along) -
         c.n_z * surfaces_.rail(x_of(c, s));
}

/// The angle between two samples at which the reach falls below `least`.
double NearestAlong::end_of_stretch(const Circle& c, int inside, int outside, double least) const {
  if (outside < 0 || outside >= static_cast<int>(samples_.size()))
    return samples_[inside].theta;
  double in = samples_[inside].theta, out = samples_[outside].theta;
  for (int i = 0; i < end_halvings; ++i) {
    const double middle = 0.5 * (in + out);
    (reach(c, sample(middle)) >= least ? in : out) = middle;
  }
  return in;
}

NearestAlong::Place NearestAlong::at(double s, Point2 section, const Vector3& normal) const {
  Circle c{s,
           radius_ + section.z,
           frame_.centre[0] + section.y * frame_.axle[0],
           dot(normal, frame_.down),
           dot(normal, frame_.forward),
           dot(normal, frame_.axle),
           normal[2],
           0};
  c.n_radial = std::hypot(c.n_down, c.n_forward);
  const int last = static_cast<int>(samples_.size()) - 1;
  const int even =
      last / 2 + static_cast<int>(std::lround(std::atan2(c.n_forward, c.n_down) * radius_ / uneven_step));
  const int begin = std::clamp(even - beside_, 0, last), stop = std::clamp(even + beside_, 0, last);
  std::vector<double> reaches(samples_.size(), -std::numeric_limits<double>::infinity());
  for (int i = begin; i <= stop; ++i)
    reaches[i] = reach(c, samples_[i]);
  const int best = static_cast<int>(std::ranges::max_element(reaches) - reaches.begin());
  const auto angle_at = [&](double samples) { // from the best one
    return samples_[best].theta + samples * uneven_step / radius_;
  };
  const auto [at, least] = boost::math::tools::brent_find_minima(
      [&](double samples) { return -reach(c, sample(angle_at(samples))); }, best > 0 ? -1.0 : 0.0,
      best < last ? 1.0 : 0.0, std::numeric_limits<double>::digits / 2);
  Place out;
  const double most = std::max(-least, reaches[best]);
  out.theta = -least > reaches[best] ? angle_at(at) : samples_[best].theta;

  const double inside = most - uneven_depth;
  int first = best, end = best; // of the samples in the stretch; what lies between its parts belongs to it
  for (int i = begin; i <= stop; ++i)
    if (reaches[i] >= inside)
      first = std::min(first, i), end = std::max(end, i);
  const auto x_at = [&](double angle) { return x_of(c, sample(angle)); };
  double from = end_of_stretch(c, first, first - 1, inside), to = end_of_stretch(c, end, end + 1, inside);
  if (first == best && end == best && reaches[best] < inside) // narrower than a sample
    from = to = out.theta;
  from = std::min(from, out.theta), to = std::max(to, out.theta);
  const double x_from = x_at(from), x_to = x_at(to);
  const double width = std::max(std::abs(x_to - x_from), uneven_step);
  // Measured on what a round wheel has there: the parabola of a finite depth is not the circle.
  const double cosine = c.n_down / c.n_radial, sine = c.n_forward / c.n_radial,
               rise =
                   uneven_depth / c.n_radial, // of the circle, from its nearest place to the stretch's ends
      round_width = 2 * std::sqrt(rise * (2 * c.radius - rise)) *
                    std::abs(frame_.forward[0] * cosine - frame_.down[0] * sine);
  const double outward = frame_.down[0] * cosine + frame_.forward[0] * sine; // x of it
  out.x = 0.5 * (x_from + x_to) + rise * outward;
  out.ahead = out.x - (c.x0 + c.radius * outward);
  out.sharper = round_width * round_width / (width * width);
  const double lower = surfaces_.rail(x_at(out.theta));
  out.rail_lower = lower < UnevenSurfaces::no_rail ? lower : 0;
  return out;
}

} // namespace bem_contact
