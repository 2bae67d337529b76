#pragma once

#include "bem_contact/contact/tangential/linearisation.hpp"
#include "bem_contact/contact/tangential/step_box.hpp"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace bem_contact::contact {

/// Newton's matrix of one linearisation on a StepBox, and an approximate inverse of it, in single precision,
/// for GCR. The projection M of an element is the identity if it sticks, and m t t' if it slips, t along its
/// bound. An element that nearly sticks (m above counts_as_sticking) counts as sticking along t.
class BoxJacobian {
public:
  /// `local`: places of the elements on the boxes. What is given outlives this.
  BoxJacobian(const StepBox& box, const std::vector<int>& local, std::span<const NewtonElement> elements,
              StepBoxScratch& scratch);

  /// B v
  void product(Eigen::Ref<const Eigen::VectorXf> v, Eigen::Ref<Eigen::VectorXf> result) const;
  /// About J^-1 v: r B inverted where it sticks, the damped matrix where it slips; across the bound J is the
  /// identity.
  void precondition(const Eigen::VectorXf& v, Eigen::Ref<Eigen::VectorXf> result) const;

private:
  void put(std::size_t a, const Eigen::Vector2f& v) const {
    scratch_.fast_in[local_[a]] = v[0];
    scratch_.fast_in[n_ + local_[a]] = v[1];
  }
  Eigen::Vector2f get(std::size_t a) const {
    return {scratch_.fast_out[local_[a]], scratch_.fast_out[n_ + local_[a]]};
  }
  using Elements = std::vector<PreconditionedElement>;
  /// Of `elements` what is inverted, taken off `result`; 0 of the others.
  void put_scaled(const Elements& elements, const Elements& others, const Eigen::VectorXf& v,
                  Eigen::Ref<Eigen::VectorXf> result) const;
  void add_scaled(const Elements& elements, Eigen::Ref<Eigen::VectorXf> result) const;

  const StepBox& box_;
  const std::vector<int>& local_;
  StepBoxScratch& scratch_;
  std::size_t n_;
  bool damped_ = false;
};

} // namespace bem_contact::contact
