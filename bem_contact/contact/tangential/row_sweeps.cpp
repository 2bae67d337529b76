#include "bem_contact/contact/tangential/row_sweeps.hpp"

#include "bem_contact/base/simd.hpp"
#include "bem_contact/contact/tangential/element_sweeps.hpp"
#include "bem_contact/contact/tangential/settings.hpp"
#include "bem_contact/contact/tangential/step_box.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace bem_contact::contact {
namespace {

using Eigen::Matrix2d;
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
  if (elements > std::size_t(most_swept_elements) ||
      double(elements) > most_swept_share * double(contact.size()))
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

/// slip -= b0 p0 + b1 p1
BEM_CONTACT_WIDE void subtract(const double* b0, double p0, const double* b1, double p1, int n,
                               double* slip) {
  for (int t = 0; t < n; ++t)
    slip[t] -= b0[t] * p0 + b1[t] * p1;
}

/// The elements of the worst rows, in the order of the sweeps.
class Rows {
public:
  Rows(const TangentialSystem& system, std::vector<int> places, const ContactElements& all, const VectorXd& p,
       const VectorXd& slip)
      : places_(std::move(places)), at_(numbers_of(places_, all.contact), system.columns()),
        b_(system.problem->numbers, at_.rows, at_.columns, system.rule.present), p_(gather(p, places_)),
        slip_(std::size_t(2) * b_.rows() * b_.columns(), 0.0) {
    const auto n = static_cast<Eigen::Index>(places_.size());
    stiffness_.resize(n);
    bound_.resize(n);
    for (Eigen::Index a = 0; a < n; ++a) {
      stiffness_[a] = all.stiffness[places_[a]];
      bound_[a] = all.bound[places_[a]];
      for (int c = 0; c < 2; ++c)
        slip_at(a, c) = slip[2 * places_[a] + c];
    }
  }

  int size() const { return static_cast<int>(places_.size()); }
  const std::vector<int>& places() const { return places_; } ///< in the contact list
  const VectorXd& p() const { return p_; }
  double residual() const {
    VectorXd slip(2 * size());
    for (Eigen::Index a = 0; a < size(); ++a)
      slip.segment<2>(2 * a) << slip_at(a, 0), slip_at(a, 1);
    return linearise(stiffness_, bound_, p_, slip).residual.norm();
  }

  /// One sweep; `damping` is added to the self number, in units of 1 / stiffness.
  void sweep(double damping) {
    for (Eigen::Index a = 0; a < size(); ++a) {
      const int row = at_.row[a], ix = at_.column[a];
      Matrix2d self = damping / stiffness_[a] * Matrix2d::Identity();
      for (int c = 0; c < 2; ++c)
        for (int d = 0; d < 2; ++d)
          self(c, d) += b_.line(ix, row, c, row, d)[ix];
      const Vector2d old = p_.segment<2>(2 * a);
      const Vector2d next =
          solve_element(self, Vector2d(slip_at(a, 0), slip_at(a, 1)) + self * old, bound_[a]);
      const Vector2d more = next - old;
      for (int to = 0; to < b_.rows(); ++to)
        for (int c = 0; c < 2; ++c)
          subtract(b_.under_load(ix, to, c, row, 0), more[0], b_.under_load(ix, to, c, row, 1), more[1],
                   b_.columns(), &slip_[static_cast<std::size_t>(2 * to + c) * b_.columns()]);
      p_.segment<2>(2 * a) = next;
    }
  }

private:
  static std::vector<int> numbers_of(const std::vector<int>& places, const std::vector<int>& contact) {
    std::vector<int> numbers;
    for (const int a : places)
      numbers.push_back(contact[a]);
    return numbers;
  }
  std::size_t slip_index(Eigen::Index a, int c) const {
    return static_cast<std::size_t>(2 * at_.row[a] + c) * b_.columns() + b_.columns() - 1 - at_.column[a];
  }
  double slip_at(Eigen::Index a, int c) const { return slip_[slip_index(a, c)]; }
  double& slip_at(Eigen::Index a, int c) { return slip_[slip_index(a, c)]; }

  std::vector<int> places_;
  ElementPlaces at_;
  StepNumbers b_;
  VectorXd p_, stiffness_, bound_;
  std::vector<double> slip_; ///< [row][component], from the leading edge on
};

/// Sweeps until little of the residual is left; returns how much is. Undamped sweeps overshoot: in rolling
/// the self numbers are hardly larger than those of the neighbours.
double sweep(double before, WorkBudget& work, Rows& rows) {
  double left = before, damping = first_row_damping;
  for (int k = 0; k < most_row_sweeps && !(left <= row_sweeps_enough * before); ++k) {
    work.spend(sweep_work(rows.size()));
    rows.sweep(damping);
    const double now = rows.residual();
    if (now > left)
      damping *= 2;
    left = now;
  }
  return left;
}

} // namespace

bool sweep_rows(const TangentialSystem& system, const ContactElements& all, const VectorXd& slip,
                const Linearisation& at, WorkBudget& work, VectorXd& p) {
  std::vector<int> places = worst_rows(system, all.contact, at);
  if (places.empty())
    return false;
  const int mx = system.columns();
  std::ranges::stable_sort(places, [&](int a, int b) { return all.contact[a] % mx > all.contact[b] % mx; });
  Rows rows(system, std::move(places), all, p, slip);
  const double before = gather(at.residual, rows.places()).norm();
  if (!(sweep(before, work, rows) < before))
    return false;
  for (Eigen::Index a = 0; a < rows.size(); ++a)
    p.segment<2>(2 * rows.places()[a]) = rows.p().segment<2>(2 * a);
  return true;
}

} // namespace bem_contact::contact
