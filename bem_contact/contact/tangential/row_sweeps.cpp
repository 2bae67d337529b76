#include "bem_contact/contact/tangential/linearise.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <numeric>

namespace bem_contact::contact {
namespace {

using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

/// The rows hold this share of the sum of squares, with this many elements at most and this share of all.
constexpr double most_of_it = 0.7, most_of_all = 0.25;
constexpr std::size_t most_elements = 1000;
/// Sweeps until so much of the residual is left. Undamped ones overshoot: rolling elements have self numbers
/// hardly larger than their neighbours'.
constexpr int most_sweeps = 50;
constexpr double enough = 0.01, first_damping = 1;

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
  if (elements > most_elements || double(elements) > most_of_all * double(contact.size()))
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
  const int mx = system.problem->grid.mx;
  std::vector<int> rank(system.problem->grid.ms, -1), rows;
  int low = mx, high = 0;
  for (const int i : elements) {
    low = std::min(low, i % mx);
    high = std::max(high, i % mx);
    if (int& known = rank[i / mx]; known < 0) {
      known = static_cast<int>(rows.size());
      rows.push_back(i / mx);
    }
  }
  // two rows' depend on the offset along x alone: all of those, once
  const int most = high - low, each = 2 * most + 1;
  std::vector<Matrix2d> lines;
  lines.reserve(rows.size() * rows.size() * each);
  for (const int to : rows)
    for (const int from : rows)
      for (int m = -most; m <= most; ++m)
        lines.push_back(step_number(system, to * mx + std::max(m, 0), from * mx + std::max(-m, 0)));
  const auto n = static_cast<Eigen::Index>(elements.size());
  MatrixXd matrix(2 * n, 2 * n);
  for (Eigen::Index b = 0; b < n; ++b)
    for (Eigen::Index a = 0; a < n; ++a) {
      const int target = elements[a], load = elements[b];
      const std::size_t pair = rank[target / mx] * rows.size() + rank[load / mx];
      matrix.block<2, 2>(2 * a, 2 * b) = lines[pair * each + target % mx - load % mx + most];
    }
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

bool sweep_rows(const TangentialSystem& system, const std::vector<int>& contact, const VectorXd& stiffness,
                const VectorXd& bound, const VectorXd& slip, const Linearisation& at, VectorXd& p) {
  std::vector<int> list = worst_rows(system, contact, at);
  const auto n = static_cast<Eigen::Index>(list.size());
  if (n == 0)
    return false;
  const int mx = system.problem->grid.mx;
  std::ranges::stable_sort(list, [&](int a, int b) { return contact[a] % mx > contact[b] % mx; });
  VectorXd here_stiffness(n), here_bound(n);
  std::vector<int> elements(n);
  for (Eigen::Index a = 0; a < n; ++a) {
    elements[a] = contact[list[a]];
    here_stiffness[a] = stiffness[list[a]];
    here_bound[a] = bound[list[a]];
  }
  const MatrixXd b = step_matrix(system, elements);
  VectorXd here = gather(p, list), here_slip = gather(slip, list);
  const double before = gather(at.residual, list).norm();
  double left = before, damping = first_damping;
  for (int k = 0; k < most_sweeps && !(left <= enough * before); ++k) {
    system.spend(sweep_work(static_cast<double>(n)));
    for (Eigen::Index a = 0; a < n; ++a) {
      const Vector2d old = here.segment<2>(2 * a);
      const Matrix2d self = b.block<2, 2>(2 * a, 2 * a) + damping / here_stiffness[a] * Matrix2d::Identity();
      const Vector2d next = solve_element(self, here_slip.segment<2>(2 * a) + self * old, here_bound[a]);
      here_slip -= b.middleCols<2>(2 * a) * (next - old);
      here.segment<2>(2 * a) = next;
    }
    const double now = linearise(here_stiffness, here_bound, here, here_slip).residual.norm();
    if (now > left)
      damping *= 2;
    left = now;
  }
  if (!(left < before))
    return false;
  for (Eigen::Index a = 0; a < n; ++a)
    p.segment<2>(2 * list[a]) = here.segment<2>(2 * a);
  return true;
}

} // namespace bem_contact::contact
