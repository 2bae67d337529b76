#include "bem_contact/contact/tangential/box_jacobian.hpp"

#include "bem_contact/contact/tangential/settings.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact::contact {

using Eigen::Vector2f;
using Eigen::VectorXf;

BoxJacobian::BoxJacobian(const StepBox& box, const std::vector<int>& local,
                         std::span<const NewtonElement> elements, StepBoxScratch& scratch)
    : box_(box), local_(local), scratch_(scratch), n_(box.size()) {
  double sum = 0, stiffness = 0;
  std::ranges::fill(scratch.fast_in, 0.0f); // stays so beside the elements in contact
  scratch.sticking.clear();
  scratch.slipping.clear();
  for (std::size_t a = 0; a < elements.size(); ++a) {
    const NewtonElement& e = elements[a];
    const bool sticks = e.m > counts_as_sticking;
    scratch.sticks[local[a]] = sticks;
    stiffness += e.stiffness;
    sum += sticks ? 0 : e.m;
    const Eigen::Matrix2f along = e.sticks() ? Eigen::Matrix2f::Identity()
                                  : e.m > 0  ? Eigen::Matrix2f(e.projection / e.m)
                                             : Eigen::Matrix2f::Zero();
    (sticks ? scratch.sticking : scratch.slipping)
        .push_back({static_cast<int>(a), along, 1 / (std::min(e.m, 1.0f) * e.stiffness), 1});
  }
  damped_ = sum > 0;
  if (!damped_) // J is the identity on what slips
    return;
  // (1 - m)/m + r B, scaled from both sides to the mean of the first
  const double mean = std::max(sum / double(scratch.slipping.size()), least_mean_slope),
               shift = (1 - mean) / mean;
  for (PreconditionedElement& slipping : scratch.slipping) {
    const float m = elements[slipping.number].m;
    slipping.after = static_cast<float>(std::sqrt(shift * m / (1 - m)));
    slipping.before = m > 0 ? slipping.after / m : 0;
  }
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
  result = v;
  const Elements &sticking = scratch_.sticking, &slipping = scratch_.slipping;
  if (!sticking.empty()) {
    put_scaled(sticking, slipping, v, result);
    box_.invert(scratch_.sticks, scratch_.fast_in, scratch_.fast_out);
    add_scaled(sticking, result);
  }
  if (damped_) {
    put_scaled(slipping, sticking, v, result);
    scratch_.damped.apply(box_, scratch_.fast_in, scratch_.fast_out);
    add_scaled(slipping, result);
  }
}

void BoxJacobian::put_scaled(const Elements& elements, const Elements& others, const VectorXf& v,
                             Eigen::Ref<VectorXf> result) const {
  for (const PreconditionedElement& e : others)
    put(e.number, Vector2f(0, 0));
  for (const PreconditionedElement& e : elements) {
    const Vector2f along = e.along * v.segment<2>(2 * e.number);
    result.segment<2>(2 * e.number) -= along;
    put(e.number, e.before * along);
  }
}

void BoxJacobian::add_scaled(const Elements& elements, Eigen::Ref<VectorXf> result) const {
  for (const PreconditionedElement& e : elements)
    result.segment<2>(2 * e.number) += e.after * (e.along * get(e.number));
}

} // namespace bem_contact::contact
