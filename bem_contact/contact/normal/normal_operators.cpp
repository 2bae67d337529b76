#include "bem_contact/contact/normal/normal_operators.hpp"

#include "bem_contact/contact/settings.hpp"
#include "bem_contact/influence/dense.hpp"

#include <algorithm>
#include <utility>

namespace bem_contact::contact {

NormalOperators::NormalOperators(std::shared_ptr<TransformPool> pool) : pool_(std::move(pool)) {}

const StripOperator& NormalOperators::whole(const InfluenceNumbers& numbers, int mx, WorkBudget& work) {
  if (!whole_) {
    work.spend(spectra_work(numbers.translational, 1, numbers.rows, mx));
    whole_.emplace(numbers, mx, std::vector<int>{component_n}, std::vector<int>{component_n}, RowRange{},
                   pool_.get());
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
  if (factor_ && factor_->elements == elements) {
    solve_factored(factor_->factor, right);
    return true;
  }
  factor_.reset();
  Eigen::MatrixXd factor = lines(numbers, mx).block(elements);
  if (!solve_cholesky(factor, right))
    return false;
  factor_.emplace(elements, std::move(factor));
  return true;
}

} // namespace bem_contact::contact
