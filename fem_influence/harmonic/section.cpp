#include "fem_influence/harmonic/section.hpp"

#include "fem_influence/shared/points.hpp"
#include "fem_influence/shared/read_msh.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/fe/mapping_q_cache.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/grid_tools_cache.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>

#include <algorithm>

namespace bem_contact::fem {

struct Section::Impl {
  dealii::Triangulation<2> mesh;
  dealii::FE_Q<2> element;
  dealii::DoFHandler<2> dofs;
  dealii::MappingQCache<2> mapping; // points on curved edges are dear to find
  dealii::AffineConstraints<double> hanging;
  std::vector<int> node; ///< of each degree of freedom of deal.II; -1: hangs on others
  std::vector<Point2> positions;
  std::vector<char> held;

  explicit Impl(int degree) : element(degree), mapping(static_cast<unsigned>(degree)) {}

  void number_nodes() {
    std::vector<dealii::Point<2>> points(dofs.n_dofs());
    dealii::DoFTools::map_dofs_to_support_points(mapping, dofs, points);
    node.assign(points.size(), -1);
    for (dealii::types::global_dof_index dof = 0; dof < points.size(); ++dof)
      if (!hanging.is_constrained(dof)) {
        node[dof] = static_cast<int>(positions.size());
        positions.push_back(plain(points[dof]));
      }
  }

  void find_held_nodes() {
    held.assign(positions.size(), 0);
    std::vector<dealii::types::global_dof_index> on_face(element.n_dofs_per_face());
    for (const auto& cell : dofs.active_cell_iterators())
      for (const auto f : cell->face_indices()) {
        if (!cell->at_boundary(f) || static_cast<int>(cell->face(f)->boundary_id()) != held_id)
          continue;
        cell->face(f)->get_dof_indices(on_face);
        for (const auto dof : on_face)
          if (node[dof] >= 0)
            held[static_cast<std::size_t>(node[dof])] = 1;
      }
  }
};

namespace {

/// A cell's nodes with those that hang replaced by what they hang on: shape a of the cell counts
/// weight[a][b] for node b.
struct CellNodes {
  std::vector<int> nodes;
  std::vector<std::vector<std::pair<std::size_t, double>>> weight; // [local shape]; empty: none hangs

