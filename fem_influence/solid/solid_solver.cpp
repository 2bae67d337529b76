#include "fem_influence/solid/solid_solver.hpp"

#include "bem_contact/base/error.hpp"
#include "fem_influence/shared/memory.hpp"
#include "fem_influence/shared/mumps_solver.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <string>

namespace bem_contact::fem {

namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Of a cell, masters for those that hang, ascending.
std::vector<int> nodes_of(const SolidCellView& cell, const SolidBody& body) {
  std::vector<int> nodes;
  for (const int node : cell.nodes)
    for (const auto& master : body.masters(node))
      nodes.push_back(master.node);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

void require_memory(const MumpsSolver& solver, int unknowns) {
  const double needed = solver.estimated_memory(), there = available_memory();
  if (needed > there)
    throw Error(
        "The 3-D mesh is too large for this machine",
        fmt::format("{} unknowns need about {:.1f} GiB, and {:.1f} GiB are free", unknowns, needed, there),
        "Raise solid.grading, or lower solid.loads_at_once, solid.elements_per_load or the mesh's own size.");
}

/// Products of each column with a solution.
std::vector<double> products(const SparseColumns& columns, std::span<const double> solution) {
  std::vector<double> all;
  for (std::size_t c = 0; c < columns.columns(); ++c) {
    double sum = 0;
    columns.for_each_entry(
        c, [&](int row, double value) { sum += value * solution[static_cast<std::size_t>(row)]; });
    all.push_back(sum);
  }
  return all;
}

} // namespace

SolidSolver::SolidSolver(const SolidBody& body, const Material& material) : body_(body) {
  const double mu = material.shear_modulus, lambda = 2 * mu * material.poisson / (1 - 2 * material.poisson);
  Eigen::MatrixXd of_cell;
  body.for_each_cell([&](const SolidCellView& cell) {
    const std::vector<int> nodes = nodes_of(cell, body);
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

std::vector<double> SolidSolver::unknown_part(std::span<const int> unknown, Elements& elements) const {
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
  return values;
}

std::vector<double> SolidSolver::displacement(std::span<const int> unknown,
                                              std::span<const double> solution) const {
  std::vector<double> all(unknown.size(), 0.0);
  for (std::size_t node = 0; node < place_.size(); ++node)
    for (const auto [master, weight] : body_.masters(static_cast<int>(node)))
      for (std::size_t i = 0; i < 3; ++i)
        if (const int u = unknown[3 * static_cast<std::size_t>(master) + i]; u >= 0)
          all[3 * node + i] += weight * solution[static_cast<std::size_t>(u)];
  return all;
}

void SolidSolver::solve(
    MirrorSymmetry symmetry, const SparseColumns& loads, const SparseColumns& samples,
    const std::function<void(std::size_t, std::span<const double>, std::span<const double>)>& use) const {
  const std::vector<int> unknown = unknown_numbers(symmetry);
  const int size = *std::max_element(unknown.begin(), unknown.end()) + 1;
  Elements elements;
  std::vector<double> values = unknown_part(unknown, elements);
  MumpsSolver solver(size, std::move(elements));
  require_memory(solver, size);
  solver.factorize(values);
  SparseColumns loaded_rows, sampled_rows;
  append_unknowns(loaded_rows, loads, unknown);
  append_unknowns(sampled_rows, samples, unknown);
  solver.solve(loaded_rows, [&](std::size_t c, std::span<const double> solution) {
    use(c, products(sampled_rows, solution), displacement(unknown, solution));
  });
}

} // namespace bem_contact::fem
