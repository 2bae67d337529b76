#include "fem_influence/shared/section.hpp"

#include "bem_contact/base/error.hpp"
#include "fem_influence/shared/curved_outline.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/fe/mapping_q_cache.h>
#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/manifold.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

namespace bem_contact::fem {

std::string short_reason(const std::exception& error) {
  std::string why = error.what();
  if (const auto at = why.find("Additional information:"); at != std::string::npos)
    why = why.substr(at + 23);
  why = why.substr(0, why.find("\nStacktrace"));
  std::istringstream words(why);
  std::string line;
  for (std::string word; words >> word && line.size() < 300;)
    if (word.find_first_not_of('-') != std::string::npos)
      line += (line.empty() ? "" : " ") + word;
  return line;
}

namespace {

// A point of deal.II is (y, z) here.
Point2 plain(const dealii::Point<2>& p) {
  return {p[0], p[1]};
}

void read_mesh(dealii::Triangulation<2>& mesh, const std::filesystem::path& path) {
  const auto file = path.string();
  std::ifstream in(path);
  if (!in || std::filesystem::is_directory(path))
    throw InputError("The mesh file '" + file + "' cannot be read", "no readable file has that name",
                     "make it with mesh_body, or correct the path");
  try {
    dealii::GridIn<2> reader(mesh);
    reader.read_msh(in);
  } catch (const std::exception& error) {
    throw InputError("The mesh '" + file + "' is not a gmsh mesh of quadrilaterals in the plane",
                     "deal.II refuses it: " + short_reason(error),
                     "make it with mesh_body, and give --solid with a 3-D mesh");
  }
  if (mesh.n_active_cells() == 0 || !mesh.all_reference_cells_are_hyper_cube())
    throw InputError("The mesh '" + file + "' has cells that are not quadrilaterals",
                     "the elements are tensor products", "recombine all triangles, or use mesh_body");
}

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
        "make the mesh with mesh_body, or add the physical curves contact = 1, held = 2, free = 3");
}

/// A mesh of another body, or in another frame, is told by its distance from the curve; the sagitta of a
/// chord is far smaller than a tenth of it.
void require_on_curve(Point2 a, Point2 b, const ProfileCurve& curve) {
  const Point2 middle = 0.5 * (a + b);
  const double off = norm(curve.nearest(middle).position - middle);
  if (off > 0.1 * norm(b - a) + 1e-6)
    throw InputError("The mesh does not fit the profile '" + curve.name() + "'",
                     "an edge of the group 'contact' at (y, z) = (" + std::to_string(middle.y) + ", " +
                         std::to_string(middle.z) + ") lies " + std::to_string(off) + " mm off it",
                     "mesh the body file that is used here");
}

/// New points are means along the profile, or on one of the outline's other arcs.
class OnOutline : public dealii::Manifold<2> {
public:
  OnOutline(std::shared_ptr<const CurvedOutline> outline, bool on_profile)
      : outline_(std::move(outline)), on_profile_(on_profile) {}
  std::unique_ptr<dealii::Manifold<2>> clone() const override { return std::make_unique<OnOutline>(*this); }
  dealii::Point<2> get_new_point(const dealii::ArrayView<const dealii::Point<2>>& points,
                                 const dealii::ArrayView<const double>& weights) const override {
    std::vector<Point2> from;
    for (const auto& p : points)
      from.push_back(plain(p));
    const std::span weight(weights.data(), weights.size());
    const Point2 p =
        on_profile_ ? outline_->mean_on_profile(from, weight) : outline_->mean_on_arc(from, weight);
    return {p.y, p.z};
  }

private:
  std::shared_ptr<const CurvedOutline> outline_;
  bool on_profile_;
};

constexpr dealii::types::manifold_id curve_id = 1, arcs_id = 2;

bool on_strip(const dealii::TriaIterator<dealii::CellAccessor<2>>& cell, unsigned face) {
  return cell->at_boundary(face) && static_cast<int>(cell->face(face)->boundary_id()) == contact_id;
}

