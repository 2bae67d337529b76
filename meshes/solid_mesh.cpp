#include "meshes/solid_mesh.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "meshes/section_mesh.hpp"
#include "meshes/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <utility>

namespace bem_contact::meshes {
namespace {

/// 1. Growth of the layers along x, over their distance from x = 0.
constexpr double layer_growth = 0.6;
/// 1. A last layer of less than this many steps is as long as what is left.
constexpr double last_layer = 1.5;
/// 1 (smallest scaled Jacobian). A coarse section this good ends the attempts.
constexpr double good_quality = 0.3;
/// rad. Of one layer of a wheel at most, which is a straight hexahedron.
constexpr double widest_sector = 20 * std::numbers::pi / 180;

/// The body with a strip of `bundle` stations an edge, an even number of edges, reaching over the one asked
/// for by whole stations; nothing where the profile is too short for it.
std::optional<BodyFile> bundled(const BodyFile& body, const ProfileCurve& curve, int bundle) {
  const double ds = body.strip.station_width;
  const int stations = body.strip.stations();
  const int edges = 2 * ((stations + 2 * bundle - 1) / (2 * bundle)), more = edges * bundle - stations;
  BodyFile coarse = body;
  coarse.strip.station_width = bundle * ds;
  coarse.mesh.elements_per_station = 1;
  for (const int before : {more / 2, more, 0}) {
    coarse.strip.from = body.strip.from - before * ds;
    coarse.strip.to = body.strip.to + (more - before) * ds;
    if (coarse.strip.from >= curve.s_begin() - profile_slack &&
        coarse.strip.to <= curve.s_end() + profile_slack)
      return coarse;
  }
  return std::nullopt;
}

BodyFile coarse_body(const BodyFile& body) {
  const ProfileCurve curve = body_profile(body);
  int bundle = 1;
  while (2 * bundle * body.strip.station_width <= body.solid.size)
    bundle *= 2;
  for (; bundle > 1; bundle /= 2)
    if (const auto coarse = bundled(body, curve, bundle))
      return *coarse;
  BodyFile fine = body;
  fine.mesh.elements_per_station = 1;
  return fine;
}

/// Coarse meshes of thin or strongly curved parts turn out well or badly by chance: several are tried.
QuadMesh coarse_section(BodyFile body) {
  std::optional<QuadMesh> best;
  double best_quality = 0;
  for (const double grading : coarse_gradings)
    try {
      body.mesh.grading = grading;
      QuadMesh mesh = mesh_section(body, body.solid.edge_angle * std::numbers::pi / 180);
      if (const double found = quality(mesh).smallest; found > best_quality) {
        best_quality = found;
        best = std::move(mesh);
      }
      if (best_quality >= good_quality)
        break;
    } catch (const InputError&) {
      throw;
    } catch (const Error&) { // too distorted
      if (!best && grading == coarse_gradings[std::size(coarse_gradings) - 1])
        throw;
    }
  return *best;
}

std::vector<double> layers_of(const BodyFile& body) {
  const double radius = reference_radius_of(body);
  const double length = half_period_of(body);
  const double longest = radius != 0 ? widest_sector * std::abs(radius) : length;
  double first = (body.solid.dx > 0 ? body.solid.dx : body.strip.station_width) / 2;
  if (4 * first > length)
    throw InputError(
        fmt::format("An element of {} mm is too long for a body of {} mm", 2 * first, 2 * length),
        "loads lie in its middle", "Lower solid.dx or raise harmonic.half_period.");
  while (2 * first <= std::min(body.solid.size, length / 2))
    first *= 2;
  std::vector<double> x{0, first};
  while (x.back() < length) {
    const double step = std::min(longest, std::max(first, layer_growth * x.back()));
    x.push_back(length - x.back() < last_layer * step ? length : x.back() + step);
  }
  return x;
}

} // namespace

SolidMesh mesh_solid(const BodyFile& body) {
  SolidMesh mesh;
  mesh.body_digest = mesh_digest(body, body_profile(body).digest());
  mesh.section = coarse_section(coarse_body(body));
  mesh.layers = layers_of(body);
  const QuadMesh& section = mesh.section;
  mesh.name = section.name;
  const double radius = reference_radius_of(body);
  for (const double x : mesh.layers)
    for (const Point2 p : section.points) {
      const double angle = radius != 0 ? x / radius : 0, r = radius + p.z;
      mesh.points.push_back(radius != 0 ? Point3{r * std::sin(angle), p.y, r * std::cos(angle) - radius}
                                        : Point3{x, p.y, p.z});
    }
  const auto layer_size = static_cast<int>(section.points.size());
  const auto last = static_cast<int>(mesh.layers.size()) - 1;
  const auto at = [&](int layer, int vertex) { return layer * layer_size + vertex; };
  for (int layer = 0; layer < last; ++layer) {
    for (const auto& q : section.quads)
      mesh.hexahedra.push_back({at(layer, q[0]), at(layer, q[1]), at(layer, q[2]), at(layer, q[3]),
                                at(layer + 1, q[0]), at(layer + 1, q[1]), at(layer + 1, q[2]),
                                at(layer + 1, q[3])});
    for (const auto& edge : section.boundary) {
      const auto [a, b] = edge.vertices;
      mesh.faces.push_back(
          {{at(layer, a), at(layer, b), at(layer + 1, b), at(layer + 1, a)}, static_cast<int>(edge.group)});
    }
  }
  for (const int layer : {0, last})
    for (const auto& q : section.quads)
      mesh.faces.push_back(
          {{at(layer, q[0]), at(layer, q[1]), at(layer, q[2]), at(layer, q[3])}, symmetry_group});
  return mesh;
}

} // namespace bem_contact::meshes
