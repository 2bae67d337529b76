#include "fem_influence/harmonic/section_operator.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/influence/lower_triangle.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace bem_contact::fem {

namespace {

/// Where the strains of a cell's shapes are: the columns of its table are n shapes of each kind, each times
/// the root of its point's weight. by_r = f / r is the hoop strain (none in a prism), by_rho = f / rho what k
/// multiplies.
enum Kind : Eigen::Index { d_dy, d_dz, by_r, by_rho, kinds };

} // namespace

std::size_t SectionOperator::block_count() const {
  std::size_t count = 0;
  for (std::size_t c = 0; c < cells.count(); ++c)
    count += lower_size(cells[c].size());
  return count;
}

SectionOperator lay_out(const Section& section, const Material& material, double reference_radius) {
  for (const Point2 p : section.node_positions())
    if (reference_radius != 0 && !((reference_radius + p.z) / reference_radius > 0))
      throw InputError("The mesh reaches the axle of the body",
                       "a node has z = " + std::to_string(p.z) +
                           " mm, and the axle is at z = " + std::to_string(-reference_radius) + " mm",
                       "Use a section with a bore.");
  SectionOperator op;
  op.cells = section.cells();
  op.mu = material.shear_modulus;
  op.lambda = 2 * op.mu * material.poisson / (1 - 2 * material.poisson);
  return op;
}

void fill(SectionOperator& op, const Section& section, double reference_radius,
          std::span<SectionOperator::Block> memory) {
  const double mu = op.mu, lambda = op.lambda, stiff = lambda + 2 * mu;
  const bool revolution = reference_radius != 0;
  if (memory.empty()) {
    const auto own = std::make_shared<std::vector<SectionOperator::Block>>(op.block_count());
    op.own = own;
    memory = *own;
  }
  op.block = memory;
  auto block = memory.begin();

  Eigen::MatrixXd table, product; // [point][n kind + shape]; of two shapes, summed over points
  section.for_each_cell([&](const CellView& cell) {
    const auto n = static_cast<Eigen::Index>(cell.nodes.size());
    const auto np = static_cast<Eigen::Index>(cell.points.size());
    table.resize(np, kinds * n);
    for (Eigen::Index q = 0; q < np; ++q) {
      const CellPoint& point = cell.points[static_cast<std::size_t>(q)];
      const double r = reference_radius + point.position.z;
      const double rho = revolution ? r / reference_radius : 1.0, root = std::sqrt(point.weight * rho);
      for (Eigen::Index a = 0; a < n; ++a) {
        const auto at = static_cast<std::size_t>(q * n + a);
        table(q, d_dy * n + a) = root * cell.d_dy[at];
        table(q, d_dz * n + a) = root * cell.d_dz[at];
        table(q, by_r * n + a) = revolution ? root * cell.value[at] / r : 0.0;
        table(q, by_rho * n + a) = root * cell.value[at] / rho;
      }
    }
    product.noalias() = table.transpose() * table;

    for (Eigen::Index a = 0; a < n; ++a)
      for (Eigen::Index b = a; b < n; ++b) {
        const auto of = [&](Kind i, Kind j) { return product(i * n + a, j * n + b); };
        auto& [k0, k1, shapes] = *block++;
        const double yy = of(d_dy, d_dy), zz = of(d_dz, d_dz), rr = of(by_r, by_r), zr = of(d_dz, by_r),
                     rz = of(by_r, d_dz);
        // Strain after strain, as section_operator.hpp has them.
        k0[0] = mu * (yy + zz - zr - rz + rr);
        k0[1] = stiff * yy + mu * zz;
        k0[2] = lambda * (of(d_dy, by_r) + of(d_dy, d_dz)) + mu * of(d_dz, d_dy);
        k0[3] = lambda * (of(by_r, d_dy) + of(d_dz, d_dy)) + mu * of(d_dy, d_dz);
        k0[4] = stiff * (rr + zz) + lambda * (rz + zr) + mu * yy;
        k1[0] = lambda * of(by_rho, d_dy) - mu * of(d_dy, by_rho);
        k1[1] =
            stiff * of(by_rho, by_r) + lambda * of(by_rho, d_dz) - mu * (of(d_dz, by_rho) - of(by_r, by_rho));
        k1[2] = lambda * of(d_dy, by_rho) - mu * of(by_rho, d_dy);
        k1[3] =
            stiff * of(by_r, by_rho) + lambda * of(d_dz, by_rho) - mu * (of(by_rho, d_dz) - of(by_rho, by_r));
        shapes = of(by_rho, by_rho);
      }
  });
}

std::vector<double> SectionOperator::apply(double k, std::span<const double> u) const {
  std::vector<double> f(u.size(), 0.0);
  std::size_t e = 0;
  for (std::size_t c = 0; c < cells.count(); ++c) {
    const auto still = [&](int node) {
      const auto at = u.subspan(3 * static_cast<std::size_t>(node), 3);
      return at[0] == 0 && at[1] == 0 && at[2] == 0;
    };
    if (std::all_of(cells[c].begin(), cells[c].end(), still)) {
      e += lower_size(cells[c].size());
      continue;
    }
    for (auto nodes = cells[c]; !nodes.empty(); nodes = nodes.subspan(1)) {
      const auto a = static_cast<std::size_t>(nodes.front());
      for (const int node : nodes) {
        const auto b = static_cast<std::size_t>(node);
        const auto entries = at(e++, k);
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t j = 0; j < 3; ++j) {
            const double v = entries[3 * i + j];
            f[3 * a + i] += v * u[3 * b + j];
            if (a != b)
              f[3 * b + j] += v * u[3 * a + i];
          }
      }
    }
  }
  return f;
}

std::vector<std::vector<double>> rigid_motions(std::span<const Point2> nodes, double reference_radius) {
  const bool revolution = reference_radius != 0;
  std::vector<std::vector<double>> motions(revolution ? 2 : 4);
  const auto add = [&](std::size_t motion, double x, double y, double z) {
    motions[motion].insert(motions[motion].end(), {x, y, z});
  };
  for (const Point2 p : nodes)
    if (revolution) {
      add(0, 0, 1, 0);
      add(1, reference_radius + p.z, 0, 0);
    } else {
      add(0, 1, 0, 0);
      add(1, 0, 1, 0);
      add(2, 0, 0, 1);
      add(3, 0, -p.z, p.y);
    }
  return motions;
}

} // namespace bem_contact::fem
