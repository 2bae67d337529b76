#include "fem_influence/solid/solid_body.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/output_file.hpp"
#include "fem_influence/shared/curved_outline.hpp"
#include "fem_influence/shared/section.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/fe/mapping_q_cache.h>
#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/manifold.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/data_out.h>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace bem_contact::fem {

namespace {

constexpr int symmetry_id = 4;
constexpr dealii::types::manifold_id profile_manifold = 1, swept_manifold = 2, arc_manifold = 3;

Vector3 plain(const dealii::Point<3>& p) {
  return {p[0], p[1], p[2]};
}
dealii::Point<3> point(const Vector3& p) {
  return {p[0], p[1], p[2]};
}

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
      const std::span weight(weights.data(), weights.size());
      const Point2 p = edge_ == CurvedOutline::Edge::profile ? outline_->mean_on_profile(places, weight)
                                                             : outline_->mean_on_arc(places, weight);
      mean = {mean[0], p.y, p.z};
    }
    return point(surface_->from_swept(mean));
  }

private:
  std::shared_ptr<const ContactSurface> surface_;
  std::shared_ptr<const CurvedOutline> outline_;
  CurvedOutline::Edge edge_;
};

void read_mesh(dealii::Triangulation<3>& mesh, const std::filesystem::path& path) {
  std::ifstream in(path);
  if (!in || std::filesystem::is_directory(path))
    throw InputError("The mesh file '" + path.string() + "' cannot be read", "no readable file has that name",
                     "make it with mesh_body --solid, or correct the path");
  try {
    dealii::GridIn<3> reader(mesh);
    reader.read_msh(in);
  } catch (const std::exception& error) {
    throw InputError("The mesh '" + path.string() + "' is not a gmsh mesh of hexahedra",
                     "deal.II refuses it: " + short_reason(error),
                     "make it with mesh_body --solid, or of first-order hexahedra alone");
  }
  if (mesh.n_active_cells() == 0 || !mesh.all_reference_cells_are_hyper_cube())
    throw InputError("The mesh '" + path.string() + "' has cells that are not hexahedra",
                     "the elements are tensor products: tetrahedra, wedges and pyramids are not served",
                     "recombine all cells, or use mesh_body --solid");
}

void check_groups(const dealii::Triangulation<3>& mesh, const ContactSurface& surface,
                  const std::string& name) {
  bool contact = false, held = false, mirror = false;
  for (const auto& face : mesh.active_face_iterators()) {
    if (!face->at_boundary())
      continue;
    const auto id = static_cast<int>(face->boundary_id());
    const double size = face->diameter();
    held = held || id == held_id;
    if (id == contact_id) {
      contact = true;
      for (const auto v : face->vertex_indices()) {
        const Vector3 p = plain(face->vertex(v)), on = surface.position(surface.nearest(p));
        if (const double off = face->vertex(v).distance(point(on)); off > 1e-3 * size)
          throw InputError(
              "The mesh '" + name + "' does not fit the profile '" + surface.curve().name() + "'",
              "a vertex of the group 'contact' at (" + std::to_string(p[0]) + ", " + std::to_string(p[1]) +
                  ", " + std::to_string(p[2]) + ") lies " + std::to_string(off) + " mm off it",
              "put the body file's profile and the mesh into one frame: x along, z down");
      }
    }
    if (id == symmetry_id) {
      const double x = face->center()[0];
      mirror = mirror || std::abs(x) < 1e-6 * size;
      for (const auto v : face->vertex_indices())
        if (std::abs(face->vertex(v)[0] - x) > 1e-6 * size)
          throw InputError("A face of the group 'symmetry' of '" + name + "' is not normal to x",
                           "its corners lie at x = " + std::to_string(face->vertex(v)[0]) + " and around " +
                               std::to_string(x) + " mm",
                           "give the number 4 only to the planes the body is mirrored at");
    }
  }
  if (!contact || !held || !mirror)
    throw InputError("The mesh '" + name + "' has no group '" +
                         (!contact ? "contact' (physical surface 1)"
                          : !held  ? "held' (physical surface 2)"
                                   : "symmetry' (physical surface 4) at x = 0"),
                     "loads, supports and the mirror plane are found by the mesh's physical groups",
                     "make the mesh with mesh_body --solid, or add the physical surfaces contact = 1, "
                     "held = 2, free = 3, symmetry = 4");
}

double longest_edge(const dealii::Triangulation<3>::active_cell_iterator& cell) {
  double longest = 0;
  for (const auto l : cell->line_indices())
    longest = std::max(longest, cell->line(l)->diameter());
  return longest;
}

} // namespace

struct SolidBody::Impl {
  ContactSurface surface;
  dealii::Triangulation<3> coarse, mesh;
  dealii::FE_Q<3> element;
  dealii::DoFHandler<3> dofs;
  std::unique_ptr<dealii::MappingQCache<3>> mapping;
  NodeFlags flags;
  std::vector<std::size_t> master_begin;
  std::vector<NodeWeight> master;

