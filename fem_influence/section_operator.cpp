#include "fem_influence/section_operator.hpp"

#include "bem_contact/base/error.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bem_contact::fem {

namespace {

void make_pattern(const Section& section, SectionOperator& op) {
  std::vector<std::vector<int>> neighbours(section.node_count());
  section.for_each_cell_nodes([&](std::span<const int> nodes) {
    for (const int a : nodes) {
      auto& list = neighbours[static_cast<std::size_t>(a)];
      for (const int b : nodes)
        if (b >= a)
          list.push_back(b);
    }
  });
  op.row_begin.assign(1, 0);
  for (auto& list : neighbours) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    op.column.insert(op.column.end(), list.begin(), list.end());
    op.row_begin.push_back(op.column.size());
    std::vector<int>().swap(list);
  }
  op.block.resize(op.column.size());
}

/// Where the strains of a cell's shapes are: the columns of its table are n shapes of each kind, each times
/// the root of its point's weight. by_r = f / r is the hoop strain (none in a prism), by_rho = f / rho what k
/// multiplies.
enum Kind : Eigen::Index { d_dy, d_dz, by_r, by_rho, kinds };

} // namespace

SectionOperator assemble(const Section& section, const Material& material, double reference_radius) {
  SectionOperator op;
  make_pattern(section, op);
  const double mu = material.shear_modulus, lambda = 2 * mu * material.poisson / (1 - 2 * material.poisson),
               stiff = lambda + 2 * mu;
  op.mu = mu;
  op.stiff = stiff;
  const bool revolution = reference_radius > 0;

  Eigen::MatrixXd table, product; // [point][n kind + shape]; of two shapes, summed over points
  section.for_each_cell([&](const CellView& cell) {
    const auto n = static_cast<Eigen::Index>(cell.nodes.size());
    const auto np = static_cast<Eigen::Index>(cell.points.size());
    table.resize(np, kinds * n);
    for (Eigen::Index q = 0; q < np; ++q) {
      const CellPoint& point = cell.points[static_cast<std::size_t>(q)];
      const double r = reference_radius + point.position.z;
      if (revolution && !(r > 0))
        throw InputError("The mesh reaches the axle of the wheel",
                         "a point has z = " + std::to_string(point.position.z) + " mm and r = R_ref + z <= 0",
                         "use a section with a bore");
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

    for (Eigen::Index a = 0; a < n; ++a) {
      const int row = cell.nodes[static_cast<std::size_t>(a)];
      const auto first =
          op.column.begin() + static_cast<std::ptrdiff_t>(op.row_begin[static_cast<std::size_t>(row)]);
      const auto last =
          op.column.begin() + static_cast<std::ptrdiff_t>(op.row_begin[static_cast<std::size_t>(row) + 1]);
      for (Eigen::Index b = 0; b < n; ++b) {
        const int col = cell.nodes[static_cast<std::size_t>(b)];
        if (row > col)
          continue;
        const auto of = [&](Kind i, Kind j) { return product(i * n + a, j * n + b); };
        auto& [k0, k1, shapes] =
            op.block[static_cast<std::size_t>(std::lower_bound(first, last, col) - op.column.begin())];
        const double yy = of(d_dy, d_dy), zz = of(d_dz, d_dz), rr = of(by_r, by_r), zr = of(d_dz, by_r),
                     rz = of(by_r, d_dz);
        // Strain after strain, as section_operator.hpp has them.
        k0[0] += mu * (yy + zz - zr - rz + rr);
        k0[1] += stiff * yy + mu * zz;
        k0[2] += lambda * (of(d_dy, by_r) + of(d_dy, d_dz)) + mu * of(d_dz, d_dy);
        k0[3] += lambda * (of(by_r, d_dy) + of(d_dz, d_dy)) + mu * of(d_dy, d_dz);
        k0[4] += stiff * (rr + zz) + lambda * (rz + zr) + mu * yy;
        k1[0] += lambda * of(by_rho, d_dy) - mu * of(d_dy, by_rho);
        k1[1] +=
            stiff * of(by_rho, by_r) + lambda * of(by_rho, d_dz) - mu * (of(d_dz, by_rho) - of(by_r, by_rho));
        k1[2] += lambda * of(d_dy, by_rho) - mu * of(by_rho, d_dy);
        k1[3] +=
            stiff * of(by_r, by_rho) + lambda * of(d_dz, by_rho) - mu * (of(by_rho, d_dz) - of(by_rho, by_r));
        shapes += of(by_rho, by_rho);
      }
    }
  });
  return op;
}

std::vector<double> SectionOperator::apply(double k, std::span<const double> u) const {
  std::vector<double> f(u.size(), 0.0);
  for (std::size_t a = 0; a < node_count(); ++a)
    for (std::size_t e = row_begin[a]; e < row_begin[a + 1]; ++e) {
      const auto b = static_cast<std::size_t>(column[e]);
      const auto entries = at(e, k);
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
          const double v = entries[3 * i + j];
          f[3 * a + i] += v * u[3 * b + j];
          if (a != b)
            f[3 * b + j] += v * u[3 * a + i];
        }
    }
  return f;
}

