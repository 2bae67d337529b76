#include "fem_influence/solid/solid_body.hpp"

#include "bem_contact/base/output_file.hpp"
#include "fem_influence/shared/points.hpp"
#include "fem_influence/shared/read_msh.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/fe/mapping_q_cache.h>
#include <deal.II/grid/manifold.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/data_out.h>

#include <algorithm>

namespace bem_contact::fem {

struct SolidBody::Impl {
  ContactSurface surface;
  dealii::Triangulation<3> mesh;
  dealii::FE_Q<3> element;
  dealii::DoFHandler<3> dofs;
  dealii::MappingQCache<3> mapping;
  NodeFlags flags;
  std::vector<std::size_t> master_begin{0};
  std::vector<NodeWeight> master;

  Impl(const SolidMesh& of, int degree)
      : surface(of.surface()), element(degree), mapping(std::max(2u, element.degree)) {}

  void find_masters() {
    dealii::AffineConstraints<double> hanging;
    dealii::DoFTools::make_hanging_node_constraints(dofs, hanging);
    hanging.close();
    const std::size_t n = dofs.n_dofs();
    flags = {std::vector<char>(n, 0), std::vector<char>(n, 0), std::vector<char>(n, 0)};
    for (std::size_t i = 0; i < n; ++i) {
      if (hanging.is_constrained(i)) {
        flags.hanging[i] = 1;
        for (const auto& [j, weight] : *hanging.get_constraint_entries(i))
          master.push_back({static_cast<int>(j), weight});
      } else
        master.push_back({static_cast<int>(i), 1.0});
      master_begin.push_back(master.size());
    }
  }

  void find_held_and_mirrored() {
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

SolidBody::SolidBody(const SolidMesh& mesh, int degree, const SolidRefinement& refinement)
    : impl_(std::make_unique<Impl>(mesh, degree)) {
  refine(impl_->mesh, mesh, refinement);
  impl_->mapping.initialize(dealii::MappingQ<3>(std::max(2u, impl_->element.degree)), impl_->mesh);
  impl_->dofs.reinit(impl_->mesh);
  impl_->dofs.distribute_dofs(impl_->element);
  impl_->find_masters();
  impl_->find_held_and_mirrored();
}

SolidBody::~SolidBody() = default;

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
  FEValues<3> values(impl_->mapping, impl_->element, rule,
                     update_gradients | update_JxW_values | update_quadrature_points);
  const unsigned n = impl_->element.n_dofs_per_cell(), np = rule.size();
  std::vector<types::global_dof_index> indices(n);
  std::vector<int> nodes(n);
  std::vector<double> weight(np), gradient(3 * n * np);
  std::vector<Vector3> point(np);
  for (const auto& cell : impl_->dofs.active_cell_iterators()) {
    values.reinit(cell);
    cell->get_dof_indices(indices);
    nodes.assign(indices.begin(), indices.end());
    for (unsigned q = 0; q < np; ++q) {
      weight[q] = values.JxW(q);
      point[q] = plain(values.quadrature_point(q));
      for (unsigned a = 0; a < n; ++a)
        for (unsigned c = 0; c < 3; ++c)
          gradient[3 * (q * n + a) + c] = values.shape_grad(a, q)[c];
    }
    visit({nodes, weight, gradient, point, plain(cell->center())});
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
  out.build_patches(impl_->mapping, impl_->element.degree, DataOut<3>::curved_inner_cells);
  write_text(file, [&](std::ostream& to) {
    try {
      out.write_vtu(to);
    } catch (const std::exception&) { // deal.II's message fills a page
      to.setstate(std::ios::badbit);
    }
  });
}

} // namespace bem_contact::fem
