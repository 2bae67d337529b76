#include "fem_influence/solid/solid_solver.hpp"

#include "bem_contact/base/error.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>

namespace bem_contact::fem {

namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

std::string place(const SurfacePatch& p) {
  return "s = " + std::to_string(p.s_from) + " .. " + std::to_string(p.s_to) +
         ", x = " + std::to_string(p.x_from) + " .. " + std::to_string(p.x_to) + " mm";
}

} // namespace

double available_memory() {
  std::ifstream in("/proc/meminfo");
  for (std::string word; in >> word;)
    if (double kib = 0; word == "MemAvailable:" && in >> kib)
      return kib / (1024.0 * 1024.0);
  return std::numeric_limits<double>::infinity();
}

SparseColumns patch_functionals(const SolidBody& body, const ContactSurface& surface,
                                std::span<const SurfacePatch> patches) {
  std::vector<std::map<int, Vector3>> of_node(3 * patches.size()); // [column][node]
  std::vector<double> covered(patches.size(), 0.0), value;
  body.for_each_contact_face([&](const SolidFaceView& face) {
    value.resize(face.nodes.size());
    for (std::size_t p = 0; p < patches.size(); ++p)
      for_each_common_point(face.corner, patches[p], [&](const FacePoint& at) {
        covered[p] += at.weight;
        const auto frame = surface.frame(at.place);
        face.shapes(at.xi, at.eta, value);
        for (std::size_t a = 0; a < value.size(); ++a) {
          if (std::abs(value[a]) < 1e-12) // shapes of nodes off the face vanish up to round-off
            continue;
          for (const auto [node, weight] : body.masters(face.nodes[a]))
            for (std::size_t j = 0; j < 3; ++j)
              for (std::size_t c = 0; c < 3; ++c)
                of_node[3 * p + j][node][c] += at.weight * weight * value[a] * frame[j][c];
        }
      });
  });
  for (std::size_t p = 0; p < patches.size(); ++p)
    if (std::abs(covered[p] - patches[p].area()) > 1e-4 * patches[p].area())
      throw InputError("The mesh's group 'contact' does not cover the strip",
                       "of the element at " + place(patches[p]) + " it has " + std::to_string(covered[p]) +
                           " of " + std::to_string(patches[p].area()) + " mm^2",
                       "widen the group, or change [strip] or solid.offsets");
  SparseColumns columns;
  for (const auto& column : of_node) {
    for (const auto& [node, vector] : column)
      for (std::size_t c = 0; c < 3; ++c)
        if (vector[c] != 0) {
          columns.row.push_back(3 * node + static_cast<int>(c));
          columns.value.push_back(vector[c]);
        }
    columns.column_begin.push_back(columns.row.size());
  }
  return columns;
}

SolidSolver::SolidSolver(const SolidBody& body, const Material& material) : body_(body) {
  const double mu = material.shear_modulus, lambda = 2 * mu * material.poisson / (1 - 2 * material.poisson);
  std::vector<int> nodes;
  Eigen::MatrixXd of_cell;
  body.for_each_cell([&](const SolidCellView& cell) {
    nodes.clear();
    for (const int node : cell.nodes)
      for (const auto& master : body.masters(node))
        nodes.push_back(master.node);
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    cells_.add(nodes);
    const auto local = [&](int node) {
      return std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin();
    };
    const auto m = static_cast<Eigen::Index>(cell.nodes.size()),
               np = static_cast<Eigen::Index>(cell.weight.size()),
               size = 3 * static_cast<Eigen::Index>(nodes.size());
    const Eigen::Map<const RowMajor> g(cell.gradient.data(), np, 3 * m);
    const Eigen::Map<const Eigen::VectorXd> w(cell.weight.data(), np);
    const RowMajor h = g.transpose() * w.asDiagonal() * g;
    of_cell.setZero(size, size);
    for (Eigen::Index a = 0; a < m; ++a)
      for (Eigen::Index b = 0; b < m; ++b) {
        const Eigen::Matrix3d block = h.block<3, 3>(3 * a, 3 * b);
        const Eigen::Matrix3d k =
            lambda * block + mu * block.transpose() + mu * block.trace() * Eigen::Matrix3d::Identity();
        for (const auto [row, row_weight] : body.masters(cell.nodes[static_cast<std::size_t>(a)]))
          for (const auto [column, column_weight] : body.masters(cell.nodes[static_cast<std::size_t>(b)]))
            of_cell.block<3, 3>(3 * local(row), 3 * local(column)) += row_weight * column_weight * k;
      }
    for (Eigen::Index column = 0; column < size; ++column)
      value_.insert(value_.end(), &of_cell(column, column), of_cell.col(column).data() + size);
  });
  place_ = nested_dissection(body.node_count(), cells_);
}