  Impl(const ContactSurface& on, int degree) : surface(on), element(degree) {}

  /// What a face of the boundary off the mirror planes stands for, by one of its edges across x.
  CurvedOutline::Edge edge_of(const CurvedOutline& outline,
                              const dealii::Triangulation<3>::active_face_iterator& face) const {
    for (const auto l : face->line_indices()) {
      const Vector3 a = surface.swept_of(plain(face->line(l)->vertex(0))),
                    b = surface.swept_of(plain(face->line(l)->vertex(1)));
      if (std::abs(a[0] - b[0]) < 1e-6 * face->diameter())
        return outline.edge({a[1], a[2]}, {b[1], b[2]});
    }
    return CurvedOutline::Edge::straight;
  }

  void use_manifolds(const std::filesystem::path& path) {
    using Edge = CurvedOutline::Edge;
    const auto outline = std::make_shared<const CurvedOutline>(surface.curve(), path);
    const auto swept = std::make_shared<const ContactSurface>(surface);
    coarse.set_all_manifold_ids(surface.reference_radius() > 0 ? swept_manifold
                                                               : dealii::numbers::flat_manifold_id);
    // Not set_all_manifold_ids_on_boundary: it leaves out edges shared with another group, as those at x = 0.
    for (const auto& face : coarse.active_face_iterators()) {
      const auto group = static_cast<int>(face->boundary_id());
      if (!face->at_boundary() || group == symmetry_id)
        continue;
      const Edge edge = group == contact_id ? Edge::profile : edge_of(*outline, face);
      if (edge != Edge::straight)
        face->set_all_manifold_ids(edge == Edge::profile ? profile_manifold : arc_manifold);
    }
    coarse.set_manifold(profile_manifold, SweptManifold(swept, outline, Edge::profile));
    coarse.set_manifold(arc_manifold, SweptManifold(swept, outline, Edge::arc));
    coarse.set_manifold(swept_manifold, SweptManifold(swept, outline, Edge::straight));
  }

  void distribute() {
    const unsigned degree = std::max(2u, element.degree);
    mapping = std::make_unique<dealii::MappingQCache<3>>(degree);
    mapping->initialize(dealii::MappingQ<3>(degree), mesh);
    dofs.reinit(mesh);
    dofs.distribute_dofs(element);
    dealii::AffineConstraints<double> hanging;
    dealii::DoFTools::make_hanging_node_constraints(dofs, hanging);
    hanging.close();
    const std::size_t n = dofs.n_dofs();
    flags = {std::vector<char>(n, 0), std::vector<char>(n, 0), std::vector<char>(n, 0)};
    master.clear();
    master_begin.assign(1, 0);
    for (std::size_t i = 0; i < n; ++i) {
      if (hanging.is_constrained(i)) {
        flags.hanging[i] = 1;
        for (const auto& [j, weight] : *hanging.get_constraint_entries(i))
          master.push_back({static_cast<int>(j), weight});
      } else
        master.push_back({static_cast<int>(i), 1.0});
      master_begin.push_back(master.size());
    }
    std::vector<dealii::types::global_dof_index> on_face(element.n_dofs_per_face());
    for (const auto& cell : dofs.active_cell_iterators())
      for (const auto f : cell->face_indices())
        if (const auto id = static_cast<int>(cell->face(f)->boundary_id());
            cell->at_boundary(f) && (id == held_id || id == symmetry_id)) {
          cell->face(f)->get_dof_indices(on_face);
          for (const auto node : on_face)
            (id == held_id ? flags.held : flags.mirrored)[node] = 1;
        }
  }
};

SolidBody::SolidBody(const std::filesystem::path& path, const ContactSurface& surface, int degree)
    : impl_(std::make_unique<Impl>(surface, degree)) {
  read_mesh(impl_->coarse, path);
  check_groups(impl_->coarse, surface, path.string());
  impl_->use_manifolds(path);
}

SolidBody::~SolidBody() = default;

void SolidBody::refine(std::span<const SurfacePoint> loads, double load_radius, double smallest,
                       double grading, double reach) {
  auto& mesh = impl_->mesh;
  impl_->dofs.clear();
  mesh.clear();
  mesh.copy_triangulation(impl_->coarse);
  std::vector<dealii::Point<3>> centres;
  for (const SurfacePoint load : loads)
    centres.push_back(point(impl_->surface.position(load)));
  for (bool again = true; again;) {
    again = false;
    for (const auto& cell : mesh.active_cell_iterators()) {
      const double h = longest_edge(cell);
      double distance = std::numeric_limits<double>::max();
      for (const auto& centre : centres)
        distance = std::min(distance, cell->center().distance(centre));
      distance = std::max(0.0, distance - load_radius);
      if (h > 1.05 * (smallest + grading * distance + std::max(0.0, distance - reach))) {
        cell->set_refine_flag();
        again = true;
      }
    }
    if (again)
      mesh.execute_coarsening_and_refinement();
  }
  impl_->distribute();
}

