#include "fem_influence/harmonic/section_mesh.hpp"

#include "bem_contact/base/error.hpp"
#include "fem_influence/shared/curved_outline.hpp"
#include "fem_influence/shared/points.hpp"
#include "fem_influence/shared/read_msh.hpp"
#include "fem_influence/shared/settings.hpp"

#include <deal.II/grid/manifold.h>
#include <deal.II/grid/tria.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace bem_contact::fem {

namespace {

/// 1, of a station's width. A vertex of the mesh that is nearer to the border of two stations lies on it. It
/// must be far below the size of an element after all halvings (1/16 of a station by default).
constexpr double border_distance = 1e-3;

void require_groups(const dealii::Triangulation<2>& mesh, const std::filesystem::path& path) {
  bool contact = false, held = false;
  for (const auto& face : mesh.active_face_iterators())
    if (face->at_boundary()) {
      contact = contact || static_cast<int>(face->boundary_id()) == contact_id;
      held = held || static_cast<int>(face->boundary_id()) == held_id;
    }
  if (!contact || !held)
    throw InputError(
        "The mesh '" + path.string() + "' has no group '" +
            (contact ? "held' (physical curve 2)" : "contact' (physical curve 1)"),
        "loads and supports are found by the mesh's physical groups",
        "Make the mesh with mesh_body, or add the physical curves contact = 1, held = 2, free = 3.");
}

/// A mesh of another body, or in another frame, is told by its distance from the curve; the sagitta of a
/// chord is far smaller than a tenth of it.
void require_on_curve(Point2 a, Point2 b, const ProfileCurve& curve) {
  const Point2 middle = 0.5 * (a + b);
  const double off = norm(curve.nearest(middle).position - middle);
  if (off > settings::edge_off_profile * norm(b - a) + settings::on_profile)
    throw InputError("The mesh does not fit the profile '" + curve.name() + "'",
                     "an edge of the group 'contact' at (y, z) = (" + std::to_string(middle.y) + ", " +
                         std::to_string(middle.z) + ") lies " + std::to_string(off) + " mm off it",
                     "Mesh the body file that is used here.");
}

/// New points are means along the profile, or on one of the outline's other arcs.
class OnOutline : public dealii::Manifold<2> {
public:
  OnOutline(std::shared_ptr<const CurvedOutline> outline, CurvedOutline::Edge edge)
      : outline_(std::move(outline)), edge_(edge) {}
  std::unique_ptr<dealii::Manifold<2>> clone() const override { return std::make_unique<OnOutline>(*this); }
  dealii::Point<2> get_new_point(const dealii::ArrayView<const dealii::Point<2>>& points,
                                 const dealii::ArrayView<const double>& weights) const override {
    std::vector<Point2> from;
    for (const auto& p : points)
      from.push_back(plain(p));
    const Point2 p = outline_->mean(edge_, from, {weights.data(), weights.size()});
    return {p.y, p.z};
  }

private:
  std::shared_ptr<const CurvedOutline> outline_;
  CurvedOutline::Edge edge_;
};

bool on_strip(const dealii::TriaIterator<dealii::CellAccessor<2>>& cell, unsigned face) {
  return cell->at_boundary(face) && static_cast<int>(cell->face(face)->boundary_id()) == contact_id;
}

/// Checks the strip's edges and curves those of the outline.
void curve_edges(dealii::Triangulation<2>& mesh, const std::filesystem::path& path,
                 const ProfileCurve& curve) {
  using Edge = CurvedOutline::Edge;
  constexpr dealii::types::manifold_id profile_manifold = 1, arc_manifold = 2;
  const auto outline = std::make_shared<const CurvedOutline>(curve, path);
  for (const auto& cell : mesh.active_cell_iterators())
    for (const auto f : cell->face_indices())
      if (cell->at_boundary(f)) {
        const Point2 a = plain(cell->face(f)->vertex(0)), b = plain(cell->face(f)->vertex(1));
        if (on_strip(cell, f))
          require_on_curve(a, b, curve);
        // Straight edges next to the strip would be felt on it: all of the profile is curved.
        const Edge edge = on_strip(cell, f) ? Edge::profile : outline->edge(a, b);
        if (edge != Edge::straight)
          cell->face(f)->set_manifold_id(edge == Edge::profile ? profile_manifold : arc_manifold);
      }
  mesh.set_manifold(profile_manifold, OnOutline(outline, Edge::profile));
  mesh.set_manifold(arc_manifold, OnOutline(outline, Edge::arc));
}

void refine(dealii::Triangulation<2>& mesh, const ProfileCurve& curve, const BodyFile::Strip& strip,
            Refinement refinement) {
  const auto at_border = [&](const dealii::Point<2>& vertex) {
    const double station = (curve.nearest(plain(vertex)).s - strip.from) / strip.station_width;
    return std::abs(station - std::round(station)) < border_distance;
  };
  for (int level = 0; level < refinement.borders; ++level) {
    // All cells around a border: those off the strip and those with a corner there feel the jump as well.
    std::vector<char> border(mesh.n_vertices(), 0);
    for (const auto& cell : mesh.active_cell_iterators())
      for (const auto f : cell->face_indices())
        if (on_strip(cell, f))
          for (const auto v : cell->face(f)->vertex_indices())
            border[cell->face(f)->vertex_index(v)] = at_border(cell->face(f)->vertex(v));
    for (const auto& cell : mesh.active_cell_iterators())
      for (const auto v : cell->vertex_indices())
        if (border[cell->vertex_index(v)])
          cell->set_refine_flag();
    mesh.execute_coarsening_and_refinement();
  }
}

} // namespace

void make_section_mesh(dealii::Triangulation<2, 2>& mesh, const std::filesystem::path& path,
                       const ProfileCurve& curve, const BodyFile::Strip& strip, Refinement refinement) {
  read_msh<2>(mesh, path);
  require_groups(mesh, path);
  curve_edges(mesh, path, curve);
  refine(mesh, curve, strip, refinement);
}

} // namespace bem_contact::fem
