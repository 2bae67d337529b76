#include "meshes/outline.hpp"

#include "bem_contact/base/error.hpp"
#include "meshes/sampled_span.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>

namespace bem_contact::meshes {

namespace {

/// mm. Distance of the places where the body's thickness is measured.
constexpr double ray_step = 0.5;
/// 1 (cosine between the sides). Only an opposite side counts as the other side of a thin part: the neighbour
/// at a corner is no reason for small elements.
constexpr double opposite_side = -0.8;
/// 1 (sine). A side that is this parallel to a ray is not hit by it.
constexpr double parallel_side = 1e-12;

struct Candidate {
  double size;
  Point2 place;
};

struct Segment {
  Point2 from, to;
};

std::vector<Segment> polygon(const std::vector<Span>& spans) {
  std::vector<Segment> segments;
  for (const auto& span : spans) {
    Point2 last = span.samples.front().position;
    for (std::size_t i = 1; i < span.samples.size(); ++i)
      if (norm(span.samples[i].position - last) >= ray_step || i + 1 == span.samples.size()) {
        segments.push_back({last, span.samples[i].position});
        last = span.samples[i].position;
      }
  }
  return segments;
}

/// Half of the thickness of the body behind each place of the outline.
std::vector<Candidate> thickness_candidates(const std::vector<Segment>& outline) {
  std::vector<Candidate> candidates;
  for (const auto& a : outline) {
    const Point2 along = a.to - a.from;
    if (!(norm(along) > 0))
      continue;
    const Point2 tangent = (1 / norm(along)) * along, inward{-tangent.z, tangent.y};
    const Point2 origin = 0.5 * (a.from + a.to);
    double nearest = std::numeric_limits<double>::infinity();
    bool is_opposite = false;
    for (const auto& b : outline) {
      const Point2 side = b.to - b.from;
      const double determinant = cross(inward, side);
      if (std::abs(determinant) < parallel_side * norm(side))
        continue;
      const double distance = cross(b.from - origin, side) / determinant;
      const double position = cross(b.from - origin, inward) / determinant;
      if (distance > coinciding && distance < nearest && position >= 0 && position <= 1) {
        nearest = distance;
        is_opposite = dot(tangent, side) < opposite_side * norm(side);
      }
    }
    if (is_opposite)
      candidates.push_back({nearest / 2, origin});
  }
  return candidates;
}

void add_geometry(SizeField& size, const std::vector<Span>& spans, double edge_angle) {
  std::vector<Candidate> candidates = thickness_candidates(polygon(spans));
  for (const auto& span : spans)
    if (span.group != Group::contact)
      for (std::size_t i = 0; i < span.samples.size(); ++i)
        if (const double curvature = curvature_at(span, i); curvature > 0)
          candidates.push_back({edge_angle / curvature, span.samples[i].position});
  std::sort(candidates.begin(), candidates.end(), [](auto& a, auto& b) { return a.size < b.size; });
  for (const auto& c : candidates)
    if (size(c.place) > size_excess * c.size)
      size.add(c.size, {c.place});
}

std::vector<OutlineVertex> divide_strip(const Span& span, int edges) {
  const Piece& strip = *span.pieces.front();
  std::vector<OutlineVertex> vertices;
  for (int i = 0; i < edges; ++i)
    vertices.push_back({strip.at(strip.from + (strip.to - strip.from) * i / edges), span.group,
                        strip.at(strip.from + (strip.to - strip.from) * (i + 0.5) / edges)});
  return vertices;
}

/// Vertices of a span but its last one; their number is even, or odd where `odd`.
std::vector<OutlineVertex> divide_span(const Span& span, const SizeField& size, bool odd) {
  std::vector<double> edges_before{0};
  for (std::size_t i = 1; i < span.samples.size(); ++i) {
    const Point2 a = span.samples[i - 1].position, b = span.samples[i].position;
    edges_before.push_back(edges_before.back() + norm(b - a) / size(0.5 * (a + b)));
  }
  const double total = edges_before.back();
  const int least = span.closed ? 8 : 2;
  int count = std::max(least, static_cast<int>(std::ceil(total)));
  count += (count % 2 == 1) != odd ? 1 : 0;
  const auto at = [&](double edges_along) {
    const double target = total * edges_along / count;
    const auto after = std::upper_bound(edges_before.begin() + 1, edges_before.end() - 1, target);
    const auto k = static_cast<std::size_t>(after - edges_before.begin());
    const double part =
        std::clamp((target - edges_before[k - 1]) / (edges_before[k] - edges_before[k - 1]), 0.0, 1.0);
    return point_between(span, k - 1, part);
  };
  std::vector<OutlineVertex> vertices;
  for (int i = 0; i < count; ++i)
    vertices.push_back({at(i), span.group, at(i + 0.5)});
  return vertices;
}

/// The last edge of an odd strip shares a coarse edge with what follows, which a corner does not allow.
void refuse_odd_strip_at_corner(const Section& section, int strip_edges) {
  const Loop& loop = section.loops.front();
  if (strip_edges % 2 == 1 && corner_between(loop[0], loop[1]))
    throw InputError(
        fmt::format("The strip of {} ends at a corner after {} element edges", section.name, strip_edges),
        "up to a corner their number must be even",
        "Make [mesh] elements_per_station even, or end the strip before the corner.");
}

} // namespace

double area(const VertexLoop& loop) {
  double twice = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    twice += cross(loop[i].position, loop[(i + 1) % loop.size()].position);
  return twice / 2;
}

Outline divide(const Section& section, int strip_edges, const BodyFile::Mesh& mesh, double edge_angle) {
  refuse_odd_strip_at_corner(section, strip_edges);
  std::vector<std::vector<Span>> loops;
  std::vector<Span> all;
  for (const auto& loop : section.loops) {
    loops.push_back(sample_spans(loop));
    all.insert(all.end(), loops.back().begin(), loops.back().end());
  }
  const auto strip = divide_strip(all.front(), strip_edges);
  std::vector<Point2> places{all.front().samples.back().position};
  for (const auto& vertex : strip)
    places.push_back(vertex.position);

  Outline outline{{}, SizeField(mesh.largest, mesh.grading)};
  const Piece& piece = section.loops.front().front();
  outline.size.add((piece.to - piece.from) / strip_edges, places);
  add_geometry(outline.size, all, edge_angle);

  bool odd = false;
  for (const auto& spans : loops) {
    VertexLoop loop;
    for (const auto& span : spans) {
      const auto vertices = span.group == Group::contact ? strip : divide_span(span, outline.size, odd);
      odd = vertices.size() % 2 == 1 && !odd;
      loop.insert(loop.end(), vertices.begin(), vertices.end());
    }
    outline.loops.push_back(std::move(loop));
  }
  return outline;
}

namespace {

struct Edge {
  Point2 from, to;
  std::size_t loop, index, loop_size;
};

bool cross_or_touch(const Edge& a, const Edge& b) {
  const auto apart = [](double p, double q, double r, double s) {
    return std::max(p, q) < std::min(r, s) || std::max(r, s) < std::min(p, q);
  };
  if (apart(a.from.y, a.to.y, b.from.y, b.to.y) || apart(a.from.z, a.to.z, b.from.z, b.to.z))
    return false;
  const Point2 u = a.to - a.from, v = b.to - b.from;
  return cross(u, b.from - a.from) * cross(u, b.to - a.from) <= 0 &&
         cross(v, a.from - b.from) * cross(v, a.to - b.from) <= 0;
}

/// Whether p lies within a loop: how often the loop winds around it.
bool within(const VertexLoop& loop, Point2 p) {
  double turn = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point2 a = loop[i].position - p, b = loop[(i + 1) % loop.size()].position - p;
    turn += angle_from_to(a, b);
  }
  return std::abs(turn) > std::numbers::pi;
}

/// Loops that do not cross: holes lie within the outer loop and outside each other.
void refuse_misplaced_holes(const std::vector<VertexLoop>& loops, const std::string& name) {
  for (std::size_t hole = 0; hole < loops.size(); ++hole)
    for (std::size_t other = 0; other < loops.size(); ++other) {
      const bool other_is_outer = area(loops[other]) > 0;
      const Point2 p = loops[hole].front().position;
      if (hole != other && area(loops[hole]) < 0 && within(loops[other], p) != other_is_outer)
        throw InputError(fmt::format("A hole of {} lies {}", name,
                                     other_is_outer ? "outside the body" : "in another hole"),
                         fmt::format("near y = {:.3f}, z = {:.3f} mm", p.y, p.z), "Move or remove it.");
    }
}

} // namespace

void refuse_crossings(const Outline& outline, const std::string& name) {
  std::vector<Edge> edges;
  for (std::size_t l = 0; l < outline.loops.size(); ++l)
    for (std::size_t i = 0, n = outline.loops[l].size(); i < n; ++i)
      edges.push_back({outline.loops[l][i].position, outline.loops[l][(i + 1) % n].position, l, i, n});
  for (std::size_t a = 0; a < edges.size(); ++a)
    for (std::size_t b = a + 1; b < edges.size(); ++b) {
      const std::size_t apart = edges[b].index - edges[a].index;
      if (edges[a].loop == edges[b].loop && (apart == 1 || apart + 1 == edges[a].loop_size))
        continue;
      if (cross_or_touch(edges[a], edges[b]))
        throw InputError(fmt::format("The outline of {} crosses itself", name),
                         fmt::format("near y = {:.3f}, z = {:.3f} mm", edges[a].from.y, edges[a].from.z),
                         "Check the profile and the body's dimensions.");
    }
  refuse_misplaced_holes(outline.loops, name);
}

} // namespace bem_contact::meshes
