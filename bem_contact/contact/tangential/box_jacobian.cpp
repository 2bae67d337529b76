#include "bem_contact/contact/tangential/box_jacobian.hpp"

#include "bem_contact/contact/tangential/settings.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact::contact {

using Eigen::Vector2f;
using Eigen::VectorXf;

BoxJacobian::BoxJacobian(const StepBox& box, const std::vector<int>& local,
                         std::span<const NewtonElement> elements, StepBoxScratch& scratch)
    : box_(box), local_(local), elements_(elements), scratch_(scratch), n_(box.size()) {
  double slipping = 0, sum = 0, stiffness = 0;
  std::ranges::fill(scratch.fast_in, 0.0f); // stays so beside the elements in contact
  scratch.scale.assign(elements.size(), 0);
  for (std::size_t a = 0; a < elements.size(); ++a) {
    const NewtonElement& e = elements[a];
    const bool sticks = e.m > counts_as_sticking;
    scratch.sticks[local[a]] = sticks;
    sticking_ = sticking_ || sticks;
    stiffness += e.stiffness;
    if (!sticks) {
      slipping += 1;
      sum += e.m;
    }
  }
  if (!(sum > 0))
    return;
  // (1 - m)/m + r B, scaled from both sides to the mean of the first
  const double mean = std::max(sum / slipping, least_mean_slope), shift = (1 - mean) / mean;
  for (std::size_t a = 0; a < elements.size(); ++a)
    if (const float m = elements[a].m; m <= counts_as_sticking)
      scratch.scale[a] = static_cast<float>(std::sqrt(shift * m / (1 - m)));
  damped_ = true;
  scratch.damped.set(box, shift, stiffness / static_cast<double>(elements.size()));
}

void BoxJacobian::product(Eigen::Ref<const VectorXf> v, Eigen::Ref<VectorXf> result) const {
  for (std::size_t a = 0; a < local_.size(); ++a)
    put(a, v.segment<2>(2 * a));
  box_.step(scratch_.fast_in, scratch_.fast_out);
  for (std::size_t a = 0; a < local_.size(); ++a)
    result.segment<2>(2 * a) = get(a);
}

void BoxJacobian::precondition(const VectorXf& v, Eigen::Ref<VectorXf> result) const {
  for (std::size_t a = 0; a < local_.size(); ++a)
    result.segment<2>(2 * a) = v.segment<2>(2 * a) - elements_[a].along(v.segment<2>(2 * a));
  if (sticking_) {
    for (std::size_t a = 0; a < local_.size(); ++a) {
      const NewtonElement& e = elements_[a];
      put(a, e.m > counts_as_sticking
                 ? Vector2f(e.along(v.segment<2>(2 * a)) / (std::min(e.m, 1.0f) * e.stiffness))
                 : Vector2f(0, 0));
    }
    box_.invert(scratch_.sticks, scratch_.fast_in, scratch_.fast_out);
    for (std::size_t a = 0; a < local_.size(); ++a)
      if (const NewtonElement& e = elements_[a]; e.m > counts_as_sticking)
        result.segment<2>(2 * a) += e.along(get(a));
  }
  if (!damped_)
    return;
  for (std::size_t a = 0; a < local_.size(); ++a) {
    const float scale = scratch_.scale[a];
    put(a, scale > 0 ? Vector2f(scale / elements_[a].m * elements_[a].along(v.segment<2>(2 * a)))
                     : Vector2f(0, 0));
  }
  scratch_.damped.apply(box_, scratch_.fast_in, scratch_.fast_out);
  for (std::size_t a = 0; a < local_.size(); ++a)
    if (const float scale = scratch_.scale[a]; scale > 0)
      result.segment<2>(2 * a) += scale * elements_[a].along(get(a));
}

} // namespace bem_contact::contact
