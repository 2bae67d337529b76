#include "bem_contact/geometry/contact_locus.hpp"

#include "bem_contact/geometry/settings.hpp"

#include <algorithm>
#include <numbers>

namespace bem_contact {

namespace {

/// rad. Turn of the tangent between two nodes of the locus at an edge: 0.1 mm of an edge rounded with 20 mm.
constexpr double edge_step = 0.005;

/// The y component of a x b.
double across(const Vector3& a, const Vector3& b) {
  return a[2] * b[0] - a[0] * b[2];
}

} // namespace

ContactLocus::ContactLocus(const WheelOnRail& pair)
    : wheel_(pair.wheel), radius_(pair.wheel_radius), frame_(pair.wheel_frame()), down_(pair.seen({0, 0, 1})),
      roller_(pair.roller) {
  if (pair.uneven)
    nearest_.emplace(*pair.uneven, frame_, radius_);
  trace();
}

void ContactLocus::trace() {
  const auto table = wheel_.nodes();
  nodes_.clear();
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
  for (int i = 0; i < 3; ++i)
    frame_.centre[i] += by * down_[i];
  if (roller_)
    return trace(); // it slides round the wheel
  for (Node& node : nodes_) {
    node.x += by * down_[0];
    node.position.z += by * down_[2];
  }
}

std::optional<ContactLocus::Meridian> ContactLocus::meridian(double s, Point2 position,
                                                             Point2 tangent) const {
  std::optional<Meridian> m = even_meridian(position, tangent);
  if (!nearest_ || !m || !(tangent.y < 0)) // a surface that looks up meets no rail
    return m;
  m->uneven = nearest_->at(s, position, surface(s, position, tangent, *m).normal);
  m->sine = std::sin(m->uneven->theta);
  m->cosine = std::cos(m->uneven->theta);
  return m;
}

std::optional<ContactLocus::Meridian> ContactLocus::even_meridian(Point2 position, Point2 tangent) const {
  const double n_y = tangent.z, n_r = -tangent.y; // outward: into the body is (-tangent.z, tangent.y)
  double a = n_r * frame_.forward[0], b = n_r * frame_.down[0], c = -n_y * frame_.axle[0];
  if (roller_) {
    // axle x down = forward, axle x forward = -down
    const Vector3 arm{frame_.centre[0], frame_.centre[1], frame_.centre[2] - roller_->axis};
    const double length = -arm[2], turn = position.y * n_r - (radius_ + position.z) * n_y;
    a = -(n_r * across(arm, frame_.forward) - turn * frame_.down[1]) / length;
    b = -(n_r * across(arm, frame_.down) + turn * frame_.forward[1]) / length;
    c = n_y * across(arm, frame_.axle) / length;
  } else if (c == 0 && frame_.down[0] == 0)
    return Meridian{};
  const double size = a * a + b * b, under = size - c * c;
  if (!(under > 0) || !(n_r > 0))
    return std::nullopt;
  const double root = std::sqrt(under);
  return Meridian{(a * c - b * root) / size, (b * c + a * root) / size};
}

Vector3 ContactLocus::on_circle(double s, Point2 position, const Meridian& m) const {
  if (m.uneven)
    position = position + nearest_->surfaces().wheel(m.uneven->theta, s);
  const double r = radius_ + position.z;
  const auto along = [&](int i) {
    return frame_.centre[i] + position.y * frame_.axle[i] +
           r * (m.cosine * frame_.down[i] + m.sine * frame_.forward[i]);
  };
  const double x = along(0);
  return {x, along(1), along(2) - (m.uneven ? nearest_->surfaces().rail(x) : 0.0)};
}

std::optional<ContactLocus::Point> ContactLocus::point(double s, Point2 position, Point2 tangent) const {
  const auto m = meridian(s, position, tangent);
  if (!m || radius_ + position.z <= 0)
    return std::nullopt;
  Vector3 p = on_circle(s, position, *m);
  if (roller_)
    p = roller_->unrolled(p);
  if (m->uneven)
    return Point{s, m->uneven->x, {p[1], p[2]}, m->uneven->rail_lower, m->uneven->ahead, m->uneven->sharper};
  return Point{s, p[0], {p[1], p[2]}};
}

ContactLocus::Surface ContactLocus::surface(double s, Point2 position, Point2 tangent,
                                            const Meridian& m) const {
  const auto both = [&](double along_axle, double away) {
    const auto of = [&](int i) {
      return along_axle * frame_.axle[i] + away * (m.cosine * frame_.down[i] + m.sine * frame_.forward[i]);
    };
    return Vector3{of(0), of(1), of(2)};
  };
  const Vector3 profile = both(tangent.y, tangent.z), normal = both(tangent.z, -tangent.y);
  if (!roller_)
    return {profile[0], normal, 0};
  const Vector3 p = roller_->unrolled(on_circle(s, position, m));
  const double phi = roller_->angle(p[0], {p[1], p[2]});
  const Vector3 seen = Roller::seen(normal, phi);
  return {Roller::seen(profile, phi)[0], seen, seen[2] / roller_->radius({p[1], p[2]})}; // Meusnier
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
  const double s = a.s + t * (b.s - a.s);
  const auto m = even_meridian(q.position, q.tangent);
  if (!m)
    return 0;
  // Euler's formula with the principal directions, along the profile and around the axle.
  const auto table = wheel_.nodes();
  const double profile = angle_from_to(table[a.interval].after, table[a.interval + 1].before) / (b.s - a.s);
  const double around = -q.tangent.y / (radius_ + q.position.z);
  const Surface there = surface(s, q.position, q.tangent, *m);
  const double share = there.along_profile;
  const double even = profile * share * share + around * (1 - share * share) + there.rail;
  return nearest_ ? std::max(even, 2 * least_slice_curvature / radius_) : even;
}

std::optional<CurvePoint> ContactLocus::at(double s) const {
  CurvePoint p = wheel_.at(s);
  const Point2 tangent = tangent_of(p.delta);
  const auto seen = point(s, p.position, tangent);
  const auto m = meridian(s, p.position, tangent);
  if (!seen || !m)
    return std::nullopt;
  const Vector3 normal = surface(s, p.position, tangent, *m).normal;
  // On the branch of the profile's own inclination.
  const double near = p.delta + std::asin(frame_.axle[2]), delta = std::atan2(normal[1], -normal[2]);
  p.position = seen->position;
  p.delta = delta + 2 * std::numbers::pi * std::round((near - delta) / (2 * std::numbers::pi));
  return p;
}

} // namespace bem_contact
