#include "fem_influence/solid/solid_mesh.hpp"

#include "bem_contact/base/error.hpp"
#include "fem_influence/shared/curved_outline.hpp"
#include "fem_influence/shared/points.hpp"
#include "fem_influence/shared/read_msh.hpp"
#include "fem_influence/shared/settings.hpp"

#include <deal.II/grid/manifold.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <string>
#include <vector>

namespace bem_contact::fem {

namespace {

/// 1, of the face's diameter. A vertex of the group 'contact' must not lie farther off the profile: other
/// programs may write meshes with a few digits. Not measured.
constexpr double vertex_off_profile = 1e-3;
/// 1, of the face's diameter. Vertices of one mirror plane have the same x, up to the digits of the file.
constexpr double same_plane = 1e-6;

/// New points are means in the swept section's coordinates: x, and (y, z) as they come, along the profile or
/// on one of the outline's other arcs.
class SweptManifold : public dealii::Manifold<3, 3> {
public:
  SweptManifold(std::shared_ptr<const ContactSurface> surface, std::shared_ptr<const CurvedOutline> outline,
                CurvedOutline::Edge edge)
      : surface_(std::move(surface)), outline_(std::move(outline)), edge_(edge) {}
  std::unique_ptr<dealii::Manifold<3, 3>> clone() const override {
    return std::make_unique<SweptManifold>(*this);
  }
  dealii::Point<3> get_new_point(const dealii::ArrayView<const dealii::Point<3>>& points,
                                 const dealii::ArrayView<const double>& weights) const override {
    std::vector<Point2> places;
    Vector3 mean{};
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vector3 swept = surface_->swept_of(plain(points[i]));
      for (std::size_t c = 0; c < 3; ++c)
        mean[c] += weights[i] * swept[c];
      places.push_back({swept[1], swept[2]});
    }
    if (edge_ != CurvedOutline::Edge::straight) {
      const Point2 p = outline_->mean(edge_, places, {weights.data(), weights.size()});
      mean = {mean[0], p.y, p.z};
    }
    return point(surface_->from_swept(mean));
  }

private:
  std::shared_ptr<const ContactSurface> surface_;
  std::shared_ptr<const CurvedOutline> outline_;
  CurvedOutline::Edge edge_;
};

using Face = dealii::Triangulation<3>::active_face_iterator;

void require_on_profile(const Face& face, const ContactSurface& surface, const std::string& name) {
  for (const auto v : face->vertex_indices()) {
    const Vector3 p = plain(face->vertex(v)), on = surface.position(surface.nearest(p));
    if (const double off = face->vertex(v).distance(point(on)); off > vertex_off_profile * face->diameter())
      throw InputError(
          "The mesh '" + name + "' does not fit the profile '" + surface.curve().name() + "'",
          fmt::format("a vertex of the group 'contact' at ({:g}, {:g}, {:g}) lies {:g} mm off it", p[0], p[1],
                      p[2], off),
          "Put the body file's profile and the mesh into one frame: x along, z down.");
  }
}

void require_across_x(const Face& face, const std::string& name) {
  const double x = face->center()[0];
  for (const auto v : face->vertex_indices())
    if (std::abs(face->vertex(v)[0] - x) > same_plane * face->diameter())
      throw InputError("A face of the group 'symmetry' of '" + name + "' is not normal to x",
                       fmt::format("its corners lie at x = {:g} and around {:g} mm", face->vertex(v)[0], x),
                       "Give the number 4 only to the planes the body is mirrored at.");
}

void check_groups(const dealii::Triangulation<3>& mesh, const ContactSurface& surface,
                  const std::string& name) {
  bool contact = false, held = false, mirror = false;
  for (const auto& face : mesh.active_face_iterators()) {
    if (!face->at_boundary())
      continue;
    const auto id = static_cast<int>(face->boundary_id());
    held = held || id == held_id;
    if (id == contact_id) {
      contact = true;
      require_on_profile(face, surface, name);
    }
    if (id == symmetry_id) {
      mirror = mirror || std::abs(face->center()[0]) < same_plane * face->diameter();
      require_across_x(face, name);
    }
  }
  if (!contact || !held || !mirror)
    throw InputError("The mesh '" + name + "' has no group '" +
                         (!contact ? "contact' (physical surface 1)"
                          : !held  ? "held' (physical surface 2)"
                                   : "symmetry' (physical surface 4) at x = 0"),
                     "loads, supports and the mirror plane are found by the mesh's physical groups",
                     "Make the mesh with mesh_body --solid, or add the physical surfaces contact = 1, "
                     "held = 2, free = 3, symmetry = 4.");
}

/// What a face of the boundary off the mirror planes stands for, by one of its edges across x.
CurvedOutline::Edge edge_of(const Face& face, const CurvedOutline& outline, const ContactSurface& surface) {
  for (const auto l : face->line_indices()) {
    const Vector3 a = surface.swept_of(plain(face->line(l)->vertex(0))),
                  b = surface.swept_of(plain(face->line(l)->vertex(1)));
    if (std::abs(a[0] - b[0]) < same_plane * face->diameter())
      return outline.edge({a[1], a[2]}, {b[1], b[2]});
  }
  return CurvedOutline::Edge::straight;
}

void use_manifolds(dealii::Triangulation<3>& coarse, const std::filesystem::path& path,
                   const ContactSurface& surface) {
  using Edge = CurvedOutline::Edge;
  constexpr dealii::types::manifold_id profile_manifold = 1, swept_manifold = 2, arc_manifold = 3;
  const auto outline = std::make_shared<const CurvedOutline>(surface.curve(), path);
  const auto swept = std::make_shared<const ContactSurface>(surface);
  coarse.set_all_manifold_ids(surface.reference_radius() != 0 ? swept_manifold
                                                              : dealii::numbers::flat_manifold_id);
  // Not set_all_manifold_ids_on_boundary: it leaves out edges shared with another group, as those at x = 0.
  for (const auto& face : coarse.active_face_iterators()) {
    const auto group = static_cast<int>(face->boundary_id());
    if (!face->at_boundary() || group == symmetry_id)
      continue;
    const Edge edge = group == contact_id ? Edge::profile : edge_of(face, *outline, surface);
    if (edge != Edge::straight)
      face->set_all_manifold_ids(edge == Edge::profile ? profile_manifold : arc_manifold);
  }
  coarse.set_manifold(profile_manifold, SweptManifold(swept, outline, Edge::profile));
  coarse.set_manifold(arc_manifold, SweptManifold(swept, outline, Edge::arc));
  coarse.set_manifold(swept_manifold, SweptManifold(swept, outline, Edge::straight));
}

double longest_edge(const dealii::Triangulation<3>::active_cell_iterator& cell) {
  double longest = 0;
  for (const auto l : cell->line_indices())
    longest = std::max(longest, cell->line(l)->diameter());
  return longest;
}

} // namespace

