#include "bem_contact/contact/tangential/gcr.hpp"

#include "bem_contact/contact/tangential/settings.hpp"
#include "bem_contact/influence/column_loops.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace bem_contact::contact {

using Eigen::VectorXd;

namespace {

/// Directions for which memory is taken at first; it grows where that is not enough. Chosen.
constexpr int first_directions = 32;

/// Directions that serve all right sides; with more it begins anew, since to make the next one orthogonal to
/// them would take longer than its product. Chosen.
constexpr int most_all_directions = 500;

/// 1. Where less is left of an image it is made orthogonal once more. Single precision then still has five
/// digits, one more than any system is solved to.
constexpr float little_left = 0.02f;

} // namespace

void Gcr::use_elements(const std::vector<int>& elements) {
  if (elements == elements_)
    return;
  elements_ = elements;
  forget();
}

void Gcr::forget() {
  is_kept_.assign(is_kept_.size(), 0);
  oldest_ = used_ = 0;
}

void Gcr::begin(const VectorXd& rhs, const Border& border) {
  const Eigen::Index further = border.columns.cols();
  if (residual_.size() != rhs.size()) {
    const bool recycles = static_cast<int>(elements_.size()) <= most_recycling_elements;
    is_kept_.assign(recycles ? keeps_.solutions + keeps_.directions : 0, 0);
    for (auto* m : {&kept_z_, &kept_bz_})
      m->resize(rhs.size(), static_cast<Eigen::Index>(is_kept_.size()));
    for (auto* m : {&z_, &bz_, &q_})
      m->resize(rhs.size(), first_directions);
    image_.resize(rhs.size());
  }
  for (auto* m : {&answers_, &b_answers_, &missed_})
    m->resize(rhs.size(), further);
  y_.resize(further, z_.cols());
  const auto norm = [](const Eigen::MatrixXd& m) { return m.norm() > 0 ? m.norm() : 1.0; };
  of_columns_ = norm(border.columns);
  of_rows_ = norm(border.rows);
  columns_ = (border.columns / of_columns_).cast<float>();
  rows_ = (border.rows / of_rows_).cast<float>();
  residual_.resize(rhs.size());
  left_ = least_left_ = 1;
  candidate_ = without_fall_ = 0;
  if (!keeps_all_ || used_ > most_all_directions)
    used_ = 0;
  g_.head(used_).setZero();
  stalled_ = false;
}

/// The start that fulfils the border's equations, and its residual. False if nothing is left to do.
bool Gcr::set_start(const VectorXd& rhs, const Border& border) {
  length_ = rhs.norm();
  if (columns_.cols() > 0) {
    sums_.compute((rows_.transpose() * answers_).cast<double>());
    start_ = sums_.solve(border.sums / of_rows_);
    length_ = std::hypot(length_, start_.norm());
  }
  if (!(length_ > 0) || !std::isfinite(length_))
    return false;
  residual_ = (rhs / length_).cast<float>(); // numbers beyond those of single precision are none over length
  if (columns_.cols() > 0)
    residual_ -= missed_ * (start_ / length_).cast<float>();
  left_ = least_left_ = residual_.norm();
  return true;
}

/// Adds so much of the answers to the next direction that its sums are 0.
void Gcr::constrain(bool with_product) {
  if (columns_.cols() == 0)
    return;
  y_.col(used_) = -sums_.solve((rows_.transpose() * z_.col(used_)).cast<double>()).cast<float>();
  z_.col(used_) += answers_ * y_.col(used_);
  if (with_product)
    bz_.col(used_) += b_answers_ * y_.col(used_);
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

/// Takes what the directions of former right sides can off the residual.
void Gcr::take_former_directions() {
  if (used_ == 0)
    return;
  const Eigen::Index n = residual_.size();
  dot_columns(q_.data(), n, used_, residual_.data(), share_.data(), n);
  g_.head(used_) = share_.head(used_).cast<double>();
  share_.head(used_) *= -1;
  add_columns(q_.data(), n, used_, share_.data(), residual_.data(), n);
  left_ = least_left_ = residual_.norm();
}

void Gcr::make_room() {
  if (used_ >= z_.cols())
    for (auto* m : {&z_, &bz_, &q_})
      m->conservativeResize(Eigen::NoChange, 2 * used_);
  if (y_.cols() < z_.cols())
    y_.conservativeResize(Eigen::NoChange, z_.cols());
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
    dot_columns(q_.data(), n, used_, image_.data(), share_.data(), n);
    h_.col(used_).head(used_) += share_.head(used_);
    share_.head(used_) *= -1;
    add_columns(q_.data(), n, used_, share_.data(), image_.data(), n);
    const float left = image_.norm();
    if (left > little_left * std::exchange(length, left))
      break;
  }
  if (!(length > (kept ? least_new_kept_share : least_new_share) * before))
    return false;
  h_(used_, used_) = length;
  q_.col(used_) = image_ / length;
  dot_columns(&q_(0, used_), n, 1, residual_.data(), share_.data(), n);
  g_[used_] = share_[0];
  residual_ -= share_[0] * q_.col(used_);
  left_ = residual_.norm();
  ++used_;
  return true;
}

/// The solution, from the triangle; and what is kept for the next system.
void Gcr::finish(BorderedSolution& solution) {
  for (int i = used_ - 1; i >= 0; --i) {
    double sum = g_[i];
    for (int j = i + 1; j < used_; ++j)
      sum -= static_cast<double>(h_(i, j)) * g_[j];
    g_[i] = sum / h_(i, i);
  }
  share_.head(used_) = g_.head(used_).cast<float>();
  image_.setZero();
  add_columns(z_.data(), image_.size(), used_, share_.data(), image_.data(), image_.size());
  solution.x = length_ * image_.cast<double>();
  if (answers_.cols() > 0) {
    solution.x += answers_.cast<double>() * start_;
    solution.y = (start_ + length_ * (y_.leftCols(used_) * share_.head(used_)).cast<double>()) / of_columns_;
  } else
    solution.y.resize(0);
  keep_solution();
}

/// image_ is the solution without the start.
void Gcr::keep_solution() {
  if (is_kept_.empty() || used_ == 0 || keeps_all_)
    return;
  residual_.setZero();
  add_columns(bz_.data(), residual_.size(), used_, share_.data(), residual_.data(), residual_.size());
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
