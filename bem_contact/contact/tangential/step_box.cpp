#include "bem_contact/contact/tangential/step_box.hpp"

#include <algorithm>
#include <cstdlib>

namespace bem_contact::contact {

StepNumbers::StepNumbers(const InfluenceNumbers& numbers, const std::vector<int>& rows, int columns,
                         const std::array<double, 3>& present)
    : rows_(static_cast<int>(rows.size())), columns_(columns), values_(start(rows_, 0, 0, 0)) {
  std::size_t position = 0;
  for (const int row_i : rows)
    for (const int row_j : rows)
      for (int c = 0; c < 2; ++c)
        for (int d = 0; d < 2; ++d) {
          const auto a = [&](int m) {
            return (m < 0 ? parity(c, d) : 1) * numbers.at(std::abs(m), row_i, c, row_j, d);
          };
          for (int m = columns - 1; m > -columns; --m)
            values_[position++] = present[0] * a(m) + present[1] * a(m + 1) + present[2] * a(m + 2);
        }
}

ElementPlaces::ElementPlaces(const std::vector<int>& elements, int mx) : first_column(mx), columns(0) {
  std::vector<int> rank;
  int last = 0;
  for (const int i : elements) {
    const std::size_t grid_row = i / mx;
    if (grid_row >= rank.size())
      rank.resize(grid_row + 1, -1);
    if (rank[grid_row] < 0) {
      rank[grid_row] = static_cast<int>(rows.size());
      rows.push_back(i / mx);
    }
    row.push_back(rank[grid_row]);
    column.push_back(i % mx);
    first_column = std::min(first_column, i % mx);
    last = std::max(last, i % mx);
  }
  columns = elements.empty() ? 0 : last - first_column + 1;
  for (int& ix : column)
    ix -= first_column;
}

StepBox::StepBox(const InfluenceNumbers& numbers, const Boxes& boxes, const std::array<double, 3>& present,
                 TransformPool* pool)
    : boxes_(boxes), present_(present),
      tt_(numbers, boxes, {component_x, component_s}, {component_x, component_s}, pool), fast_(tt_, pool),
      fast_has_steps_(fast_.change_to_steps(present)) {
  using Inverse = BasicPlaneOperator<float>;
  for (const int c : {component_x, component_s}) {
    periodic_.emplace_back(numbers, Boxes{{boxes.boxes.front()}}, std::vector{c}, std::vector{c},
                           Inverse::Form::periodic, pool);
    behind_.emplace_back(periodic_.back()).invert_behind();
    ahead_.emplace_back(behind_.back()).mirror();
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
  if (fast_has_steps_)
    return fast_.apply(in, out);
  step_by(fast_, in, out);
}

void StepBox::invert(const std::vector<char>& sticks, std::span<const float> in, std::span<float> out) const {
  const int mx = boxes_.mx();
  const std::size_t n = boxes_.size();
  // Each element waits for the one before: a division there would take most of the time.
  const auto own = static_cast<float>(1 / present_[0]), first = static_cast<float>(present_[1] / present_[0]),
             second = static_cast<float>(present_[2] / present_[0]);
  apply_each(behind_, in, out);
  for (const std::size_t c : {0, 1})
    for (int is = 0; is < boxes_.rows(); ++is) {
      float* to = &out[c * n];
      float u1 = 0, u2 = 0; // of the elements ahead, where they stick
      for (int i = (is + 1) * mx - 1; i >= is * mx; --i) {
        to[i] = sticks[i] ? (own * to[i] - second * u2) - first * u1 : 0.0f;
        u2 = u1;
        u1 = to[i];
      }
    }
  apply_each(ahead_, out, out);
  for (const std::size_t c : {0, 1})
    for (std::size_t i = 0; i < n; ++i)
      out[c * n + i] = sticks[i] ? out[c * n + i] : 0.0f;
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
