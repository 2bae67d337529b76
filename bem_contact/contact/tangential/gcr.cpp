#include "bem_contact/contact/tangential/gcr.hpp"

#include "bem_contact/base/simd.hpp"
#include "bem_contact/contact/tangential/settings.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace bem_contact::contact {
namespace {

constexpr int lanes = 16; ///< sums side by side, for wide registers
/// 1. Where less is left of an image it is made orthogonal once more. Single precision then still has five
/// digits, one more than any system is solved to.
constexpr float little_left = 0.02f;

/// share = q^T w
BEM_CONTACT_WIDE void shares_of(const float* __restrict q, std::ptrdiff_t n, int columns,
                                const float* __restrict w, float* __restrict share) {
  for (int k = 0; k < columns; ++k, q += n) {
    float sums[lanes] = {};
    std::ptrdiff_t i = 0;
    for (; i + lanes <= n; i += lanes)
      for (int l = 0; l < lanes; ++l)
        sums[l] += q[i + l] * w[i + l];
    float sum = 0;
    for (; i < n; ++i)
      sum += q[i] * w[i];
    for (int l = 0; l < lanes; ++l)
      sum += sums[l];
    share[k] = sum;
  }
}

/// w += q share
BEM_CONTACT_WIDE void add_columns(const float* __restrict q, std::ptrdiff_t n, int columns,
                                  const float* __restrict share, float* __restrict w) {
  int k = 0;
  for (; k + 4 <= columns; k += 4, q += 4 * n) { // one pass over w for four
    const float a = share[k], b = share[k + 1], c = share[k + 2], d = share[k + 3];
    const float *q1 = q + n, *q2 = q1 + n, *q3 = q2 + n;
    for (std::ptrdiff_t i = 0; i < n; ++i)
      w[i] += a * q[i] + b * q1[i] + c * q2[i] + d * q3[i];
  }
  for (; k < columns; ++k, q += n)
    for (std::ptrdiff_t i = 0; i < n; ++i)
      w[i] += share[k] * q[i];
}

} // namespace

void Gcr::use_elements(const std::vector<int>& elements) {
  if (elements == elements_)
    return;
  elements_ = elements;
  forget();
}

void Gcr::forget() {
  is_kept_.assign(is_kept_.size(), 0);
  oldest_ = 0;
}

void Gcr::begin(const Eigen::VectorXd& rhs, double length) {
  if (residual_.size() != rhs.size()) {
    const bool recycles = static_cast<int>(elements_.size()) <= most_recycling_elements;
    is_kept_.assign(recycles ? keeps_.solutions + keeps_.directions : 0, 0);
    for (auto* m : {&kept_z_, &kept_bz_})
      m->resize(rhs.size(), static_cast<Eigen::Index>(is_kept_.size()));
    for (auto* m : {&z_, &bz_, &q_})
      m->resize(rhs.size(), first_directions);
    image_.resize(rhs.size());
  }
  residual_ = (rhs / length).cast<float>();
  left_ = least_left_ = 1;
  used_ = candidate_ = without_fall_ = 0;
  stalled_ = false;
}

/// Whether the residual is near the tolerance and single precision has no more digits to come nearer.
bool Gcr::stalls(double tolerance) {
  const bool falls = left_ < (1 - stalled_share) * least_left_ || left_ > stalled_near * tolerance;
  without_fall_ = falls ? 0 : without_fall_ + 1;
  if (falls)
    least_left_ = left_;
  stalled_ = without_fall_ >= stalled_products;
  return stalled_;
}

/// Makes the next that was kept direction number `used`. False at the end.
bool Gcr::next_kept() {
  while (candidate_ < static_cast<int>(is_kept_.size())) {
    const int column = candidate_++;
    if (!is_kept_[column])
      continue;
    make_room();
    z_.col(used_) = kept_z_.col(column);
    bz_.col(used_) = kept_bz_.col(column);
    return true;
  }
  from_kept_ = used_;
  return false;
}

void Gcr::make_room() {
  if (used_ >= z_.cols())
    for (auto* m : {&z_, &bz_, &q_})
      m->conservativeResize(Eigen::NoChange, 2 * used_);
  if (h_.cols() >= z_.cols())
    return;
  h_.conservativeResize(z_.cols(), z_.cols());
  g_.conservativeResize(z_.cols());
  share_.resize(z_.cols());
}

/// Makes the image the next column of q, orthogonal to those before, and takes its share off the residual.
bool Gcr::take_image(bool kept) {
  const Eigen::Index n = image_.size();
  const float before = image_.norm();
  float length = before;
  h_.col(used_).head(used_).setZero();
  for (int pass = 0; pass < 2; ++pass) { // twice is enough (Parlett 1980)
    shares_of(q_.data(), n, used_, image_.data(), share_.data());
    h_.col(used_).head(used_) += share_.head(used_);
    share_.head(used_) *= -1;
    add_columns(q_.data(), n, used_, share_.data(), image_.data());
    const float left = image_.norm();
    if (left > little_left * std::exchange(length, left))
      break;
  }
  if (!(length > (kept ? least_new_kept_share : least_new_share) * before))
    return false;
  h_(used_, used_) = length;
  q_.col(used_) = image_ / length;
  shares_of(&q_(0, used_), n, 1, residual_.data(), share_.data());
  g_[used_] = share_[0];
  residual_ -= share_[0] * q_.col(used_);
  left_ = residual_.norm();
  ++used_;
  return true;
}

/// x, from the triangle; and what is kept for the next system.
void Gcr::finish(double length, Eigen::VectorXd& x) {
  for (int i = used_ - 1; i >= 0; --i) {
    double sum = g_[i];
    for (int j = i + 1; j < used_; ++j)
      sum -= static_cast<double>(h_(i, j)) * g_[j];
    g_[i] = sum / h_(i, i);
  }
  share_.head(used_) = g_.head(used_).cast<float>();
  image_.setZero();
  add_columns(z_.data(), image_.size(), used_, share_.data(), image_.data());
  x = length * image_.cast<double>();
  if (is_kept_.empty() || used_ == 0)
    return;
  residual_.setZero();
  add_columns(bz_.data(), residual_.size(), used_, share_.data(), residual_.data());
  keep(oldest_, image_, residual_);
  oldest_ = (oldest_ + 1) % keeps_.solutions;
  for (int i = 0; i < std::min(keeps_.directions, used_ - from_kept_); ++i)
    keep(keeps_.solutions + i, z_.col(used_ - 1 - i), bz_.col(used_ - 1 - i));
}

void Gcr::keep(int column, const Eigen::Ref<const Vector>& z, const Eigen::Ref<const Vector>& bz) {
  kept_z_.col(column) = z;
  kept_bz_.col(column) = bz;
  is_kept_[column] = 1;
}

} // namespace bem_contact::contact