void refine(dealii::Triangulation<2>& mesh, const ProfileCurve& curve, const BodyFile::Strip& strip,
            Refinement refinement) {
  mesh.refine_global(static_cast<unsigned>(refinement.everywhere));
  const auto at_border = [&](const dealii::Point<2>& vertex) {
    const double station = (curve.nearest(plain(vertex)).s - strip.from) / strip.station_width;
    return std::abs(station - std::round(station)) < 1e-3;
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
  read_mesh(impl_->mesh, path);
  require_groups(impl_->mesh, path);
  const auto outline = std::make_shared<const CurvedOutline>(curve, path);
  for (const auto& cell : impl_->mesh.active_cell_iterators())
    for (const auto f : cell->face_indices())
      if (cell->at_boundary(f)) {
        const Point2 a = plain(cell->face(f)->vertex(0)), b = plain(cell->face(f)->vertex(1));
        if (on_strip(cell, f))
          require_on_curve(a, b, curve);
        // Straight edges next to the strip would be felt on it: all of the profile is curved.
        const auto edge = on_strip(cell, f) ? CurvedOutline::Edge::profile : outline->edge(a, b);
        if (edge != CurvedOutline::Edge::straight)
          cell->face(f)->set_manifold_id(edge == CurvedOutline::Edge::profile ? curve_id : arcs_id);
      }
  impl_->mesh.set_manifold(curve_id, OnOutline(outline, true));
  impl_->mesh.set_manifold(arcs_id, OnOutline(outline, false));
  refine(impl_->mesh, curve, strip, refinement);
  impl_->mapping.initialize(dealii::MappingQ<2>(static_cast<unsigned>(degree)), impl_->mesh);
  impl_->dofs.reinit(impl_->mesh);
  impl_->dofs.distribute_dofs(impl_->element);
  dealii::DoFTools::make_hanging_node_constraints(impl_->dofs, impl_->hanging);
  impl_->hanging.close();

  std::vector<dealii::Point<2>> points(impl_->dofs.n_dofs());
  dealii::DoFTools::map_dofs_to_support_points(impl_->mapping, impl_->dofs, points);
  impl_->node.assign(points.size(), -1);
  for (dealii::types::global_dof_index dof = 0; dof < points.size(); ++dof)
    if (!impl_->hanging.is_constrained(dof)) {
      impl_->node[dof] = static_cast<int>(impl_->positions.size());
      impl_->positions.push_back(plain(points[dof]));
    }
  impl_->held.assign(impl_->positions.size(), 0);
  std::vector<dealii::types::global_dof_index> on_face(impl_->element.n_dofs_per_face());
  for (const auto& cell : impl_->dofs.active_cell_iterators())
    for (const auto f : cell->face_indices()) {
      if (!cell->at_boundary(f) || static_cast<int>(cell->face(f)->boundary_id()) != held_id)
        continue;
      cell->face(f)->get_dof_indices(on_face);
      for (const auto dof : on_face)
        if (impl_->node[dof] >= 0)
          impl_->held[static_cast<std::size_t>(impl_->node[dof])] = 1;
    }
}

Section::~Section() = default;

int Section::degree() const {
  return static_cast<int>(impl_->element.degree);
}
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

void Section::for_each_contact_edge(const std::function<void(const EdgeView&)>& visit) const {
  using namespace dealii;
  const QGauss<1> rule(impl_->element.degree + 2);
  FEFaceValues<2> values(impl_->mapping, impl_->element, rule, update_values | update_quadrature_points);
  const unsigned n = impl_->element.n_dofs_per_cell(), np = rule.size();
  std::vector<types::global_dof_index> dofs(n);
  std::vector<double> t(np), value(n * np);
  for (const auto& cell : impl_->dofs.active_cell_iterators())
    for (const auto f : cell->face_indices()) {
      if (!on_strip(cell, f))
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
