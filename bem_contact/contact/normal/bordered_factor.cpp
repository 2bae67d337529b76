#include "bem_contact/contact/normal/bordered_factor.hpp"

#include "bem_contact/contact/normal/settings.hpp"
#include "bem_contact/influence/dense.hpp"

#include <algorithm>
#include <iterator>

namespace bem_contact::contact {

using Eigen::MatrixXd;
using Eigen::VectorXd;

BorderedFactor::BorderedFactor(const NormalLines& lines, const std::vector<int>& elements)
    : factored_(elements), present_(elements), place_(elements.size()), factor_(lines.block(elements)),
      positive_(factor_cholesky(factor_)) {
  for (std::size_t k = 0; k < place_.size(); ++k)
    place_[k] = static_cast<int>(k);
}

bool BorderedFactor::use_elements(const NormalLines& lines, const std::vector<int>& elements) {
  if (present_ == elements)
    return true;
  std::vector<int> fresh, gone;
  std::ranges::set_difference(elements, factored_, std::back_inserter(fresh));
  std::ranges::set_difference(factored_, elements, std::back_inserter(gone));
  if (static_cast<double>(fresh.size() + gone.size()) > most_bordered * static_cast<double>(factored_.size()))
    return false;
  present_ = elements;
  place_.clear();
  left_.clear();
  const auto in_factor = [&](int element) {
    return static_cast<int>(std::ranges::lower_bound(factored_, element) - factored_.begin());
  };
  int number = 0;
  for (const int element : elements)
    if (number < static_cast<int>(fresh.size()) && fresh[number] == element)
      place_.push_back(-1 - number++);
    else
      place_.push_back(in_factor(element));
  std::ranges::transform(gone, std::back_inserter(left_), in_factor);

  const auto n = static_cast<Eigen::Index>(factored_.size());
  const auto count_left = static_cast<Eigen::Index>(gone.size()),
             count_new = static_cast<Eigen::Index>(fresh.size());
  border_left_.setZero(n, count_left);
  for (Eigen::Index k = 0; k < count_left; ++k)
    border_left_(left_[k], k) = 1;
  border_new_.resize(n, count_new);
  for (Eigen::Index k = 0; k < count_new; ++k)
    for (Eigen::Index i = 0; i < n; ++i)
      border_new_(i, k) = lines.at(factored_[i], fresh[k]);
  solve_lower(factor_, border_left_);
  solve_lower(factor_, border_new_);
  MatrixXd schur = -border_new_.transpose() * border_new_;
  for (Eigen::Index k = 0; k < count_new; ++k)
    for (Eigen::Index i = 0; i < count_new; ++i)
      schur(i, k) += lines.at(fresh[i], fresh[k]);
  coupling_ = -border_left_.transpose() * border_new_;
  of_left_.compute(border_left_.transpose() * border_left_);
  if (count_left > 0)
    schur += coupling_.transpose() * of_left_.solve(coupling_);
  of_new_.compute(schur);
  positive_ = (count_left == 0 || of_left_.info() == Eigen::Success) &&
              (count_new == 0 || of_new_.info() == Eigen::Success);
  return true;
}

VectorXd BorderedFactor::solve(const VectorXd& right) const {
  VectorXd z = VectorXd::Zero(static_cast<Eigen::Index>(factored_.size())), fresh(border_new_.cols());
  for (std::size_t k = 0; k < place_.size(); ++k)
    (place_[k] < 0 ? fresh[-1 - place_[k]] : z[place_[k]]) = right[static_cast<Eigen::Index>(k)];
  solve_lower(factor_, z);
  if (fresh.size() > 0)
    fresh -= border_new_.transpose() * z;
  if (!left_.empty()) {
    VectorXd held = of_left_.solve(-border_left_.transpose() * z);
    if (fresh.size() > 0) {
      fresh = of_new_.solve(fresh + coupling_.transpose() * held);
      held = of_left_.solve(coupling_ * fresh) - held;
    } else {
      held *= -1;
    }
    z -= border_left_ * held;
  } else if (fresh.size() > 0) {
    fresh = of_new_.solve(fresh);
  }
  if (fresh.size() > 0)
    z -= border_new_ * fresh;
  solve_lower_transposed(factor_, z);
  VectorXd out(right.size());
  for (std::size_t k = 0; k < place_.size(); ++k)
    out[static_cast<Eigen::Index>(k)] = place_[k] < 0 ? fresh[-1 - place_[k]] : z[place_[k]];
  return out;
}

} // namespace bem_contact::contact
