#include "bem_contact/contact/tangential/step_box.hpp"

#include <algorithm>
#include <cstdlib>

namespace bem_contact::contact {

using Eigen::Matrix2d;
using Eigen::MatrixXd;

StepNumbers::StepNumbers(const InfluenceNumbers& numbers, int mx, const std::array<double, 3>& present)
    : mx_(mx), ms_(numbers.rows),
      values_(static_cast<std::size_t>(numbers.rows) * numbers.rows * 4 * (2 * mx - 1)) {
  std::size_t position = 0;
  for (int row_i = 0; row_i < ms_; ++row_i)
    for (int row_j = 0; row_j < ms_; ++row_j)
      for (int c = 0; c < 2; ++c)
        for (int d = 0; d < 2; ++d) {
          const auto a = [&](int m) {
            return (m < 0 ? parity(c, d) : 1) * numbers.at(std::abs(m), row_i, c, row_j, d);
          };
          for (int m = mx - 1; m > -mx; --m)
            values_[position++] = present[0] * a(m) + present[1] * a(m + 1) + present[2] * a(m + 2);
        }
}

Matrix2d step_number(const ContactProblem& problem, const std::array<double, 3>& present, int target,
                     int load) {
  const int mx = problem.grid.mx;
  Matrix2d block = Matrix2d::Zero();
  for (int k = 0; k <= rolling_columns; ++k) {
    if (present[k] == 0)
      continue;
    const int m = target % mx + k - load % mx;
    for (int c = 0; c < 2; ++c)
      for (int d = 0; d < 2; ++d)
        block(c, d) += present[k] * (m < 0 ? parity(c, d) : 1) *
                       problem.numbers.at(std::abs(m), target / mx, c, load / mx, d);
  }
  return block;
}

MatrixXd step_matrix(const ContactProblem& problem, const std::array<double, 3>& present,
                     const std::vector<int>& elements) {
  const int mx = problem.grid.mx;
  std::vector<int> rank(problem.grid.ms, -1), rows;
  int low = mx, high = 0;
  for (const int i : elements) {
    low = std::min(low, i % mx);
    high = std::max(high, i % mx);
    if (int& known = rank[i / mx]; known < 0) {
      known = static_cast<int>(rows.size());
      rows.push_back(i / mx);
    }
  }
  // The entries of two rows depend on the offset along x alone: each of them is computed once.
  const int most = high - low, each = 2 * most + 1;
  std::vector<Matrix2d> lines;
  lines.reserve(rows.size() * rows.size() * each);
  for (const int to : rows)
    for (const int from : rows)
      for (int m = -most; m <= most; ++m)
        lines.push_back(step_number(problem, present, to * mx + std::max(m, 0), from * mx + std::max(-m, 0)));
  const auto n = static_cast<Eigen::Index>(elements.size());
  MatrixXd matrix(2 * n, 2 * n);
  for (Eigen::Index b = 0; b < n; ++b)
    for (Eigen::Index a = 0; a < n; ++a) {
      const int target = elements[a], load = elements[b];
      const std::size_t pair = rank[target / mx] * rows.size() + rank[load / mx];
      matrix.block<2, 2>(2 * a, 2 * b) = lines[pair * each + target % mx - load % mx + most];
    }
  return matrix;
}

StepBox::StepBox(const InfluenceNumbers& numbers, const Boxes& boxes, const std::array<double, 3>& present,
                 TransformPool* pool)
    : boxes_(boxes), present_(present),
      tt_(numbers, boxes, {component_x, component_s}, {component_x, component_s}, pool), fast_(tt_, pool) {
  using Inverse = BasicPlaneOperator<float>;
  for (const int c : {component_x, component_s}) {
    const Inverse a(numbers, boxes.mx(), boxes.ms(), {c}, {c}, Inverse::Form::periodic,
                    boxes.boxes.front().first_s + boxes.ms() / 2, pool);
    for (auto* list : {&behind_, &ahead_, &periodic_})
      list->emplace_back(a);
    behind_.back().invert_factor(Inverse::Factor::behind);
    ahead_.back().invert_factor(Inverse::Factor::ahead);
  }
}

void StepBox::apply_each(const std::vector<BasicPlaneOperator<float>>& of, std::span<const float> from,
                         std::span<float> to) const {
  const std::size_t n = boxes_.boxes.front().size();
  for (std::size_t field = 0; field < from.size() / n; ++field)
    of[field / boxes_.boxes.size()].apply(from.subspan(field * n, n), to.subspan(field * n, n), 0);
}

template <class Real>
void StepBox::step_by(const BasicStripOperator<Real>& a, std::span<const Real> in,
                      std::span<Real> out) const {
  if (present_[1] != 0)
    return a.apply_step(in, out);
  a.apply(in, out);
  for (Real& v : out)
    v *= static_cast<Real>(present_[0]);
}

void StepBox::step(std::span<const double> in, std::span<double> out) const {
  step_by(tt_, in, out);
}

void StepBox::step(std::span<const float> in, std::span<float> out) const {
  step_by(fast_, in, out);
}

void StepBox::invert(const std::vector<char>& sticks, std::span<const float> in, std::span<float> out) const {
  const int mx = boxes_.mx();
  const std::size_t n = boxes_.size();
  const auto d0 = static_cast<float>(present_[0]), d1 = static_cast<float>(present_[1]),
             d2 = static_cast<float>(present_[2]);
  apply_each(behind_, in, out);
  for (const std::size_t c : {0, 1})
    for (int is = 0; is < boxes_.rows(); ++is) {
      float* to = &out[c * n];
      float u1 = 0, u2 = 0; // of the elements ahead, where they stick
      for (int i = (is + 1) * mx - 1; i >= is * mx; --i) {
        to[i] = sticks[i] ? (to[i] - d1 * u1 - d2 * u2) / d0 : 0.0f;
        u2 = u1;
        u1 = to[i];
      }
    }
  apply_each(ahead_, out, out);
  for (std::size_t i = 0; i < 2 * n; ++i)
    if (!sticks[i % n])
      out[i] = 0;
}

StepBox::DampedInverse::DampedInverse(const StepBox& box) {
  for (const auto& a : box.periodic_)
    inverse_.emplace_back(a);
}

void StepBox::DampedInverse::set(const StepBox& box, double shift, double stiffness) {
  for (const std::size_t c : {0, 1})
    inverse_[c].invert_shifted(box.periodic_[c], static_cast<float>(shift), static_cast<float>(stiffness),
                               box.present_);
}

void StepBox::DampedInverse::apply(const StepBox& box, std::span<const float> in,
                                   std::span<float> out) const {
  box.apply_each(inverse_, in, out);
}

StepBoxScratch::StepBoxScratch(const StepBox& box)
    : sticks(box.size()), in(2 * box.size()), out(2 * box.size()), fast_in(2 * box.size()),
      fast_out(2 * box.size()), damped(box) {}

} // namespace bem_contact::contact
