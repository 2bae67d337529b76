#include "bem_contact/contact/tangential/gmres.hpp"

#include "bem_contact/contact/settings.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact::contact {

void Gmres::prepare(Eigen::Index unknowns, int most) {
  if (basis_.rows() != unknowns)
    basis_.resize(unknowns, std::min(first_gmres_basis, most + 1));
  if (h_.cols() < most) {
    h_.resize(most + 1, most);
    for (auto* v : {&g_, &cosine_, &sine_})
      v->resize(most + 1);
  }
  z_.resize(unknowns);
  w_.resize(unknowns);
  exhausted_ = false;
}

bool Gmres::orthogonalise(int k) {
  for (int i = 0; i <= k; ++i) {
    const float share = basis_.col(i).dot(z_);
    z_ -= share * basis_.col(i);
    h_(i, k) = share;
  }
  const double length = z_.norm();
  for (int i = 0; i < k; ++i) {
    const double upper = h_(i, k), lower = h_(i + 1, k);
    h_(i, k) = cosine_[i] * upper + sine_[i] * lower;
    h_(i + 1, k) = cosine_[i] * lower - sine_[i] * upper;
  }
  const double diagonal = std::hypot(h_(k, k), length);
  if (!(diagonal > 0))
    return false;
  cosine_[k] = h_(k, k) / diagonal;
  sine_[k] = length / diagonal;
  h_(k, k) = diagonal;
  g_[k + 1] = -sine_[k] * g_[k];
  g_[k] *= cosine_[k];
  exhausted_ = !(length > gmres_rounding * diagonal);
  basis_.col(k + 1) = z_ / static_cast<float>(length);
  return true;
}

void Gmres::combine(int k) {
  // the triangle, from below; cosine_ has done its work
  for (int i = k - 1; i >= 0; --i) {
    double sum = g_[i];
    for (int j = i + 1; j < k; ++j)
      sum -= h_(i, j) * cosine_[j];
    cosine_[i] = sum / h_(i, i);
  }
  w_.setZero();
  for (int i = 0; i < k; ++i)
    w_ += static_cast<float>(cosine_[i]) * basis_.col(i);
}

} // namespace bem_contact::contact
