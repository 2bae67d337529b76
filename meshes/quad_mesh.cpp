#include "meshes/quad_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace bem_contact::meshes {
namespace {

/// 1 (scaled Jacobian). Vertices of quads below it also try places to all sides.
constexpr double mediocre_quality = 0.6;
/// 1 (scaled Jacobian). A vertex moves only where it gains more: rounding.
constexpr double least_gain = 1e-6;

double area(const std::array<Point2, 4>& q) {
  return cross(q[2] - q[0], q[3] - q[1]) / 2;
}

std::array<Point2, 4> corners(const QuadMesh& mesh, std::size_t quad) {
  std::array<Point2, 4> q;
  for (std::size_t c = 0; c < 4; ++c)
    q[c] = mesh.points[static_cast<std::size_t>(mesh.quads[quad][c])];
  return q;
}

/// Vertices on the middles of edges, made when first asked for.
class EdgeMiddles {
public:
  explicit EdgeMiddles(std::vector<Point2>& points) : points_(points) {}
  void set(int a, int b, int middle) { middles_[std::minmax(a, b)] = middle; }
  int of(int a, int b) {
    const auto [at, is_new] = middles_.try_emplace(std::minmax(a, b), static_cast<int>(points_.size()));
    if (is_new)
      points_.push_back(0.5 * (points_[static_cast<std::size_t>(a)] + points_[static_cast<std::size_t>(b)]));
    return at->second;
  }

private:
  std::vector<Point2>& points_;
  std::map<std::pair<int, int>, int> middles_;
};

/// Quads around each vertex, and its neighbours along edges.
struct Neighbours {
  std::vector<std::vector<std::size_t>> quads;
  std::vector<std::vector<std::size_t>> vertices;
};

Neighbours neighbours(const QuadMesh& mesh) {
  Neighbours n{std::vector<std::vector<std::size_t>>(mesh.points.size()),
               std::vector<std::vector<std::size_t>>(mesh.points.size())};
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
    for (std::size_t c = 0; c < 4; ++c) {
      const auto v = static_cast<std::size_t>(mesh.quads[q][c]);
      n.quads[v].push_back(q);
      n.vertices[v].push_back(static_cast<std::size_t>(mesh.quads[q][(c + 1) % 4])); // each edge once a side
    }
  return n;
}

double worst_around(const QuadMesh& mesh, const std::vector<std::size_t>& quads) {
  double worst = 1;
  for (const auto q : quads)
    worst = std::min(worst, scaled_jacobian(mesh, q));
  return worst;
}

/// Tries places around a vertex, keeps the best one.
void improve(QuadMesh& mesh, std::size_t vertex, const Neighbours& n) {
  Point2 mean{};
  double reach = std::numeric_limits<double>::infinity();
  const Point2 start = mesh.points[vertex];
  for (const auto v : n.vertices[vertex]) {
    mean = mean + (1.0 / static_cast<double>(n.vertices[vertex].size())) * mesh.points[v];
    reach = std::min(reach, norm(mesh.points[v] - start));
  }
  double best = worst_around(mesh, n.quads[vertex]);
  Point2 kept = start;
  const auto attempt = [&](Point2 place) {
    mesh.points[vertex] = place;
    const double quality = worst_around(mesh, n.quads[vertex]);
    if (quality > best + least_gain) {
      best = quality;
      kept = place;
    }
  };
  for (const double part : {1.0, 0.5, 0.25})
    attempt(start + part * (mean - start));
  if (best < mediocre_quality)
    for (int direction = 0; direction < 8; ++direction)
      for (const double step : {0.2, 0.05})
        attempt(kept + step * reach * tangent_of(direction * std::atan(1.0)));
  mesh.points[vertex] = kept;
}

} // namespace

QuadMesh split(const CoarseMesh& coarse, const Outline& outline) {
  QuadMesh mesh;
  std::vector<int> index; // of the coarse points in the mesh
  for (const auto& loop : outline.loops) {
    const int first = static_cast<int>(mesh.points.size()), n = static_cast<int>(loop.size());
    for (int i = 0; i < n; ++i) {
      const auto& vertex = loop[static_cast<std::size_t>(i)];
      if (i % 2 == 0)
        index.push_back(first + i);
      mesh.points.push_back(vertex.position);
      mesh.boundary.push_back({{first + i, first + (i + 1) % n}, vertex.group, vertex.halfway});
    }
  }
  EdgeMiddles middles(mesh.points);
  for (std::size_t e = 0; e + 1 < mesh.boundary.size(); e += 2)
    middles.set(mesh.boundary[e].vertices[0], mesh.boundary[e + 1].vertices[1], mesh.boundary[e].vertices[1]);
  for (std::size_t i = index.size(); i < coarse.points.size(); ++i) {
    index.push_back(static_cast<int>(mesh.points.size()));
    mesh.points.push_back(coarse.points[i]);
  }

  for (const auto& cell : coarse.cells) {
    std::vector<int> vertices;
    for (const int c : cell)
      if (c >= 0)
        vertices.push_back(index[static_cast<std::size_t>(c)]);
    const auto at = [&](std::size_t i) { return mesh.points[static_cast<std::size_t>(vertices[i])]; };
    if (cross(at(1) - at(0), at(2) - at(0)) +
            (vertices.size() == 4 ? cross(at(2) - at(0), at(3) - at(0)) : 0) <
        0)
      std::reverse(vertices.begin(), vertices.end());
    const std::size_t n = vertices.size();
    Point2 mean{};
    for (std::size_t i = 0; i < n; ++i)
      mean = mean + (1.0 / static_cast<double>(n)) * at(i);
    const int centre = static_cast<int>(mesh.points.size());
    mesh.points.push_back(mean);
    for (std::size_t i = 0; i < n; ++i)
      mesh.quads.push_back({vertices[i], middles.of(vertices[i], vertices[(i + 1) % n]), centre,
                            middles.of(vertices[(i + n - 1) % n], vertices[i])});
  }
  return mesh;
}

double scaled_jacobian(const std::array<Point2, 4>& q) {
  double smallest = 1;
  for (std::size_t c = 0; c < 4; ++c) {
    const Point2 a = q[(c + 1) % 4] - q[c], b = q[(c + 3) % 4] - q[c];
    const double lengths = norm(a) * norm(b);
    smallest = std::min(smallest, lengths > 0 ? cross(a, b) / lengths : 0);
  }
  return smallest;
}

double scaled_jacobian(const QuadMesh& mesh, std::size_t quad) {
  return scaled_jacobian(corners(mesh, quad));
}

void smooth(QuadMesh& mesh, int sweeps) {
  const Neighbours n = neighbours(mesh);
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (std::size_t v = mesh.boundary.size(); v < mesh.points.size(); ++v)
      improve(mesh, v, n);
}

Quality quality(const QuadMesh& mesh) {
  Quality result;
  result.quads = mesh.quads.size();
  result.smallest = 1;
  result.shortest_edge = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < mesh.quads.size(); ++k) {
    const auto q = corners(mesh, k);
    const double jacobian = scaled_jacobian(q);
    result.mean += jacobian / static_cast<double>(mesh.quads.size());
    if (jacobian < result.smallest) {
      result.smallest = jacobian;
      result.worst = 0.25 * (q[0] + q[1] + q[2] + q[3]);
    }
    result.area += area(q);
    for (std::size_t c = 0; c < 4; ++c) {
      const double edge = norm(q[(c + 1) % 4] - q[c]);
      result.shortest_edge = std::min(result.shortest_edge, edge);
      result.longest_edge = std::max(result.longest_edge, edge);
    }
  }
  return result;
}

} // namespace bem_contact::meshes
