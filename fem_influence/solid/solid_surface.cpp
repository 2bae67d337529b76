#include "fem_influence/solid/solid_surface.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace bem_contact::fem {

namespace {

using Polygon = std::vector<SurfacePoint>;

/// 1, of the element's area. Parts of an element on a face that are smaller are round-off and left out.
constexpr double smallest_part = 1e-14;
/// 1. Newton steps at most for the place on a face, and the change that ends them. Faces are nearly
/// rectangles, where one step is exact.
constexpr int face_steps = 20;
constexpr double face_change = 1e-13;

SurfacePoint between(SurfacePoint a, SurfacePoint b, double t) {
  return {a.s + t * (b.s - a.s), a.x + t * (b.x - a.x)};
}

/// What of a convex polygon lies where `inside` is not negative; inside is affine.
template <class Inside> Polygon clip(const Polygon& polygon, Inside inside) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const SurfacePoint a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const double at_a = inside(a), at_b = inside(b);
    if (at_a >= 0)
      kept.push_back(a);
    if (at_a * at_b < 0)
      kept.push_back(between(a, b, at_a / (at_a - at_b)));
  }
  return kept;
}

double twice_area(SurfacePoint a, SurfacePoint b, SurfacePoint c) {
  return (b.s - a.s) * (c.x - a.x) - (b.x - a.x) * (c.s - a.s);
}

/// The unit square's point whose bilinear image is `place`: Newton, exact at once on a rectangle.
FacePoint inverse(const std::array<SurfacePoint, 4>& c, SurfacePoint place, double weight) {
  FacePoint p{0.5, 0.5, place, weight};
  for (int step = 0; step < face_steps; ++step) {
    const SurfacePoint low = between(c[0], c[1], p.xi), high = between(c[2], c[3], p.xi);
    const SurfacePoint at = between(low, high, p.eta);
    const SurfacePoint left = between(c[0], c[2], p.eta), right = between(c[1], c[3], p.eta);
    const double s_xi = right.s - left.s, x_xi = right.x - left.x, s_eta = high.s - low.s,
                 x_eta = high.x - low.x;
    const double determinant = s_xi * x_eta - s_eta * x_xi;
    const double ds = place.s - at.s, dx = place.x - at.x;
    const double d_xi = (ds * x_eta - s_eta * dx) / determinant,
                 d_eta = (s_xi * dx - ds * x_xi) / determinant;
    p.xi += d_xi;
    p.eta += d_eta;
    if (std::abs(d_xi) + std::abs(d_eta) < face_change)
      break;
  }
  return p;
}

// Gauss-Legendre, 5 points on 0 .. 1 (Abramowitz & Stegun, table 25.4): exact for shapes of degree 4 on a
// side times the rotating frame's first terms.
constexpr std::array<double, 5> gauss_point = {0.046910077030668, 0.230765344947158, 0.5, 0.769234655052842,
                                               0.953089922969332};
constexpr std::array<double, 5> gauss_weight = {0.118463442528095, 0.239314335249683, 0.284444444444444,
                                                0.239314335249683, 0.118463442528095};

} // namespace

Vector3 ContactSurface::swept_of(const Vector3& p) const {
  if (radius_ == 0)
    return p;
  const double side = std::copysign(1.0, radius_), out = side * (p[2] + radius_); // away from the axle
  double theta = std::atan2(p[0], out); // half of the body lies at 0 .. pi: both ends well inside the branch
  if (theta < -0.5 * std::numbers::pi)
    theta += 2 * std::numbers::pi;
  return {std::abs(radius_) * theta, p[1], side * std::hypot(p[0], out) - radius_};
}

Vector3 ContactSurface::from_swept(const Vector3& swept) const {
  if (radius_ == 0)
    return swept;
  const double theta = swept[0] / radius_, r = radius_ + swept[2];
  return {r * std::sin(theta), swept[1], r * std::cos(theta) - radius_};
}

SurfacePoint ContactSurface::nearest(const Vector3& point) const {
  const Vector3 swept = swept_of(point);
  return {curve_.nearest({swept[1], swept[2]}).s, swept[0]};
}

Vector3 ContactSurface::position(SurfacePoint place) const {
  const Point2 p = curve_.at(std::clamp(place.s, curve_.s_begin(), curve_.s_end())).position;
  return from_swept({place.x, p.y, p.z});
}

std::array<Vector3, 3> ContactSurface::frame(SurfacePoint place) const {
  const double delta = curve_.at(std::clamp(place.s, curve_.s_begin(), curve_.s_end())).delta;
  const Point2 s = tangent_of(delta), n = normal_of(delta);
  const double theta = radius_ != 0 ? place.x / radius_ : 0, c = std::cos(theta), d = std::sin(theta);
  return {{{c, 0, -d}, {s.z * d, s.y, s.z * c}, {n.z * d, n.y, n.z * c}}};
}

void for_each_common_point(const std::array<SurfacePoint, 4>& corner, const SurfacePatch& patch,
                           const std::function<void(const FacePoint&)>& visit) {
  const auto [s_low, s_high] = std::minmax({corner[0].s, corner[1].s, corner[2].s, corner[3].s});
  const auto [x_low, x_high] = std::minmax({corner[0].x, corner[1].x, corner[2].x, corner[3].x});
  if (s_low >= patch.s_to || s_high <= patch.s_from || x_low >= patch.x_to || x_high <= patch.x_from)
    return;
  Polygon common{corner[0], corner[1], corner[3], corner[2]};
  common = clip(common, [&](SurfacePoint p) { return p.s - patch.s_from; });
  common = clip(common, [&](SurfacePoint p) { return patch.s_to - p.s; });
  common = clip(common, [&](SurfacePoint p) { return p.x - patch.x_from; });
  common = clip(common, [&](SurfacePoint p) { return patch.x_to - p.x; });
  for (std::size_t i = 2; i < common.size(); ++i) {
    const double area = std::abs(twice_area(common[0], common[i - 1], common[i]));
    if (area < smallest_part * patch.area())
      continue;
    for (std::size_t u = 0; u < 5; ++u) // a square collapsed onto the triangle
      for (std::size_t v = 0; v < 5; ++v) {
        const SurfacePoint far = between(common[i - 1], common[i], gauss_point[v]);
        visit(inverse(corner, between(common[0], far, gauss_point[u]),
                      area * gauss_point[u] * gauss_weight[u] * gauss_weight[v]));
      }
  }
}

} // namespace bem_contact::fem
