#include "fem_influence/shared/curved_outline.hpp"

#include "fem_influence/shared/settings.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

namespace bem_contact::fem {

namespace {

/// 1, of the edge's length. Two vertices that are nearer are one (the ends of an arc that mesh_body names).
constexpr double same_vertex = 1e-6;

Arc through(Point2 a, Point2 h, Point2 b) {
  const Point2 u = h - a, v = b - a;
  const double twice = 2 * (u.y * v.z - u.z * v.y), uu = dot(u, u), vv = dot(v, v);
  const Point2 centre = a + (1 / twice) * Point2{v.z * uu - u.z * vv, u.y * vv - v.y * uu};
  return {a, b, centre, norm(a - centre)};
}

std::vector<Arc> arcs_named_in(const std::filesystem::path& mesh) {
  std::ifstream in(mesh);
  std::vector<Arc> arcs;
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("curved edges,")) {
      Point2 a, h, b;
      while (in >> a.y >> a.z >> h.y >> h.z >> b.y >> b.z)
        if (const Arc arc = through(a, h, b); std::isfinite(arc.radius))
          arcs.push_back(arc);
      return arcs;
    }
  return arcs;
}

} // namespace

CurvedOutline::CurvedOutline(ProfileCurve curve, const std::filesystem::path& mesh)
    : curve_(std::move(curve)), arcs_(arcs_named_in(mesh)) {}

bool CurvedOutline::along_profile(Point2 a, Point2 b) const {
  const Point2 middle = 0.5 * (a + b);
  const auto off = [&](Point2 p) { return norm(curve_.nearest(p).position - p); };
  return off(a) < settings::on_profile && off(b) < settings::on_profile &&
         off(middle) < settings::edge_off_profile * norm(b - a);
}

CurvedOutline::Edge CurvedOutline::edge(Point2 a, Point2 b) const {
  if (along_profile(a, b))
    return Edge::profile;
  const double near = same_vertex * norm(b - a);
  const bool arc = std::any_of(arcs_.begin(), arcs_.end(), [&](const Arc& e) {
    return (norm(e.from - a) < near && norm(e.to - b) < near) ||
           (norm(e.from - b) < near && norm(e.to - a) < near);
  });
  return arc ? Edge::arc : Edge::straight;
}

Point2 CurvedOutline::mean(Edge edge, std::span<const Point2> points, std::span<const double> weights) const {
  switch (edge) {
  case Edge::profile:
    return mean_on_profile(points, weights);
  case Edge::arc:
    return mean_on_arc(points, weights);
  case Edge::straight:
    break;
  }
  Point2 sum;
  for (std::size_t i = 0; i < points.size(); ++i)
    sum = sum + weights[i] * points[i];
  return sum;
}

Point2 CurvedOutline::mean_on_profile(std::span<const Point2> points, std::span<const double> weights) const {
  const double first = curve_.nearest(points[0]).s, length = curve_.s_end() - curve_.s_begin();
  double s = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    double at = curve_.nearest(points[i]).s;
    if (std::abs(at - first) > length / 2) // a closed profile begins where it ends
      at += at < first ? length : -length;
    s += weights[i] * at;
  }
  s += s < curve_.s_begin() ? length : s > curve_.s_end() ? -length : 0;
  return curve_.at(std::clamp(s, curve_.s_begin(), curve_.s_end())).position;
}

Point2 CurvedOutline::mean_on_arc(std::span<const Point2> points, std::span<const double> weights) const {
  const Point2 middle = 0.5 * (points.front() + points.back());
  const auto off = [&](const Arc& arc) { // squared, from the chord
    const Point2 chord = arc.to - arc.from;
    const double t = std::clamp(dot(middle - arc.from, chord) / dot(chord, chord), 0.0, 1.0);
    const Point2 apart = arc.from + t * chord - middle;
    return dot(apart, apart);
  };
  const Arc& arc = *std::min_element(arcs_.begin(), arcs_.end(),
                                     [&](const Arc& a, const Arc& b) { return off(a) < off(b); });
  // Angles about the centre from the middle of the arc, where they do not jump.
  const Point2 across = 0.5 * (arc.from + arc.to) - arc.centre, axis = (1 / norm(across)) * across;
  double angle = 0, radius = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point2 p = points[i] - arc.centre;
    angle += weights[i] * std::atan2(axis.y * p.z - axis.z * p.y, dot(axis, p));
    radius += weights[i] * norm(p);
  }
  const double c = radius * std::cos(angle), s = radius * std::sin(angle);
  return {arc.centre.y + c * axis.y - s * axis.z, arc.centre.z + c * axis.z + s * axis.y};
}

} // namespace bem_contact::fem