SectionOperator renumbered(const SectionOperator& op, std::span<const int> place) {
  SectionOperator result;
  result.mu = op.mu;
  result.stiff = op.stiff;
  result.row_begin.assign(op.node_count() + 1, 0);
  const auto for_each = [&](auto&& use) {
    for (std::size_t a = 0; a < op.node_count(); ++a)
      for (std::size_t e = op.row_begin[a]; e < op.row_begin[a + 1]; ++e) {
        const auto [low, high] = std::minmax(place[a], place[static_cast<std::size_t>(op.column[e])]);
        use(static_cast<std::size_t>(low), high, e, low != place[a]);
      }
  };
  for_each([&](std::size_t row, int, std::size_t, bool) { ++result.row_begin[row + 1]; });
  std::partial_sum(result.row_begin.begin(), result.row_begin.end(), result.row_begin.begin());

  struct Source {
    int column;
    bool turned;
    std::size_t e;
  };
  std::vector<Source> sources(op.column.size());
  std::vector<std::size_t> next(result.row_begin.begin(), result.row_begin.end() - 1);
  for_each([&](std::size_t row, int column, std::size_t e, bool turned) {
    sources[next[row]++] = {column, turned, e};
  });
  for (std::size_t row = 0; row < op.node_count(); ++row)
    std::sort(sources.begin() + static_cast<std::ptrdiff_t>(result.row_begin[row]),
              sources.begin() + static_cast<std::ptrdiff_t>(result.row_begin[row + 1]),
              [](const Source& a, const Source& b) { return a.column < b.column; });
  result.column.reserve(sources.size());
  result.block.reserve(sources.size());
  for (const Source& from : sources) {
    result.column.push_back(from.column);
    result.block.push_back(from.turned ? op.block[from.e].transposed() : op.block[from.e]);
  }
  return result;
}

std::vector<std::vector<double>> rigid_motions(std::span<const Point2> nodes, double reference_radius,
                                               int n) {
  using Field = std::array<double, 3> (*)(Point2, double);
  std::vector<Field> fields;
  if (reference_radius > 0 && n == 0)
    fields = {[](Point2, double) {
                return std::array{0.0, 1.0, 0.0};
              },
              [](Point2, double r) {
                return std::array{r, 0.0, 0.0};
              }};
  else if (reference_radius > 0 && n == 1)
    fields = {[](Point2, double) {
                return std::array{-1.0, 0.0, 1.0};
              },
              [](Point2 p, double r) {
                return std::array{p.y, r, -p.y};
              }};
  else if (n == 0)
    fields = {[](Point2, double) {
                return std::array{1.0, 0.0, 0.0};
              },
              [](Point2, double) {
                return std::array{0.0, 1.0, 0.0};
              },
              [](Point2, double) {
                return std::array{0.0, 0.0, 1.0};
              },
              [](Point2 p, double) {
                return std::array{0.0, -p.z, p.y};
              }};
  std::vector<std::vector<double>> motions;
  for (const Field field : fields) {
    auto& motion = motions.emplace_back();
    for (const Point2 p : nodes)
      for (const double u : field(p, reference_radius + p.z))
        motion.push_back(u);
  }
  return motions;
}

} // namespace bem_contact::fem
