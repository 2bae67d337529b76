#include "bem_contact/contact/tangential/row_sweeps.hpp"

#include "bem_contact/contact/settings.hpp"
#include "bem_contact/contact/tangential/element_sweeps.hpp"

#include <algorithm>
#include <numeric>

namespace bem_contact::contact {
namespace {

using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

/// Places in the contact list of the elements of the rows with the largest residuals; none: too many.
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
  for (std::size_t k = 0; k < order.size() && held < swept_share * at.residual.squaredNorm(); ++k) {
    held += square[order[k]];
    elements += count[order[k]];
    taken[order[k]] = 1;
  }
  std::vector<int> list;
  if (elements > std::size_t(most_swept_elements) || double(elements) > most_swept_share * double(contact.size()))
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

/// The elements of the worst rows, in the order of the sweeps.
struct Rows {
  std::vector<int> list, elements; ///< places in the contact list; numbers on the grid
  VectorXd stiffness, bound, p, slip;
};

/// Sweeps until little of the residual is left; returns how much is. Undamped sweeps overshoot: in rolling the
/// self numbers are hardly larger than those of the neighbours.
double sweep(const MatrixXd& b, double before, WorkBudget& work, Rows& rows) {
  const auto n = static_cast<Eigen::Index>(rows.list.size());
  double left = before, damping = first_row_damping;
  for (int k = 0; k < most_row_sweeps && !(left <= row_sweeps_enough * before); ++k) {
    work.spend(sweep_work(static_cast<double>(n)));
    for (Eigen::Index a = 0; a < n; ++a) {
      const Vector2d old = rows.p.segment<2>(2 * a);
      const Matrix2d self = b.block<2, 2>(2 * a, 2 * a) + damping / rows.stiffness[a] * Matrix2d::Identity();
      const Vector2d next = solve_element(self, rows.slip.segment<2>(2 * a) + self * old, rows.bound[a]);
      rows.slip -= b.middleCols<2>(2 * a) * (next - old);
      rows.p.segment<2>(2 * a) = next;
    }
    const double now = linearise(rows.stiffness, rows.bound, rows.p, rows.slip).residual.norm();
    if (now > left)
      damping *= 2;
    left = now;
  }
  return left;
}

} // namespace

bool sweep_rows(const TangentialSystem& system, const ContactElements& all, const VectorXd& slip,
                const Linearisation& at, WorkBudget& work, VectorXd& p) {
  Rows rows{worst_rows(system, all.contact, at), {}, {}, {}, {}, {}};
  const auto n = static_cast<Eigen::Index>(rows.list.size());
  if (n == 0)
    return false;
  const int mx = system.columns();
  std::ranges::stable_sort(rows.list,
                           [&](int a, int b) { return all.contact[a] % mx > all.contact[b] % mx; });
  rows.elements.resize(n);
  rows.stiffness.resize(n);
  rows.bound.resize(n);
  for (Eigen::Index a = 0; a < n; ++a) {
    rows.elements[a] = all.contact[rows.list[a]];
    rows.stiffness[a] = all.stiffness[rows.list[a]];
    rows.bound[a] = all.bound[rows.list[a]];
  }
  rows.p = gather(p, rows.list);
  rows.slip = gather(slip, rows.list);
  const double before = gather(at.residual, rows.list).norm();
  const MatrixXd b = step_matrix(*system.problem, system.rule.present, rows.elements);
  if (!(sweep(b, before, work, rows) < before))
    return false;
  for (Eigen::Index a = 0; a < n; ++a)
    p.segment<2>(2 * rows.list[a]) = rows.p.segment<2>(2 * a);
  return true;
}

} // namespace bem_contact::contact