  CellNodes(std::span<const dealii::types::global_dof_index> dofs,
            const dealii::AffineConstraints<double>& hanging, std::span<const int> number) {
    if (std::none_of(dofs.begin(), dofs.end(), [&](auto dof) { return hanging.is_constrained(dof); })) {
      for (const auto dof : dofs)
        nodes.push_back(number[dof]);
      return;
    }
    for (const auto dof : dofs) {
      auto& row = weight.emplace_back();
      if (!hanging.is_constrained(dof))
        row.emplace_back(local(number[dof]), 1.0);
      else
        for (const auto& [master, w] : *hanging.get_constraint_entries(dof))
          row.emplace_back(local(number[master]), w);
    }
  }
  /// values[point][shape] to values[point][node].
  std::vector<double> resolve(std::span<const double> values) const {
    if (weight.empty())
      return {values.begin(), values.end()};
    const std::size_t shapes = weight.size(), points = values.size() / shapes;
    std::vector<double> out(points * nodes.size(), 0.0);
    for (std::size_t q = 0; q < points; ++q)
      for (std::size_t a = 0; a < shapes; ++a)
        for (const auto& [b, w] : weight[a])
          out[q * nodes.size() + b] += w * values[q * shapes + a];
    return out;
  }

private:
  std::size_t local(int node) {
    const auto at = std::find(nodes.begin(), nodes.end(), node);
    if (at != nodes.end())
      return static_cast<std::size_t>(at - nodes.begin());
    nodes.push_back(node);
    return nodes.size() - 1;
  }
};

} // namespace

Section::Section(const std::filesystem::path& path, int degree, const ProfileCurve& curve,
                 const BodyFile::Strip& strip, Refinement refinement)
    : impl_(std::make_unique<Impl>(degree)) {
  make_section_mesh(impl_->mesh, path, curve, strip, refinement);
  impl_->mapping.initialize(dealii::MappingQ<2>(static_cast<unsigned>(degree)), impl_->mesh);
  impl_->dofs.reinit(impl_->mesh);
  impl_->dofs.distribute_dofs(impl_->element);
  dealii::DoFTools::make_hanging_node_constraints(impl_->dofs, impl_->hanging);
  impl_->hanging.close();
  impl_->number_nodes();
  impl_->find_held_nodes();
}

Section::~Section() = default;

std::size_t Section::cell_count() const {
  return impl_->mesh.n_active_cells();
}
std::size_t Section::node_count() const {
  return impl_->positions.size();
}
const std::vector<Point2>& Section::node_positions() const {
  return impl_->positions;
}
const std::vector<char>& Section::held() const {
  return impl_->held;
}

Elements Section::cells() const {
  Elements all;
  std::vector<dealii::types::global_dof_index> dofs(impl_->element.n_dofs_per_cell());
  for (const auto& cell : impl_->dofs.active_cell_iterators()) {
    cell->get_dof_indices(dofs);
    all.add(CellNodes(dofs, impl_->hanging, impl_->node).nodes);
  }
  return all;
}

void Section::for_each_cell(const std::function<void(const CellView&)>& visit) const {
  using namespace dealii;
  const QGauss<2> rule(impl_->element.degree + 1);
  FEValues<2> values(impl_->mapping, impl_->element, rule,
                     update_values | update_gradients | update_JxW_values | update_quadrature_points);
  const unsigned n = impl_->element.n_dofs_per_cell(), np = rule.size();
  std::vector<types::global_dof_index> dofs(n);
  std::vector<CellPoint> points(np);
  std::vector<double> value(n * np), d_dy(n * np), d_dz(n * np);
  for (const auto& cell : impl_->dofs.active_cell_iterators()) {
    values.reinit(cell);
    cell->get_dof_indices(dofs);
    for (unsigned q = 0; q < np; ++q) {
      points[q] = {values.JxW(q), plain(values.quadrature_point(q))};
      for (unsigned a = 0; a < n; ++a) {
        const auto gradient = values.shape_grad(a, q);
        value[q * n + a] = values.shape_value(a, q);
        d_dy[q * n + a] = gradient[0];
        d_dz[q * n + a] = gradient[1];
      }
    }
    const CellNodes nodes(dofs, impl_->hanging, impl_->node);
    visit({nodes.nodes, points, nodes.resolve(value), nodes.resolve(d_dy), nodes.resolve(d_dz),
           plain(cell->center())});
  }
}

std::vector<PointShapes> Section::shapes_at(std::span<const Point2> points) const {
  using namespace dealii;
  const GridTools::Cache<2> cache(impl_->mesh, impl_->mapping);
  const unsigned n = impl_->element.n_dofs_per_cell();
  std::vector<types::global_dof_index> dofs(n);
  std::vector<PointShapes> out;
  for (const Point2 p : points) {
    PointShapes& here = out.emplace_back();
    const auto [cell, at] = GridTools::find_active_cell_around_point(cache, dealii::Point<2>(p.y, p.z));
    if (cell.state() != IteratorState::valid)
      continue; // beside the section
    const DoFHandler<2>::active_cell_iterator found(&impl_->mesh, cell->level(), cell->index(), &impl_->dofs);
    FEValues<2> values(impl_->mapping, impl_->element, Quadrature<2>(at), update_values | update_gradients);
    values.reinit(found);
    found->get_dof_indices(dofs);
    std::vector<double> value(n), d_dy(n), d_dz(n);
    for (unsigned a = 0; a < n; ++a) {
      value[a] = values.shape_value(a, 0);
      d_dy[a] = values.shape_grad(a, 0)[0];
      d_dz[a] = values.shape_grad(a, 0)[1];
    }
    const CellNodes nodes(dofs, impl_->hanging, impl_->node);
    here = {nodes.nodes, nodes.resolve(value), nodes.resolve(d_dy), nodes.resolve(d_dz)};
  }
  return out;
}

void Section::for_each_contact_edge(const std::function<void(const EdgeView&)>& visit) const {
  using namespace dealii;
  const QGauss<1> rule(impl_->element.degree + 2);
  FEFaceValues<2> values(impl_->mapping, impl_->element, rule, update_values | update_quadrature_points);
  const unsigned n = impl_->element.n_dofs_per_cell(), np = rule.size();
  std::vector<types::global_dof_index> dofs(n);
  std::vector<double> t(np), value(n * np);
  for (const auto& cell : impl_->dofs.active_cell_iterators())
    for (const auto f : cell->face_indices()) {
      if (!cell->at_boundary(f) || static_cast<int>(cell->face(f)->boundary_id()) != contact_id)
        continue;
      values.reinit(cell, f);
      cell->get_dof_indices(dofs);
      const auto a = cell->face(f)->vertex(0), b = cell->face(f)->vertex(1),
                 first = values.quadrature_point(0);
      const bool forward = (first - a).norm() < (first - b).norm();
      for (unsigned q = 0; q < np; ++q) {
        t[q] = forward ? rule.point(q)[0] : 1 - rule.point(q)[0];
        for (unsigned i = 0; i < n; ++i)
          value[q * n + i] = values.shape_value(i, q);
      }
      const CellNodes nodes(dofs, impl_->hanging, impl_->node);
      visit({nodes.nodes, plain(a), plain(b), t, rule.get_weights(), nodes.resolve(value)});
    }
}

} // namespace bem_contact::fem