std::size_t SolidBody::cell_count() const {
  return impl_->mesh.n_active_cells();
}
std::size_t SolidBody::node_count() const {
  return impl_->flags.held.size();
}
const NodeFlags& SolidBody::flags() const {
  return impl_->flags;
}
std::span<const NodeWeight> SolidBody::masters(int node) const {
  const auto i = static_cast<std::size_t>(node);
  return std::span(impl_->master)
      .subspan(impl_->master_begin[i], impl_->master_begin[i + 1] - impl_->master_begin[i]);
}

void SolidBody::for_each_cell(const std::function<void(const SolidCellView&)>& visit) const {
  using namespace dealii;
  const QGauss<3> rule(impl_->element.degree + 1);
  FEValues<3> values(*impl_->mapping, impl_->element, rule, update_gradients | update_JxW_values);
  const unsigned n = impl_->element.n_dofs_per_cell(), np = rule.size();
  std::vector<types::global_dof_index> indices(n);
  std::vector<int> nodes(n);
  std::vector<double> weight(np), gradient(3 * n * np);
  for (const auto& cell : impl_->dofs.active_cell_iterators()) {
    values.reinit(cell);
    cell->get_dof_indices(indices);
    nodes.assign(indices.begin(), indices.end());
    for (unsigned q = 0; q < np; ++q) {
      weight[q] = values.JxW(q);
      for (unsigned a = 0; a < n; ++a)
        for (unsigned c = 0; c < 3; ++c)
          gradient[3 * (q * n + a) + c] = values.shape_grad(a, q)[c];
    }
    visit({nodes, weight, gradient, plain(cell->center())});
  }
}

void SolidBody::for_each_contact_face(const std::function<void(const SolidFaceView&)>& visit) const {
  using namespace dealii;
  const auto& element = impl_->element;
  std::vector<types::global_dof_index> indices(element.n_dofs_per_cell());
  std::vector<int> nodes(element.n_dofs_per_cell());
  for (const auto& cell : impl_->dofs.active_cell_iterators())
    for (const auto f : cell->face_indices()) {
      if (!cell->at_boundary(f) || static_cast<int>(cell->face(f)->boundary_id()) != contact_id)
        continue;
      SolidFaceView face;
      std::array<Point<3>, 4> unit;
      for (unsigned v = 0; v < 4; ++v) { // by the cell's own vertices: a face may be turned
        const unsigned vertex = GeometryInfo<3>::face_to_cell_vertices(f, v);
        unit[v] = GeometryInfo<3>::unit_cell_vertex(vertex);
        face.corner[v] = impl_->surface.nearest(plain(cell->vertex(vertex)));
      }
      cell->get_dof_indices(indices);
      nodes.assign(indices.begin(), indices.end());
      face.nodes = nodes;
      face.shapes = [&](double xi, double eta, std::span<double> value) {
        const Point<3> at = unit[0] + xi * (unit[1] - unit[0]) + eta * (unit[2] - unit[0]);
        for (unsigned a = 0; a < value.size(); ++a)
          value[a] = element.shape_value(a, at);
      };
      visit(face);
    }
}

void SolidBody::write_vtu(const std::filesystem::path& file, std::span<const double> displacement) const {
  using namespace dealii;
  const FESystem<3> element(impl_->element, 3);
  DoFHandler<3> vectors(impl_->mesh);
  vectors.distribute_dofs(element);
  Vector<double> u(vectors.n_dofs());
  std::vector<types::global_dof_index> nodes(impl_->element.n_dofs_per_cell()),
      all(element.n_dofs_per_cell());
  auto scalar = impl_->dofs.begin_active();
  for (const auto& cell : vectors.active_cell_iterators()) {
    scalar->get_dof_indices(nodes);
    cell->get_dof_indices(all);
    for (unsigned i = 0; i < all.size(); ++i) {
      const auto [component, node] = element.system_to_component_index(i);
      u[all[i]] = displacement[3 * nodes[node] + component];
    }
    ++scalar;
  }
  DataOut<3> out;
  DataOutBase::VtkFlags flags;
  flags.write_higher_order_cells = true;
  out.set_flags(flags);
  using Interpretation = DataComponentInterpretation::DataComponentInterpretation;
  out.add_data_vector(
      vectors, u, std::vector<std::string>(3, "displacement_mm"),
      std::vector<Interpretation>(3, DataComponentInterpretation::component_is_part_of_vector));
  out.build_patches(*impl_->mapping, impl_->element.degree, DataOut<3>::curved_inner_cells);
  write_whole(file, [&](std::ostream& to) {
    try {
      out.write_vtu(to);
    } catch (const std::exception&) { // deal.II's message fills a page
      to.setstate(std::ios::badbit);
    }
  });
}

} // namespace bem_contact::fem