std::vector<int> SolidSolver::unknown_numbers(MirrorSymmetry symmetry) const {
  const NodeFlags& flags = body_.flags();
  std::vector<int> unknown(3 * flags.held.size(), -1);
  std::vector<std::size_t> node_at(place_.size());
  for (std::size_t node = 0; node < place_.size(); ++node)
    node_at[static_cast<std::size_t>(place_[node])] = node;
  int next = 0;
  for (const std::size_t node : node_at)
    for (std::size_t c = 0; c < 3; ++c)
      if (!flags.hanging[node] && !flags.held[node] &&
          !(flags.mirrored[node] && (c == 0) == (symmetry == MirrorSymmetry::even)))
        unknown[3 * node + c] = next++;
  return unknown;
}

std::size_t SolidSolver::unknowns(MirrorSymmetry symmetry) const {
  const auto numbers = unknown_numbers(symmetry);
  return static_cast<std::size_t>(*std::max_element(numbers.begin(), numbers.end()) + 1);
}

void SolidSolver::solve(
    MirrorSymmetry symmetry, const SparseColumns& loads, const SparseColumns& samples,
    const std::function<void(std::size_t, std::span<const double>, std::span<const double>)>& use) const {
  const std::vector<int> unknown = unknown_numbers(symmetry);
  const int size = *std::max_element(unknown.begin(), unknown.end()) + 1;
  Elements elements;
  std::vector<double> values;
  std::vector<int> all, members; // of a cell: -1 where there is no unknown
  auto value = value_.begin();
  for (std::size_t cell = 0; cell < cells_.count(); ++cell) {
    all.clear();
    for (const int node : cells_[cell])
      for (std::size_t c = 0; c < 3; ++c)
        all.push_back(unknown[3 * static_cast<std::size_t>(node) + c]);
    for (std::size_t column = 0; column < all.size(); ++column)
      for (std::size_t row = column; row < all.size(); ++row, ++value)
        if (all[row] >= 0 && all[column] >= 0)
          values.push_back(*value);
    members.clear();
    std::copy_if(all.begin(), all.end(), std::back_inserter(members), [](int u) { return u >= 0; });
    if (!members.empty())
      elements.add(members);
  }
  MumpsSolver solver(size, std::move(elements));
  const double needed = solver.estimated_memory(), there = available_memory();
  if (needed > there)
    throw Error(
        "The 3-D mesh is too large for this machine",
        std::to_string(size) + " unknowns need about " + std::to_string(needed) + " GiB, and " +
            std::to_string(there) + " GiB are free",
        "raise solid.grading, or lower solid.loads_at_once, solid.elements_per_load or the mesh's own size");
  solver.factorize(values);
  SparseColumns loaded_rows, sampled_rows;
  append_unknowns(loaded_rows, loads, unknown);
  append_unknowns(sampled_rows, samples, unknown);
  std::vector<double> sampled(samples.columns()), displacement;
  solver.solve(loaded_rows, [&](std::size_t c, std::span<const double> solution) {
    for (std::size_t s = 0; s < sampled.size(); ++s) {
      double sum = 0;
      for (std::size_t e = sampled_rows.column_begin[s]; e < sampled_rows.column_begin[s + 1]; ++e)
        sum += sampled_rows.value[e] * solution[static_cast<std::size_t>(sampled_rows.row[e])];
      sampled[s] = sum;
    }
    displacement.assign(unknown.size(), 0.0);
    for (std::size_t node = 0; node < place_.size(); ++node)
      for (const auto [master, weight] : body_.masters(static_cast<int>(node)))
        for (std::size_t i = 0; i < 3; ++i)
          if (const int u = unknown[3 * static_cast<std::size_t>(master) + i]; u >= 0)
            displacement[3 * node + i] += weight * solution[static_cast<std::size_t>(u)];
    use(c, sampled, displacement);
  });
}

} // namespace bem_contact::fem
