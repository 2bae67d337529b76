#include "bem_contact/contact/linearise.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <numeric>

namespace bem_contact::contact {
namespace {

using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

/// The rows hold this share of the sum of squares, with this many elements at most.
constexpr double most_of_it = 0.7;
constexpr std::size_t most_elements = 200;
constexpr int most_steps = 25;

/// Numbers in the contact list of the elements of the rows with the largest residuals; none: too many.
std::vector<int> worst_rows(const TangentialSystem& system, const std::vector<int>& contact,
                            const Linearisation& at) {
  const int mx = system.problem->grid.mx;
  std::vector<double> square(system.problem->grid.ms, 0.0);
  std::vector<std::size_t> count(square.size(), 0);
  for (std::size_t a = 0; a < contact.size(); ++a) {
    square[contact[a] / mx] += at.residual.segment<2>(2 * a).squaredNorm();
    ++count[contact[a] / mx];
  }
  std::vector<int> order(square.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return square[a] > square[b]; });
  std::vector<char> taken(square.size(), 0);
  double held = 0;
  std::size_t elements = 0;
  for (std::size_t k = 0; k < order.size() && held < most_of_it * at.residual.squaredNorm(); ++k) {
    held += square[order[k]];
    elements += count[order[k]];
    taken[order[k]] = 1;
  }
  std::vector<int> list;
  if (elements > most_elements || 20 * elements > contact.size())
    return list;
  for (std::size_t a = 0; a < contact.size(); ++a)
    if (taken[contact[a] / mx])
      list.push_back(static_cast<int>(a));
  return list;
}

VectorXd gather(const VectorXd& v, const std::vector<int>& list) {
  VectorXd out(2 * list.size());
  for (std::size_t a = 0; a < list.size(); ++a)
    out.segment<2>(2 * a) = v.segment<2>(2 * list[a]);
  return out;
}

} // namespace

Matrix2d step_number(const TangentialSystem& system, int target, int load) {
  const int mx = system.problem->grid.mx;
  Matrix2d block = Matrix2d::Zero();
  for (int k = 0; k <= rolling_columns; ++k) {
    if (system.rule.present[k] == 0)
      continue;
    const int m = target % mx + k - load % mx;
    for (int c = 0; c < 2; ++c)
      for (int d = 0; d < 2; ++d)
        block(c, d) += system.rule.present[k] * (m < 0 ? parity(c, d) : 1) *
                       system.problem->numbers.at(std::abs(m), target / mx, c, load / mx, d);
  }
  return block;
}

MatrixXd step_matrix(const TangentialSystem& system, const std::vector<int>& elements) {
  const auto n = static_cast<Eigen::Index>(elements.size());
  MatrixXd matrix(2 * n, 2 * n);
  for (Eigen::Index b = 0; b < n; ++b)
    for (Eigen::Index a = 0; a < n; ++a)
      matrix.block<2, 2>(2 * a, 2 * b) = step_number(system, elements[a], elements[b]);
  return matrix;
}

Linearisation linearise(const VectorXd& stiffness, const VectorXd& bound, const VectorXd& p,
                        const VectorXd& slip) {
  const auto n = bound.size();
  Linearisation result{VectorXd(2 * n), std::vector<Matrix2d>(n)};
  for (Eigen::Index a = 0; a < n; ++a) {
    const Vector2d z = p.segment<2>(2 * a) + stiffness[a] * slip.segment<2>(2 * a);
    const double length = z.norm();
    if (length <= bound[a]) {
      result.residual.segment<2>(2 * a) = p.segment<2>(2 * a) - z;
      result.projection[a] = Matrix2d::Identity();
    } else {
      const Vector2d direction = z / length;
      result.residual.segment<2>(2 * a) = p.segment<2>(2 * a) - bound[a] * direction;
      result.projection[a] = bound[a] / length * (Matrix2d::Identity() - direction * direction.transpose());
    }
  }
  return result;
}

bool newton_on_rows(const TangentialSystem& system, const std::vector<int>& contact,
                    const VectorXd& stiffness, const VectorXd& bound, const VectorXd& slip,
                    const Linearisation& at, VectorXd& p) {
  const std::vector<int> list = worst_rows(system, contact, at);
  const auto n = static_cast<Eigen::Index>(list.size());
  if (n == 0)
    return false;
  MatrixXd b(2 * n, 2 * n);
  VectorXd here_stiffness(n), here_bound(n);
  for (Eigen::Index c = 0; c < n; ++c) {
    here_stiffness[c] = stiffness[list[c]];
    here_bound[c] = bound[list[c]];
    for (Eigen::Index r = 0; r < n; ++r)
      b.block<2, 2>(2 * r, 2 * c) = step_number(system, contact[list[r]], contact[list[c]]);
  }
  VectorXd here = gather(p, list), here_slip = gather(slip, list);
  Linearisation now = linearise(here_stiffness, here_bound, here, here_slip);
  const double target = 0.01 * now.residual.norm();
  for (int k = 0; k < most_steps && now.residual.norm() > target; ++k) {
    MatrixXd jacobian(2 * n, 2 * n);
    for (Eigen::Index a = 0; a < n; ++a) {
      jacobian.middleRows<2>(2 * a) = here_stiffness[a] * now.projection[a] * b.middleRows<2>(2 * a);
      jacobian.block<2, 2>(2 * a, 2 * a) += Matrix2d::Identity() - now.projection[a];
    }
    const VectorXd step = jacobian.partialPivLu().solve(-now.residual);
    if (!step.allFinite())
      return false;
    here += step;
    here_slip -= b * step;
    now = linearise(here_stiffness, here_bound, here, here_slip);
  }
  for (Eigen::Index a = 0; a < n; ++a)
    p.segment<2>(2 * list[a]) = here.segment<2>(2 * a);
  return true;
}

} // namespace bem_contact::contact
