#include "fem_influence/section_operator.hpp"

#include "bem_contact/base/error.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace bem_contact::fem {

namespace {

void make_pattern(const Section& section, SectionOperator& op) {
  std::vector<std::vector<int>> neighbours(section.node_count());
  section.for_each_cell([&](const CellView& cell) {
    for (const int a : cell.nodes) {
      auto& list = neighbours[static_cast<std::size_t>(a)];
      for (const int b : cell.nodes)
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
  for (auto& value : op.value)
    value.assign(9 * op.column.size(), 0.0);
}

/// Square root of the elasticity matrix for (xx, yy, zz, yz, xy, xz), engineering shear strains: the
/// element matrices become M^T M, symmetric to the last bit.
Eigen::Matrix<double, 6, 6> elasticity_root(const Material& material) {
  const double mu = material.shear_modulus;
  const double lambda = 2 * mu * material.poisson / (1 - 2 * material.poisson);
  Eigen::Matrix3d normal = Eigen::Matrix3d::Constant(lambda);
  normal.diagonal().array() += 2 * mu;
  Eigen::Matrix<double, 6, 6> root = Eigen::Matrix<double, 6, 6>::Zero();
  root.topLeftCorner<3, 3>() = normal.llt().matrixU();
  root.diagonal().tail<3>().setConstant(std::sqrt(mu));
  return root;
}

} // namespace

SectionOperator assemble(const Section& section, const Material& material, double reference_radius) {
  SectionOperator op;
  make_pattern(section, op);
  const auto root = elasticity_root(material);
  const bool revolution = reference_radius > 0;

  Eigen::MatrixXd strain; // [6 point + strain][(0 or 1: factor of k) 3n + 3 node + component]
  Eigen::MatrixXd product;
  section.for_each_cell([&](const CellView& cell) {
    const auto n = static_cast<Eigen::Index>(cell.nodes.size());
    const auto np = static_cast<Eigen::Index>(cell.points.size());
    strain.setZero(6 * np, 6 * n);
    Eigen::Matrix<double, 6, 3> b0, b1;
    for (Eigen::Index q = 0; q < np; ++q) {
      const CellPoint& point = cell.points[static_cast<std::size_t>(q)];
      const double r = reference_radius + point.position.z;
      if (revolution && !(r > 0))
        throw InputError("The mesh reaches the axle of the wheel",
                         "a point has z = " + std::to_string(point.position.z) + " mm and r = R_ref + z <= 0",
                         "use a section with a bore");
      const double rho = revolution ? r / reference_radius : 1.0;
      const double per_r = revolution ? 1.0 / r : 0.0;
      const double root_weight = std::sqrt(point.weight * rho);
      for (Eigen::Index a = 0; a < n; ++a) {
        const auto at = static_cast<std::size_t>(q * n + a);
        const double f = cell.value[at], fy = cell.d_dy[at], fz = cell.d_dz[at];
        b0 << 0, 0, f * per_r, //
            0, fy, 0,          //
            0, 0, fz,          //
            0, fz, fy,         //
            fy, 0, 0,          //
            fz - f * per_r, 0, 0;
        b1.setZero();
        b1(0, 0) = f / rho;
        b1(4, 1) = -f / rho;
        b1(5, 2) = -f / rho;
        strain.block<6, 3>(6 * q, 3 * a) = root_weight * root * b0;
        strain.block<6, 3>(6 * q, 3 * (n + a)) = root_weight * root * b1;
      }
    }
    product.setZero(6 * n, 6 * n);
    product.selfadjointView<Eigen::Upper>().rankUpdate(strain.transpose());
    const auto entry = [&](Eigen::Index i, Eigen::Index j) { return i <= j ? product(i, j) : product(j, i); };

    for (Eigen::Index a = 0; a < n; ++a)
      for (Eigen::Index b = 0; b < n; ++b) {
        const int row = cell.nodes[static_cast<std::size_t>(a)],
                  col = cell.nodes[static_cast<std::size_t>(b)];
        if (row > col)
          continue;
        const auto first =
            op.column.begin() + static_cast<std::ptrdiff_t>(op.row_begin[static_cast<std::size_t>(row)]);
        const auto last =
            op.column.begin() + static_cast<std::ptrdiff_t>(op.row_begin[static_cast<std::size_t>(row) + 1]);
        const auto at = 9 * static_cast<std::size_t>(std::lower_bound(first, last, col) - op.column.begin());
        for (Eigen::Index i = 0; i < 3; ++i)
          for (Eigen::Index j = 0; j < 3; ++j) {
            const auto to = at + static_cast<std::size_t>(3 * i + j);
            const Eigen::Index p = 3 * a + i, s = 3 * b + j, k = 3 * n;
            op.value[0][to] += entry(p, s);
            op.value[1][to] += entry(p, s + k) + entry(p + k, s);
            op.value[2][to] += entry(p + k, s + k);
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
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
          const std::size_t at = 9 * e + 3 * i + j;
          const double v = value[0][at] + k * (value[1][at] + k * value[2][at]);
          f[3 * a + i] += v * u[3 * b + j];
          if (a != b)
            f[3 * b + j] += v * u[3 * a + i];
        }
    }
  return f;
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
