#include "bem_contact/geometry/contact_locus.hpp"

#include "bem_contact/geometry/settings.hpp"

#include <numbers>

namespace bem_contact {

namespace {

/// rad. Turn of the tangent between two nodes of the locus at an edge: 0.1 mm of an edge rounded with 20 mm.
constexpr double edge_step = 0.005;

/// sin and cos of theta at which the normal has no component along x; nothing where there is none.
struct Meridian {
  double sine = 0, cosine = 1;
};

std::optional<Meridian> meridian(const WheelFrame& frame, Point2 tangent) {
  const double n_y = tangent.z, n_r = -tangent.y; // outward: into the body is (-tangent.z, tangent.y)
  const double c = -n_y * frame.axle[0];
  if (c == 0 && frame.down[0] == 0)
    return Meridian{};
  const double a = n_r * frame.forward[0], b = n_r * frame.down[0];
  const double size = a * a + b * b, under = size - c * c;
  if (!(under > 0) || !(n_r > 0))
    return std::nullopt;
  const double root = std::sqrt(under);
  return Meridian{(a * c - b * root) / size, (b * c + a * root) / size};
}

} // namespace

ContactLocus::ContactLocus(const WheelOnRail& pair)
    : wheel_(pair.wheel), radius_(pair.wheel_radius), frame_(pair.wheel_frame()) {
  const auto table = wheel_.nodes();
  nodes_.reserve(table.size() + 16);
  bool joined = false;
  const auto add = [&](int k, Point2 tangent) {
    const auto p = point(table[k].s, table[k].position, tangent);
    if (p)
      nodes_.push_back({*p, tangent, joined, k});
    joined = p.has_value();
  };
  for (int k = 0; k < static_cast<int>(table.size()); ++k) {
    add(k, table[k].before);
    if (frame_.axle[0] == 0)
      continue;
    const double angle = angle_from_to(table[k].before, table[k].after);
    if (std::abs(angle) < smooth_turn)
      continue;
    const int steps = 1 + static_cast<int>(std::abs(angle) / edge_step);
    for (int i = 1; i <= steps; ++i)
      add(k, turned(table[k].before, angle * i / steps));
  }
}

void ContactLocus::lower(double by) {
  frame_.centre[2] += by;
  for (Node& node : nodes_)
    node.position.z += by;
}

std::optional<ContactLocus::Point> ContactLocus::point(double s, Point2 position, Point2 tangent) const {
  const double r = radius_ + position.z;
  const auto m = meridian(frame_, tangent);
  if (!m || r <= 0)
    return std::nullopt;
  const auto along = [&](int i) {
    return frame_.centre[i] + position.y * frame_.axle[i] +
           r * (m->cosine * frame_.down[i] + m->sine * frame_.forward[i]);
  };
  return Point{s, along(0), {along(1), along(2)}};
}

ContactLocus::Point ContactLocus::between(int k, double t) const {
  const Node &a = nodes_[k], &b = nodes_[k + 1];
  std::optional<Point> p;
  if (a.s == b.s) {
    p = point(a.s, wheel_.nodes()[a.interval].position,
              turned(a.tangent, t * angle_from_to(a.tangent, b.tangent)));
  } else {
    const TabulatedProfile::Point q = wheel_.between(a.interval, t);
    p = point(a.s + t * (b.s - a.s), q.position, q.tangent);
  }
  // Both ends have a locus; a point between them that has none is nearer to either than a tenth of a mm.
  return p ? *p : t < 0.5 ? Point(a) : Point(b);
}

double ContactLocus::curvature_along_x(int k, double t) const {
  const Node &a = nodes_[k], &b = nodes_[k + 1];
  if (a.s == b.s)
    return 0;
  const TabulatedProfile::Point q = wheel_.between(a.interval, t);
  const auto m = meridian(frame_, q.tangent);
  if (!m)
    return 0;
  // Euler's formula with the principal directions, along the profile and around the axle.
  const auto table = wheel_.nodes();
  const double profile = angle_from_to(table[a.interval].after, table[a.interval + 1].before) / (b.s - a.s);
  const double around = -q.tangent.y / (radius_ + q.position.z);
  const double share =
      q.tangent.y * frame_.axle[0] + q.tangent.z * (m->cosine * frame_.down[0] + m->sine * frame_.forward[0]);
  return profile * share * share + around * (1 - share * share);
}

std::optional<CurvePoint> ContactLocus::at(double s) const {
  CurvePoint p = wheel_.at(s);
  const Point2 tangent = tangent_of(p.delta);
  const auto seen = point(s, p.position, tangent);
  const auto m = meridian(frame_, tangent);
  if (!seen || !m)
    return std::nullopt;
  const auto normal = [&](int i) {
    return tangent.z * frame_.axle[i] -
           tangent.y * (m->cosine * frame_.down[i] + m->sine * frame_.forward[i]);
  };
  // On the branch of the profile's own inclination.
  const double near = p.delta + std::asin(frame_.axle[2]), delta = std::atan2(normal(1), -normal(2));
  p.position = seen->position;
  p.delta = delta + 2 * std::numbers::pi * std::round((near - delta) / (2 * std::numbers::pi));
  return p;
}

} // namespace bem_contact
