#include "bem_contact/influence/structure.hpp"

#include "bem_contact/influence/remote_factor.hpp"
#include "bem_contact/influence/series_weights.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <cmath>
#include <vector>

namespace bem_contact {

namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>; // as SixBySix lies in memory
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Eigen::MatrixXd;

/// mm. Length along x over which the motion of a strip is averaged and its force is spread: about that of a
/// contact. Structural motion varies over 20 mm and more, the distance of the remote section.
constexpr double structure_length = 10.0;
/// 1. Elements of that length. A force spread by 10 in place of 5 changes the matrix by less than 1e-3.
constexpr int structure_elements = 5;
/// 1. Least reciprocal condition number (unit diagonal) of a structure's compliance that is inverted:
/// rounding of the influence numbers would show in the stiffness of a worse one.
constexpr double least_structure_condition = 1e-12;

/// Displacements of one section, in the order of its columns: u_x = 1, y, z; then u of the section as it
/// moves along y, along z, and turns about x. (y, z) is measured from the point.
enum Shape : int { x_alone = 0, x_by_y = 1, x_by_z = 2, along_y = 3, along_z = 4, turn = 5 };

bool is_along_x(int shape) {
  return shape < 3;
}

/// Shapes in the stations' own components: 3 stations x 6.
MatrixXd shapes_of(const InfluenceStrip& f, Point2 point) {
  MatrixXd shapes = MatrixXd::Zero(static_cast<Eigen::Index>(3 * f.station_count()), 6);
  Eigen::Index row = 0;
  for (const Station& station : f.stations) {
    const Point2 r = station.position - point, s = tangent_of(station.delta), n = normal_of(station.delta);
    shapes.row(row + component_x) << 1, r.y, r.z, 0, 0, 0;
    shapes.row(row + component_s) << 0, 0, 0, s.y, s.z, dot({-r.z, r.y}, s);
    shapes.row(row + component_n) << 0, 0, 0, n.y, n.z, dot({-r.z, r.y}, n);
    row += 3;
  }
  return shapes;
}

/// What each of the six rigid motions is at x: a sum of shapes (6 x 6, [shape][motion]). Turns about y and z
/// move the section along x by its lever, and across it by -x and x.
Matrix6 motions_at(double x) {
  Matrix6 m = Matrix6::Zero();
  m(x_alone, 0) = m(along_y, 1) = m(along_z, 2) = m(turn, 3) = 1;
  m(x_by_z, 4) = 1;
  m(along_z, 4) = -x;
  m(x_by_y, 5) = -1;
  m(along_y, 5) = x;
  return m;
}

/// Structural influence numbers of elements of the whole strip's width, between their shapes: at(m) for
/// displaced elements m ahead of the loaded one.
class ShapeNumbers {
public:
  ShapeNumbers(const InfluenceStrip& f, const MatrixXd& shapes, double dx, int elements)
      : numbers_(static_cast<std::size_t>(elements), Matrix6::Zero()) {
    const auto nk = static_cast<Eigen::Index>(f.wavenumber_count());
    const SeriesWeights weights = series_weights(f.wavenumber, f.half_period, dx, elements);
    for (Eigen::Index k = 0; k < nk; ++k) {
      const MatrixXd half = remote_factor(f, f.all_stations(), k) * shapes;
      const Matrix6 kernel = half.transpose() * half;
      for (int m = 0; m < elements; ++m)
        add(kernel, weights.even[m * nk + k], weights.odd[m * nk + k], numbers_[m]);
    }
  }

  Matrix6 at(int m) const {
    Matrix6 out = numbers_[std::abs(m)];
    if (m < 0) {
      out.topRightCorner<3, 3>() *= -1;
      out.bottomLeftCorner<3, 3>() *= -1;
    }
    return out;
  }

private:
  /// The signs are those of the series (influence_function.hpp).
  static void add(const Matrix6& kernel, double even, double odd, Matrix6& sum) {
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j) {
        const bool mixed = is_along_x(i) != is_along_x(j);
        sum(i, j) += (!mixed ? even : is_along_x(i) ? odd : -odd) * kernel(i, j);
      }
  }

  std::vector<Matrix6> numbers_;
};

SixBySix symmetric_part(const Matrix6& m) {
  SixBySix out;
  Eigen::Map<Matrix6>(out.front().data()) = 0.5 * (m + m.transpose());
  return out;
}

Eigen::Map<const Matrix6> matrix_of(const SixBySix& a) {
  return Eigen::Map<const Matrix6>(a.front().data());
}

} // namespace

std::optional<SixBySix> structural_compliance(const InfluenceStrip& f, Point2 point) {
  if (f.is_table() || f.wavenumber_count() < 3)
    return std::nullopt;
  const int elements = structure_elements;
  const bool round = f.invariance == Invariance::revolution;
  const double ratio = round ? f.radius_at(point) / std::abs(f.reference_radius) : 1.0;
  const double dx = structure_length / elements / ratio;
  const MatrixXd shapes = shapes_of(f, point);
  const Matrix6 square = shapes.transpose() * shapes;
  const ShapeNumbers numbers(f, shapes, dx, elements);
  std::vector<Matrix6> motions;
  Matrix6 size = Matrix6::Zero(), energy = Matrix6::Zero();
  for (int i = 0; i < elements; ++i) {
    motions.push_back(motions_at((i - 0.5 * (elements - 1)) * dx * ratio));
    size += motions[i].transpose() * square * motions[i];
  }
  for (int i = 0; i < elements; ++i)
    for (int j = 0; j < elements; ++j)
      energy += motions[i].transpose() * numbers.at(i - j) * motions[j];
  // Tractions that follow the six motions have the resultants size * area times their amplitudes.
  const Matrix6 inverted = size.llt().solve(Matrix6::Identity());
  const Matrix6 out = inverted * energy * inverted.transpose() / (dx * f.station_width);
  return symmetric_part(out);
}

std::optional<SixBySix> inverse(const SixBySix& matrix) {
  const auto a = matrix_of(matrix);
  const Vector6 diagonal = a.diagonal();
  if (!(diagonal.minCoeff() > 0))
    return std::nullopt;
  const Vector6 scale = diagonal.cwiseSqrt().cwiseInverse();
  const Matrix6 scaled = scale.asDiagonal() * a * scale.asDiagonal();
  const Eigen::LLT<Matrix6> cholesky(scaled);
  if (cholesky.info() != Eigen::Success || cholesky.rcond() < least_structure_condition)
    return std::nullopt;
  const Matrix6 out = scale.asDiagonal() * cholesky.solve(Matrix6::Identity()) * scale.asDiagonal();
  return symmetric_part(out);
}

SixNumbers product(const SixBySix& matrix, const SixNumbers& vector) {
  SixNumbers out;
  Eigen::Map<Vector6>(out.data()) = matrix_of(matrix) * Eigen::Map<const Vector6>(vector.data());
  return out;
}

} // namespace bem_contact
