#include "fem_influence/section.hpp"

#include "bem_contact/base/error.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/tria.h>

#include <fstream>
#include <sstream>

namespace bem_contact::fem {

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
    // deal.II's messages fill a page; the line after "additional information" says what went wrong.
    std::string why = error.what();
    if (const auto at = why.find("Additional information:"); at != std::string::npos)
      why = why.substr(at + 23);
    why = why.substr(0, why.find("\nStacktrace"));
    std::istringstream words(why);
    std::string line;
    for (std::string word; words >> word && line.size() < 300;)
      if (word.find_first_not_of('-') != std::string::npos)
        line += (line.empty() ? "" : " ") + word;
    throw InputError("The mesh '" + file + "' is not a gmsh mesh of quadrilaterals in the plane",
                     "deal.II refuses it: " + line, "make it with mesh_body");
  }
  if (mesh.n_active_cells() == 0 || !mesh.all_reference_cells_are_hyper_cube())
    throw InputError("The mesh '" + file + "' has cells that are not quadrilaterals",
                     "the elements are tensor products", "recombine all triangles, or use mesh_body");
}

} // namespace

struct Section::Impl {
  dealii::Triangulation<2> mesh;
  dealii::FE_Q<2> element;
  dealii::DoFHandler<2> nodes;
  dealii::MappingQ1<2> mapping;
  std::vector<Point2> positions;
  std::vector<char> held;

  explicit Impl(int degree) : element(degree) {}
};

Section::Section(const std::filesystem::path& path, int degree) : impl_(std::make_unique<Impl>(degree)) {
  read_mesh(impl_->mesh, path);
  impl_->nodes.reinit(impl_->mesh);
  impl_->nodes.distribute_dofs(impl_->element);

  std::vector<dealii::Point<2>> points(impl_->nodes.n_dofs());
  dealii::DoFTools::map_dofs_to_support_points(impl_->mapping, impl_->nodes, points);
  for (const auto& point : points)
    impl_->positions.push_back(plain(point));

  impl_->held.assign(points.size(), 0);
  bool any_contact = false, any_held = false;
  std::vector<dealii::types::global_dof_index> on_face(impl_->element.n_dofs_per_face());
  for (const auto& cell : impl_->nodes.active_cell_iterators())
    for (const auto f : cell->face_indices()) {
      if (!cell->at_boundary(f))
        continue;
      const auto id = static_cast<int>(cell->face(f)->boundary_id());
      any_contact = any_contact || id == contact_id;
      if (id != held_id)
        continue;
      any_held = true;
      cell->face(f)->get_dof_indices(on_face);
      for (const auto node : on_face)
        impl_->held[node] = 1;
    }
  if (!any_contact || !any_held)
    throw InputError(
        "The mesh '" + path.string() + "' has no group '" +
            (any_contact ? "held' (physical curve 2)" : "contact' (physical curve 1)"),
        "loads and supports are found by the mesh's physical groups",
        "make the mesh with mesh_body, or add the physical curves contact = 1, held = 2, free = 3");
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

void Section::for_each_cell(const std::function<void(const CellView&)>& visit) const {
  using namespace dealii;
  const QGauss<2> rule(impl_->element.degree + 1);
  FEValues<2> values(impl_->mapping, impl_->element, rule,
                     update_values | update_gradients | update_JxW_values | update_quadrature_points);
  const unsigned n = impl_->element.n_dofs_per_cell(), np = rule.size();
  std::vector<types::global_dof_index> indices(n);
  std::vector<int> nodes(n);
  std::vector<CellPoint> points(np);
  std::vector<double> value(n * np), d_dy(n * np), d_dz(n * np);
  for (const auto& cell : impl_->nodes.active_cell_iterators()) {
    values.reinit(cell);
    cell->get_dof_indices(indices);
    nodes.assign(indices.begin(), indices.end());
    for (unsigned q = 0; q < np; ++q) {
      points[q] = {values.JxW(q), plain(values.quadrature_point(q))};
      for (unsigned a = 0; a < n; ++a) {
        const auto gradient = values.shape_grad(a, q);
        value[q * n + a] = values.shape_value(a, q);
        d_dy[q * n + a] = gradient[0];
        d_dz[q * n + a] = gradient[1];
      }
    }
    visit({nodes, points, value, d_dy, d_dz, plain(cell->center())});
  }
}

void Section::for_each_contact_edge(const std::function<void(const EdgeView&)>& visit) const {
  using namespace dealii;
  const QGauss<1> rule(impl_->element.degree + 2);
  FEFaceValues<2> values(impl_->mapping, impl_->element, rule, update_values | update_quadrature_points);
  const unsigned n = impl_->element.n_dofs_per_cell(), np = rule.size();
  std::vector<types::global_dof_index> indices(n);
  std::vector<int> nodes(n);
  std::vector<double> t(np), value(n * np);
  for (const auto& cell : impl_->nodes.active_cell_iterators())
    for (const auto f : cell->face_indices()) {
      if (!cell->at_boundary(f) || static_cast<int>(cell->face(f)->boundary_id()) != contact_id)
        continue;
      values.reinit(cell, f);
      cell->get_dof_indices(indices);
      nodes.assign(indices.begin(), indices.end());
      const auto a = cell->face(f)->vertex(0), b = cell->face(f)->vertex(1);
      for (unsigned q = 0; q < np; ++q) {
        t[q] = (values.quadrature_point(q) - a).norm() / (b - a).norm();
        for (unsigned i = 0; i < n; ++i)
          value[q * n + i] = values.shape_value(i, q);
      }
      visit({nodes, plain(a), plain(b), t, rule.get_weights(), value});
    }
}

} // namespace bem_contact::fem
