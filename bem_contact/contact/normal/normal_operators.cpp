#include "bem_contact/contact/normal/normal_operators.hpp"

#include "bem_contact/contact/normal/settings.hpp"

#include <algorithm>
#include <utility>

namespace bem_contact::contact {

NormalBox::NormalBox(const InfluenceNumbers& numbers, const Boxes& the_boxes, TransformPool* pool)
    : boxes(the_boxes), nn(numbers, boxes, {component_n}, {component_n}, pool), fast(nn, pool),
      inverse(numbers, Boxes{{boxes.boxes.front()}}, {component_n}, {component_n},
              BasicPlaneOperator<float>::Form::periodic, pool) {
  inverse.invert();
}

void NormalBox::invert(std::span<const float> in, std::span<float> out) const {
  const std::size_t n = boxes.boxes.front().size();
  for (int k = 0; k < boxes.count(); ++k)
    inverse.apply(in.subspan(k * n, n), out.subspan(k * n, n), 0);
}

void NormalBox::copy_to_grid(std::span<const double> from, int grid_mx, Eigen::VectorXd& field) const {
  const double* row = from.data();
  for (const Box& box : boxes.boxes)
    for (int is = 0; is < box.ms; ++is, row += box.mx)
      std::copy_n(row, box.mx, &field[static_cast<Eigen::Index>(box.first_s + is) * grid_mx + box.first_x]);
}

void NormalBoxVectors::resize(int size) {
  for (auto* v : {&p, &u})
    v->resize(size);
  for (auto* v : {&x, &r, &z, &d, &q})
    v->resize(size);
}

NormalOperators::NormalOperators(std::shared_ptr<TransformPool> pool) : pool_(std::move(pool)) {}

const StripOperator& NormalOperators::whole(const InfluenceNumbers& numbers, int mx, WorkBudget& work) {
  if (!whole_) {
    work.spend(spectra_work(numbers.translational, 1, numbers.rows, mx));
    whole_.emplace(numbers, mx, std::vector<int>{component_n}, std::vector<int>{component_n}, pool_.get());
  }
  return *whole_;
}

const NormalLines& NormalOperators::lines(const InfluenceNumbers& numbers, int mx) {
  if (!lines_)
    lines_.emplace(numbers, mx);
  return *lines_;
}

const NormalBox& NormalOperators::box_around(const std::vector<int>& elements,
                                             const InfluenceNumbers& numbers, const ContactGrid& grid,
                                             WorkBudget& work) {
  const bool same_columns = !numbers.translational;
  if (!box_ || !serve(box_->boxes, boxes_around(elements, grid, 0, same_columns), elements, grid.mx)) {
    const int margin = 1 + std::min(grid.mx, grid.ms) / normal_margin_divisor;
    const Boxes wider = boxes_around(elements, grid, margin, same_columns);
    work.spend(spectra_work(numbers.translational, 1, wider.rows(), wider.mx()));
    box_.emplace(numbers, wider, pool_.get());
    vectors_.resize(box_->boxes.size());
  }
  return *box_;
}

bool NormalOperators::solve_dense(const std::vector<int>& elements, const InfluenceNumbers& numbers, int mx,
                                  Eigen::MatrixXd& right) {
  const NormalLines& known = lines(numbers, mx);
  const bool serves = factor_ && (borders_ || factor_->factored() == elements);
  if (!serves || factor_->elements() != elements) {
    unit_ = {};
    if (!serves || !factor_->use_elements(known, elements))
      factor_.emplace(known, elements);
    if (!factor_->positive()) {
      factor_.reset();
      return false;
    }
  }
  borders_ = true;
  if (unit_.unit.size() == 0 || unit_.unit != right.col(1))
    unit_ = {right.col(1), factor_->solve(right.col(1))};
  right.col(0) = factor_->solve(right.col(0));
  right.col(1) = unit_.response;
  return true;
}

} // namespace bem_contact::contact
