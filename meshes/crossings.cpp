#include "meshes/crossings.hpp"

#include "bem_contact/base/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bem_contact::meshes {
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
        throw InputError(fmt::format("a hole of {} lies {}", name,
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
        throw InputError(fmt::format("the outline of {} crosses itself", name),
                         fmt::format("near y = {:.3f}, z = {:.3f} mm", edges[a].from.y, edges[a].from.z),
                         "Check the profile and the body's dimensions.");
    }
  refuse_misplaced_holes(outline.loops, name);
}

} // namespace bem_contact::meshes
