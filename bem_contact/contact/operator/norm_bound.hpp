#pragma once

#include "bem_contact/contact/operator/settings.hpp"

#include <Eigen/Core>

namespace bem_contact::contact {

/// Upper bound of the largest eigenvalue of a symmetric operator on `size` unknowns, by power iteration with
/// a margin. apply(v) returns the product as a VectorXd. It is called power_iterations times, first with a
/// vector that has no zero component.
template <class Apply> double norm_bound(Eigen::Index size, const Apply& apply) {
  Eigen::VectorXd v = Eigen::VectorXd::LinSpaced(size, 1.0, 1.5);
  double norm = 0;
  for (int k = 0; k < power_iterations; ++k) {
    v.normalize();
    v = apply(v);
    norm = v.norm();
  }
  return norm_margin * norm;
}

} // namespace bem_contact::contact
