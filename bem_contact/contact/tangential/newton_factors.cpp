#include "bem_contact/contact/tangential/newton_factors.hpp"

#include <algorithm>
#include <utility>

namespace bem_contact::contact {

using Eigen::Matrix2f;
using Eigen::Vector2f;
using Eigen::VectorXf;

NewtonFactors::NewtonFactors(const std::vector<int>& numbers, std::span<const NewtonElement> elements,
                             const Eigen::MatrixXf& b)
    : numbers_(numbers) {
  for (int a = 0; a < static_cast<int>(elements.size()); ++a) {
    const Matrix2f& projection = elements[a].projection;
    if (elements[a].sticks()) {
      unknowns_.push_back({a, {1, 0}});
      unknowns_.push_back({a, {0, 1}});
    } else if (elements[a].m > 0)
      unknowns_.push_back({a, projection.col(projection(0, 0) > projection(1, 1) ? 0 : 1).normalized()});
  }
  const auto count = static_cast<Eigen::Index>(unknowns_.size());
  Eigen::MatrixXf jacobian(count, count);
  VectorXf column(b.rows());
  for (Eigen::Index k = 0; k < count; ++k) {
    const auto& [load, along] = unknowns_[k];
    column = along[0] * b.col(2 * load) + along[1] * b.col(2 * load + 1);
    for (Eigen::Index l = 0; l < count; ++l) {
      const auto& [element, direction] = unknowns_[l];
      const float weight = std::min(elements[element].m, 1.0f) * elements[element].stiffness;
      jacobian(l, k) = weight * direction.dot(column.segment<2>(2 * element));
    }
    jacobian(k, k) += 1 - std::min(elements[load].m, 1.0f);
  }
  factors_.emplace(std::move(jacobian));
  use_elements(numbers);
}

void NewtonFactors::use_elements(const std::vector<int>& numbers) {
  if (present_ == numbers)
    return;
  present_ = numbers;
  std::vector<int> place(std::max(std::ranges::max(numbers_), std::ranges::max(numbers)) + 1, -1);
  for (std::size_t a = 0; a < numbers.size(); ++a)
    place[numbers[a]] = static_cast<int>(a);
  place_.clear();
  for (const int number : numbers_)
    place_.push_back(place[number]);
}

void NewtonFactors::solve(std::span<const NewtonElement> elements, const VectorXf& v,
                          Eigen::Ref<VectorXf> out) {
  // What lies across a bound stays as it is.
  before_.resize(static_cast<Eigen::Index>(unknowns_.size()));
  std::ranges::transform(unknowns_, before_.begin(), [&](const Unknown& u) {
    const int a = place_[u.element];
    return a < 0 ? 0.0f : u.direction.dot(elements[a].along(v.segment<2>(2 * a)));
  });
  right_ = before_;
  factors_->solve(right_);
  right_ -= before_;
  change_.setZero(v.size());
  for (std::size_t k = 0; k < unknowns_.size(); ++k) {
    const Unknown& u = unknowns_[k];
    if (const int a = place_[u.element]; a >= 0)
      change_.segment<2>(2 * a) += right_[static_cast<Eigen::Index>(k)] * u.direction;
  }
  for (std::size_t a = 0; a < elements.size(); ++a)
    out.segment<2>(2 * a) = v.segment<2>(2 * a) + elements[a].along(change_.segment<2>(2 * a));
}

} // namespace bem_contact::contact