struct SolidMesh::Impl {
  ContactSurface surface;
  dealii::Triangulation<3> coarse;
};

SolidMesh::SolidMesh(const std::filesystem::path& path, const ContactSurface& surface)
    : impl_(new Impl{surface, {}}) {
  read_msh<3>(impl_->coarse, path);
  check_groups(impl_->coarse, surface, path.string());
  use_manifolds(impl_->coarse, path, surface);
}

SolidMesh::~SolidMesh() = default;

const ContactSurface& SolidMesh::surface() const {
  return impl_->surface;
}
const dealii::Triangulation<3, 3>& SolidMesh::triangulation() const {
  return impl_->coarse;
}

void refine(dealii::Triangulation<3, 3>& refined, const SolidMesh& mesh, const SolidRefinement& refinement) {
  refined.copy_triangulation(mesh.triangulation());
  std::vector<dealii::Point<3>> centres;
  for (const SurfacePoint load : refinement.loads)
    centres.push_back(point(mesh.surface().position(load)));
  for (bool again = true; again;) {
    again = false;
    for (const auto& cell : refined.active_cell_iterators()) {
      const double h = longest_edge(cell);
      double distance = std::numeric_limits<double>::max();
      for (const auto& centre : centres)
        distance = std::min(distance, cell->center().distance(centre));
      distance = std::max(0.0, distance - refinement.load_radius);
      const double allowed =
          refinement.smallest + refinement.grading * distance + std::max(0.0, distance - refinement.reach);
      if (h > settings::size_excess * allowed) {
        cell->set_refine_flag();
        again = true;
      }
    }
    if (again)
      refined.execute_coarsening_and_refinement();
  }
}

} // namespace bem_contact::fem
